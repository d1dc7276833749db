#include "core/io/mesh_writer.h"

#include <cstring>
#include <sstream>

#include "volume_fixture.h"

using namespace lacuna;
using namespace lacuna::test;

namespace {

TriangleMesh tetrahedron() {
    return {{{0, 0, 0}, {1.5, 0, 0}, {0, 2.25, 0}, {-3, 0.125, 1e-3}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

template <class T>
T take(const std::string& bytes, std::size_t& at) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof(T));
    at += sizeof(T);
    return value;
}

glm::dvec3 take_vector(const std::string& bytes, std::size_t& at) {
    const float x = take<float>(bytes, at), y = take<float>(bytes, at), z = take<float>(bytes, at);
    return {x, y, z};
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b) { EXPECT_LE(glm::length(a - b), 1e-6); }

std::string written(const TriangleMesh& mesh, const std::string& name) {
    const ScratchFolder folder;
    write_mesh(mesh, folder / name);
    EXPECT_EQ(folder.entries(), 1u);
    return get_file(folder / name);
}

}  // namespace

TEST(MeshWriter, StlHoldsEveryTriangleWithItsNormal) {
    const TriangleMesh mesh = tetrahedron();
    const std::string bytes = written(mesh, "m.stl");
    ASSERT_EQ(bytes.size(), 84 + 50 * mesh.triangles.size());
    EXPECT_NE(bytes.substr(0, 5), "solid") << "would be taken for ASCII";
    std::size_t at = 80;
    ASSERT_EQ(take<std::uint32_t>(bytes, at), mesh.triangles.size());
    for (const auto& t : mesh.triangles) {
        const glm::dvec3 normal = take_vector(bytes, at);
        const auto& v = mesh.vertices;
        EXPECT_GT(glm::dot(normal, glm::cross(v[t[1]] - v[t[0]], v[t[2]] - v[t[0]])), 0);
        EXPECT_NEAR(glm::length(normal), 1, 1e-6);
        for (const auto i : t) expect_near(take_vector(bytes, at), v[i]);
        at += 2;
    }
}

TEST(MeshWriter, PlyHoldsVerticesAndIndices) {
    const TriangleMesh mesh = tetrahedron();
    const std::string bytes = written(mesh, "m.ply");
    EXPECT_NE(bytes.find("element vertex 4\n"), std::string::npos);
    EXPECT_NE(bytes.find("element face 4\n"), std::string::npos);
    std::size_t at = bytes.find("end_header\n") + 11;
    for (const auto& v : mesh.vertices) expect_near(take_vector(bytes, at), v);
    for (const auto& t : mesh.triangles) {
        EXPECT_EQ(take<std::uint8_t>(bytes, at), 3);
        for (const auto i : t) EXPECT_EQ(take<std::int32_t>(bytes, at), std::int32_t(i));
    }
    EXPECT_EQ(at, bytes.size());
}

TEST(MeshWriter, ObjCountsFromOne) {
    const TriangleMesh mesh = tetrahedron();
    std::istringstream in(written(mesh, "m.obj"));
    std::vector<glm::dvec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        glm::dvec3 v;
        std::array<std::uint32_t, 3> t;
        if (kind == "v" && words >> v.x >> v.y >> v.z) vertices.push_back(v);
        if (kind == "f" && words >> t[0] >> t[1] >> t[2]) triangles.push_back({t[0] - 1, t[1] - 1, t[2] - 1});
    }
    ASSERT_EQ(vertices.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) expect_near(vertices[i], mesh.vertices[i]);
    EXPECT_EQ(triangles, mesh.triangles);
}

TEST(MeshWriter, VtpHoldsPointsAndConnectivity) {
    const TriangleMesh mesh = tetrahedron();
    const std::string text = written(mesh, "m.vtp");
    const auto numbers_after = [&](const std::string& mark) {
        const auto from = text.find('>', text.find(mark)) + 1;
        std::istringstream in(text.substr(from, text.find("</DataArray>", from) - from));
        return std::vector<double>(std::istream_iterator<double>(in), {});
    };
    const auto points = numbers_after("Float64"), indices = numbers_after("connectivity"),
               ends = numbers_after("offsets");
    ASSERT_EQ(points.size(), 12u);
    for (std::size_t i = 0; i < 4; ++i)
        expect_near({points[3 * i], points[3 * i + 1], points[3 * i + 2]}, mesh.vertices[i]);
    ASSERT_EQ(indices.size(), 12u);
    for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(indices[i], mesh.triangles[i / 3][i % 3]);
    EXPECT_EQ(ends, (std::vector<double>{3, 6, 9, 12}));
}

TEST(MeshWriter, AnEmptyMeshIsAValidFile) {
    EXPECT_EQ(written({}, "m.stl").size(), 84u);
    for (const char* name : {"m.ply", "m.obj", "m.vtp"}) EXPECT_FALSE(written({}, name).empty());
}

TEST(MeshWriter, FaultsAreNamedAndNothingIsWritten) {
    const ScratchFolder folder;
    expect_error(Errc::bad_usage, {"m.xyz", ".stl", ".vtp"}, [&] { write_mesh(tetrahedron(), folder / "m.xyz"); });
    expect_error(Errc::io, {"none"}, [&] { write_mesh(tetrahedron(), folder / "none/m.stl"); });
    TriangleMesh bad = tetrahedron();
    bad.triangles[0][1] = 4;
    expect_error(Errc::bad_input, {"vertex"}, [&] { write_mesh(bad, folder / "m.stl"); });
    EXPECT_EQ(folder.entries(), 0u);
}
