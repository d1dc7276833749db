#pragma once

#include <QImage>
#include <QObject>

#include "core/volume/reslice.h"
#include "ui/latest_job.h"
#include "ui/views/slice_image.h"

namespace lacuna::ui {

/// The grey picture of one slice view: sampled when the plane moves, windowed when the window does, tinted when the
/// overlay does. What takes its time (thick slabs, tilted ones above all) is sampled on a worker thread; until it is
/// there the picture before stays, and of the requests that come meanwhile only the last is answered.
class SlicePicture final : public QObject {
    Q_OBJECT
public:
    explicit SlicePicture(QObject* parent = nullptr) : QObject(parent), job_(this) {}

    void setVolume(const Volume& volume);
    void setWindow(const VoiWindow& window);
    void setOverlay(const SliceOverlay& overlay);
    void setOverlayOpacity(double opacity);
    /// What is to be seen.
    void request(const SliceFrame& frame, const Slab& slab);
    /// The newest picture there is; null before the first. Lies at frame().
    const QImage& image();
    const SliceFrame& frame() const { return shown_.frame; }
    bool waiting() const { return job_.running(); }

Q_SIGNALS:
    void ready();  ///< image() has become another one

private:
    struct Request {
        SliceFrame frame;
        Slab slab;
        friend bool operator==(const Request&, const Request&) = default;
    };
    bool quick(const Request& request) const;
    void sample();
    void paint();

    Volume volume_;
    Request wanted_, shown_;
    std::vector<float> values_;  ///< of shown_
    VoiWindow window_;
    SliceOverlay overlay_;
    double opacity_ = 0.65;
    QImage image_;
    LatestJob<std::vector<float>> job_;
};

}  // namespace lacuna::ui
