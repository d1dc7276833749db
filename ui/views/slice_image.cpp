#include "ui/views/slice_image.h"

#include <algorithm>

namespace lacuna::ui {

namespace {

/// Linear indices of a slice's first pixel and of one step across and down.
struct Walk {
    std::int64_t first, across, down;
    Walk(const GridGeometry& geometry, const SlicePlane& plane, int index) {
        const std::int64_t stride[3] = {1, geometry.size.x, std::int64_t(geometry.size.x) * geometry.size.y};
        const std::int64_t w = stride[plane.w], u = stride[plane.u], v = stride[plane.v];
        first = index * w + (plane.flip_u ? (geometry.size[plane.u] - 1) * u : 0) +
                (plane.flip_v ? (geometry.size[plane.v] - 1) * v : 0);
        across = plane.flip_u ? -u : u;
        down = plane.flip_v ? -v : v;
    }
};

template <class T>
void draw_grey(const T* voxels, const Walk& walk, ValueRange window, QImage& image) {
    const double scale = window.width() > 0 ? 255.0 / window.width() : 0;
    for (int y = 0; y < image.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        const T* voxel = voxels + walk.first + y * walk.down;
        for (int x = 0; x < image.width(); ++x, voxel += walk.across) {
            const double level = scale > 0 ? (double(*voxel) - window.lo) * scale : (*voxel > window.lo ? 255 : 0);
            const int grey = level > 0 ? int(std::min(level, 255.0) + 0.5) : 0;  // NaN compares false: black
            line[x] = qRgb(grey, grey, grey);
        }
    }
}

QRgb blend(QRgb under, QRgb tint) {
    const int grey = qRed(under);
    return qRgb((grey + 2 * qRed(tint)) / 3, (grey + 2 * qGreen(tint)) / 3, (grey + 2 * qBlue(tint)) / 3);
}

void draw_overlay(const SliceOverlay& overlay, const Walk& walk, QImage& image) {
    const std::uint32_t* labels = overlay.labels->labels->data();
    const QRgb chosen = overlay.color.rgb();
    const std::size_t tinted = overlay.tints ? overlay.tints->size() : 0;
    for (int y = 0; y < image.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        const std::uint32_t* label = labels + walk.first + y * walk.down;
        for (int x = 0; x < image.width(); ++x, label += walk.across) {
            if (*label == 0) continue;
            if (*label == overlay.id)
                line[x] = blend(line[x], chosen);
            else if (*label < tinted && qAlpha((*overlay.tints)[*label]) != 0)
                line[x] = blend(line[x], (*overlay.tints)[*label]);
        }
    }
}

}  // namespace

QImage slice_image(const Volume& volume, const SlicePlane& plane, int index, ValueRange window,
                   const SliceOverlay& overlay) {
    const GridGeometry& geometry = volume.geometry();
    QImage image(geometry.size[plane.u], geometry.size[plane.v], QImage::Format_RGB32);
    const Walk walk(geometry, plane, index);
    visit_type(volume.type(), [&](auto tag) { draw_grey(volume.view<decltype(tag)>().data, walk, window, image); });
    if (overlay.labels && (overlay.id != 0 || overlay.tints) && overlay.labels->geometry.size == geometry.size)
        draw_overlay(overlay, walk, image);
    return image;
}

}  // namespace lacuna::ui
