#include "ui/views/slice_image.h"

#include <algorithm>
#include <cmath>

namespace lacuna::ui {

QImage slice_image(std::span<const float> values, QSize size, const VoiWindow& window) {
    QImage image(size, QImage::Format_RGB32);
    const std::size_t width = std::size_t(size.width());
    std::vector<std::uint8_t> grey(width);
    for (int y = 0; y < size.height(); ++y) {
        apply_voi(window, values.subspan(std::size_t(y) * width, width), grey);
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (std::size_t x = 0; x < width; ++x) line[x] = qRgb(grey[x], grey[x], grey[x]);
    }
    return image;
}

void tint_image(QImage& image, std::span<const std::uint32_t> labels, const SliceOverlay& overlay, double opacity) {
    const int share = int(std::lround(std::clamp(opacity, 0.0, 1.0) * 256));
    const auto blend = [share](QRgb under, QRgb tint) {
        const int rest = qRed(under) * (256 - share);
        return qRgb((rest + qRed(tint) * share) / 256, (rest + qGreen(tint) * share) / 256,
                    (rest + qBlue(tint) * share) / 256);
    };
    const QRgb chosen = overlay.color.rgb();
    const std::size_t tinted = overlay.tints ? overlay.tints->size() : 0;
    const std::uint32_t* label = labels.data();
    for (int y = 0; y < image.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < image.width(); ++x, ++label) {
            if (*label == 0) continue;
            if (*label == overlay.id)
                line[x] = blend(line[x], chosen);
            else if (*label < tinted && qAlpha((*overlay.tints)[*label]) != 0)
                line[x] = blend(line[x], (*overlay.tints)[*label]);
        }
    }
}

}  // namespace lacuna::ui
