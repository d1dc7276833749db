#include "ui/preset_thumbnails.h"

namespace lacuna::ui {

namespace {

constexpr int k_pause_ms = 250;     // after the view's last frame
constexpr double k_closer = 1.4;    // than the view, which leaves room to turn the object
constexpr double k_coarsest = 1.0;  // voxel spacings a step; enough for so small a picture

QImage draw(Engine& engine, const Document& document, const JobContext& job) {
    Scene scene = scene_of(document);
    if (scene.mode == ViewMode::shear_warp) scene.mode = ViewMode::iso;  // the same surface, with nothing to list first
    scene.size = {PresetThumbnails::k_size.width(), PresetThumbnails::k_size.height()};
    Plan plan = default_plan(scene);
    plan.structure = Structure::none;
    plan.step = std::max(k_coarsest, document.settings.quality.step);
    return to_image(engine.render(scene, plan, job).frame);
}

}  // namespace

PresetThumbnails::PresetThumbnails(FrameScheduler* scheduler, QObject* parent)
    : QObject(parent), scheduler_(scheduler), job_(this) {
    pause_.setSingleShot(true);
    pause_.setInterval(k_pause_ms);
    connect(&pause_, &QTimer::timeout, this, &PresetThumbnails::next);
    connect(scheduler_, &FrameScheduler::busyChanged, this, [this](bool busy) {
        if (busy) {
            job_.cancel();  // it stays wanted
            pause_.stop();
        } else {
            pause_.start();
        }
    });
}

void PresetThumbnails::setEngine(std::shared_ptr<Engine> engine) {
    engine_ = std::move(engine);
    next();
}

void PresetThumbnails::setDocument(const Document& document) {
    job_.cancel();
    pictures_.clear();
    wanted_.clear();
    document_ = document;
    document_.camera = document.home;
    document_.camera.zoom *= k_closer;
    document_.highlight.reset();
    document_.defects.reset();
}

void PresetThumbnails::want(std::vector<std::pair<QString, ViewSettings>> wanted) {
    const QString running = job_.running() && !wanted_.empty() ? wanted_.front().first : QString();
    wanted_.clear();
    for (auto& item : wanted)
        if (!pictures_.contains(item.first)) wanted_.push_back(std::move(item));
    if (!running.isEmpty() && (wanted_.empty() || wanted_.front().first != running)) job_.cancel();
    next();
}

void PresetThumbnails::forget(const QString& key) {
    pictures_.remove(key);
    if (job_.running() && !wanted_.empty() && wanted_.front().first == key) job_.cancel();
}

void PresetThumbnails::next() {
    if (!engine_ || wanted_.empty() || job_.running() || pause_.isActive() || !document_.volume.in_memory()) return;
    if (scheduler_->busy()) return;  // its busyChanged comes
    const QString key = wanted_.front().first;
    Document document = document_;
    document.settings = wanted_.front().second;
    job_.start([engine = engine_, document](const JobContext& job) { return draw(*engine, document, job); },
               [this, key](Outcome<QImage> outcome) {
                   // One that cannot be drawn is left blank: the view says why when it is chosen.
                   const QImage picture = outcome.index() == 0 ? std::get<0>(outcome) : QImage();
                   pictures_.insert(key, picture);
                   std::erase_if(wanted_, [&](const auto& item) { return item.first == key; });
                   Q_EMIT drawn(key, picture);
                   next();
               });
}

}  // namespace lacuna::ui
