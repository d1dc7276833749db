#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <string>

#include "core/base/error.h"
#include "core/io/volume_reader.h"
#include "core/volume/volume.h"

namespace lacuna::test {

/// A fresh folder that is removed with its content.
class ScratchFolder {
public:
    ScratchFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "lacuna-io-XXXXXX").string();
        if (!::mkdtemp(name.data())) throw std::runtime_error("cannot make a temporary folder");
        path_ = name;
    }
    ~ScratchFolder() {
        std::error_code ec;
        std::filesystem::remove_all(path_, ec);
    }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }
    std::size_t entries() const {
        return std::size_t(
            std::distance(std::filesystem::directory_iterator(path_), std::filesystem::directory_iterator()));
    }

private:
    std::filesystem::path path_;
};

inline void put_file(const std::filesystem::path& file, std::string_view bytes) {
    std::ofstream(file, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
}

inline std::string get_file(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// An oblique, anisotropic, off-centre grid: no two axes can be mixed up unnoticed.
inline GridGeometry oblique_grid(glm::ivec3 size) {
    GridGeometry g;
    g.size = size;
    g.spacing = {0.7, 1.25, 5.0};
    g.origin = {-31.5, 12.25, 100.125};
    const glm::dmat4 turn =
        glm::rotate(glm::rotate(glm::dmat4(1), 0.3, glm::dvec3(0, 0, 1)), -0.7, glm::normalize(glm::dvec3(1, 0.2, 0)));
    g.direction = glm::dmat3(turn);
    return g;
}

/// Values that reach both ends of the type and differ from neighbour to neighbour.
template <class T>
Volume extreme_volume(const GridGeometry& geometry) {
    return make_volume<T>(geometry, [](std::span<T> voxels) {
        for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = T((i * 2654435761u) >> 7);
        voxels.front() = std::numeric_limits<T>::lowest();
        voxels.back() = std::numeric_limits<T>::max();
    });
}

template <>
inline Volume extreme_volume<float>(const GridGeometry& geometry) {
    return make_volume<float>(geometry, [](std::span<float> voxels) {
        for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = std::sin(float(i)) * 1e3f;
        voxels.front() = -3.4e38f;
        voxels.back() = 1e-30f;
    });
}

inline Volume extreme_volume(VoxelType type, const GridGeometry& geometry) {
    return visit_type(type, [&](auto tag) { return extreme_volume<decltype(tag)>(geometry); });
}

inline void expect_same_geometry(const GridGeometry& a, const GridGeometry& b, double tolerance_mm) {
    ASSERT_EQ(a.size, b.size);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 v(corner & 1 ? a.size.x : 0, corner & 2 ? a.size.y : 0, corner & 4 ? a.size.z : 0);
        const double off = glm::length(a.voxel_to_mm(v) - b.voxel_to_mm(v));
        EXPECT_TRUE(off <= tolerance_mm) << "corner " << corner << " is off by " << off << " mm";
    }
}

inline void expect_same_voxels(const Volume& a, const Volume& b) {
    ASSERT_EQ(name_of(a.type()), name_of(b.type()));
    ASSERT_EQ(a.bytes(), b.bytes());
    EXPECT_EQ(voxel_sha256(a), voxel_sha256(b));
}

/// The error a call throws must have this code and one line that holds every one of the words.
template <class Fn>
void expect_error(Errc code, std::initializer_list<std::string> words, Fn&& fn) {
    try {
        fn();
        ADD_FAILURE() << "nothing was thrown";
    } catch (const Error& e) {
        EXPECT_EQ(int(e.code()), int(code)) << e.what();
        const std::string text = e.what();
        for (const std::string& word : words)
            EXPECT_NE(text.find(word), std::string::npos) << word << " is not in: " << text;
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    }
}

inline bool has_warning(const Volume& volume, const std::string& words) {
    for (const Warning& w : volume.warnings)
        if (w.text.find(words) != std::string::npos) return true;
    return false;
}

}  // namespace lacuna::test
