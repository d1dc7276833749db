#include "ui/views/slice_picture.h"

namespace lacuna::ui {

namespace {
// About 10 ms of one core each: well under the 50 ms a window may take to answer.
constexpr std::int64_t k_quick_voxels = 5'000'000, k_quick_samples = 1'000'000;
}  // namespace

void SlicePicture::setVolume(const Volume& volume) {
    job_.cancel();
    volume_ = volume;
    values_.clear();
    wanted_ = shown_ = {};
    overlay_ = {};
    image_ = {};
}

void SlicePicture::setWindow(const VoiWindow& window) {
    if (window == window_) return;
    window_ = window;
    image_ = {};
}

void SlicePicture::setOverlay(const SliceOverlay& overlay) {
    overlay_ = overlay;
    image_ = {};
}

void SlicePicture::setOverlayOpacity(double opacity) {
    if (opacity == opacity_) return;
    opacity_ = opacity;
    if (!overlay_.empty()) image_ = {};
}

void SlicePicture::request(const SliceFrame& frame, const Slab& slab) { wanted_ = {frame, slab}; }

bool SlicePicture::quick(const Request& request) const {
    const GridGeometry& grid = volume_.geometry();
    const std::int64_t pixels = std::int64_t(request.frame.size.x) * request.frame.size.y;
    const std::int64_t all = pixels * sheets_of(grid, request.frame.normal(), request.slab.thickness_mm).count();
    return all <= (voxel_walk(grid, request.frame).on_grid ? k_quick_voxels : k_quick_samples);
}

void SlicePicture::sample() {
    if (quick(wanted_)) {
        job_.cancel();
        values_ = reslice(volume_, wanted_.frame, wanted_.slab);
        shown_ = wanted_;
        image_ = {};
        return;
    }
    if (job_.running()) return;  // the end of that one asks for the newest
    job_.start([volume = volume_,
                request = wanted_](const JobContext& job) { return reslice(volume, request.frame, request.slab, job); },
               [this, request = wanted_](Outcome<std::vector<float>> outcome) {
                   // Out of memory: the view stays black where it was asked for, and does not ask again.
                   values_ = std::holds_alternative<Error>(outcome) ? std::vector<float>{} : std::get<0>(outcome);
                   shown_ = request;
                   image_ = {};
                   Q_EMIT ready();
               });
}

void SlicePicture::paint() {
    const QSize size(shown_.frame.size.x, shown_.frame.size.y);
    image_ = slice_image(values_, size, window_);
    if (overlay_.empty() || overlay_.labels->geometry.size != volume_.geometry().size) return;
    tint_image(image_, reslice_nearest(overlay_.labels->geometry, *overlay_.labels->labels, shown_.frame), overlay_,
               opacity_);
}

const QImage& SlicePicture::image() {
    if (volume_.empty()) return image_;
    if (!(shown_ == wanted_)) sample();
    if (image_.isNull() && !values_.empty()) paint();
    return image_;
}

}  // namespace lacuna::ui
