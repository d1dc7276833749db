#include "core/io/mesh_writer.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <string>

#include "core/base/error.h"
#include "core/io/output_file.h"
#include "core/io/text_fields.h"

namespace lacuna {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "binary meshes are written as they lie in memory");

namespace {

constexpr std::size_t k_flush_bytes = std::size_t(4) << 20;

/// Collects small pieces and hands them on in large ones.
class Buffered {
public:
    explicit Buffered(OutputFile& file) : file_(file) {}
    template <class T>
    void value(T v) {
        char bytes[sizeof(T)];
        std::memcpy(bytes, &v, sizeof(T));
        text_.append(bytes, sizeof(T));
    }
    void vector(const glm::dvec3& v) {
        for (int a = 0; a < 3; ++a) value(float(v[a]));
    }
    template <class... Arguments>
    void print(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
        flush_if_long();
    }
    void flush_if_long() {
        if (text_.size() >= k_flush_bytes) flush();
    }
    void flush() {
        file_.write(text_);
        text_.clear();
    }

private:
    OutputFile& file_;
    std::string text_;
};

glm::dvec3 normal_of(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& t) {
    const glm::dvec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double length = glm::length(n);
    return length > 0 ? n / length : glm::dvec3(0);
}

void write_stl(const TriangleMesh& mesh, Buffered& out) {
    char head[80] = "Binary STL, millimetres, LPS axes";  // must not start with "solid"
    for (const char c : head) out.value(c);
    out.value(std::uint32_t(mesh.triangles.size()));
    for (const auto& t : mesh.triangles) {
        out.vector(normal_of(mesh, t));
        for (const std::uint32_t v : t) out.vector(mesh.vertices[v]);
        out.value(std::uint16_t(0));
        out.flush_if_long();
    }
}

void write_ply(const TriangleMesh& mesh, Buffered& out) {
    out.print(
        "ply\nformat binary_little_endian 1.0\ncomment millimetres, LPS axes\nelement vertex {}\nproperty float x\n"
        "property float y\nproperty float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
        mesh.vertices.size(), mesh.triangles.size());
    for (const glm::dvec3& v : mesh.vertices) {
        out.vector(v);
        out.flush_if_long();
    }
    for (const auto& t : mesh.triangles) {
        out.value(std::uint8_t(3));
        for (const std::uint32_t v : t) out.value(std::int32_t(v));
        out.flush_if_long();
    }
}

void write_obj(const TriangleMesh& mesh, Buffered& out) {
    out.print("# millimetres, LPS axes\n");
    for (const glm::dvec3& v : mesh.vertices) out.print("v {:.9g} {:.9g} {:.9g}\n", v.x, v.y, v.z);
    for (const auto& t : mesh.triangles) out.print("f {} {} {}\n", t[0] + 1ull, t[1] + 1ull, t[2] + 1ull);
}

void write_vtp(const TriangleMesh& mesh, Buffered& out) {
    out.print(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n<PolyData>\n"
        "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
        "NumberOfPolys=\"{}\">\n"
        "<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n",
        mesh.vertices.size(), mesh.triangles.size());
    for (const glm::dvec3& v : mesh.vertices) out.print("{:.12g} {:.12g} {:.12g}\n", v.x, v.y, v.z);
    out.print("</DataArray>\n</Points>\n<Polys>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n");
    for (const auto& t : mesh.triangles) out.print("{} {} {}\n", t[0], t[1], t[2]);
    out.print("</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n");
    for (std::size_t i = 1; i <= mesh.triangles.size(); ++i) out.print("{}\n", 3 * i);
    out.print("</DataArray>\n</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n");
}

void check_indices(const TriangleMesh& mesh, const fs::path& target) {
    constexpr std::size_t k_limit = 0x7fffffff;  // PLY's signed index and STL's count
    if (mesh.triangles.size() > k_limit || mesh.vertices.size() > k_limit)
        throw Error(Errc::unsupported, "Cannot write " + target.string() + ": the mesh has over 2147483647 elements.");
    for (const auto& t : mesh.triangles)
        for (const std::uint32_t v : t)
            if (v >= mesh.vertices.size())
                throw Error(Errc::bad_input,
                            "Cannot write " + target.string() + ": a triangle names a vertex that is not there.");
}

}  // namespace

void write_mesh(const TriangleMesh& mesh, const fs::path& target) {
    static constexpr std::pair<std::string_view, void (*)(const TriangleMesh&, Buffered&)> k_formats[] = {
        {".stl", write_stl}, {".ply", write_ply}, {".obj", write_obj}, {".vtp", write_vtp}};
    const std::string ending = lower_case(target.extension().string());
    for (const auto& [name, write] : k_formats) {
        if (ending != name) continue;
        check_indices(mesh, target);
        OutputFile file(target);
        Buffered out(file);
        write(mesh, out);
        out.flush();
        file.commit();
        return;
    }
    throw Error(Errc::bad_usage, "Cannot write " + target.string() +
                                     ": its ending names no mesh format; known are .stl, .ply, .obj and .vtp.");
}

}  // namespace lacuna
