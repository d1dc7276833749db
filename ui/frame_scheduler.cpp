#include "ui/frame_scheduler.h"

#include <algorithm>
#include <cmath>

#include "ui/number_text.h"
#include "ui/plan_words.h"

namespace lacuna::ui {

namespace {

QString describe(const Scene& scene, const Plan& plan) {
    return FrameScheduler::tr("%1 · %2 · step %3")
        .arg(plan_value(name_of(scene.mode)), structure_word(plan.structure))
        .arg(number_text(plan.step, 'g', 3));
}

DrawnFrame to_drawn(Frame frame) {
    DrawnFrame drawn;
    drawn.image = to_image(frame);
    drawn.frame = std::make_shared<const Frame>(std::move(frame));
    return drawn;
}

/// Effects that take longer than a coarse frame may. The others take a few ms at full size, less at a coarse one's.
bool costly(const Effect& effect) { return effect.kind == EffectKind::ao; }

}  // namespace

QImage to_image(const Frame& frame) {
    QImage image(frame.size.x, frame.size.y, QImage::Format_ARGB32_Premultiplied);
    const auto level = [](float share) { return share > 0 ? int(255 * std::min(share, 1.0f) + 0.5f) : 0; };
    for (int y = 0; y < frame.size.y; ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        const glm::vec4* row = frame.color.data() + std::size_t(y) * std::size_t(frame.size.x);
        for (int x = 0; x < frame.size.x; ++x) {
            const int alpha = level(row[x].a);
            line[x] = qRgba(std::min(level(row[x].r), alpha), std::min(level(row[x].g), alpha),
                            std::min(level(row[x].b), alpha), alpha);
        }
    }
    return image;
}

FrameScheduler::FrameScheduler(QObject* parent) : QObject(parent), job_(this) {
    still_.setSingleShot(true);
    still_.setInterval(k_still_ms);
    connect(&still_, &QTimer::timeout, this, [this] {
        if (!coarse_running_) start(false);
    });
}

FrameScheduler::~FrameScheduler() = default;

void FrameScheduler::setEngine(std::shared_ptr<Engine> engine) {
    engine_ = std::move(engine);
    changed();
}

void FrameScheduler::setSize(QSize pixels) {
    if (pixels == size_) return;
    size_ = pixels;
    if (size_.isEmpty()) return cancel();
    changed();
}

void FrameScheduler::setScene(const Scene& scene, const Plan& plan) {
    // Of other data, and other patients, no picture may come any more.
    if (scene_ && scene_->volume.identity() != scene.volume.identity()) cancel();
    // What another kind of frame will take is not known yet: its first picture is a coarse one.
    if (scene_ && (scene_->mode != scene.mode || plan_.step != plan.step || plan_.structure != plan.structure))
        divisor_ = std::max(divisor_, 3);
    scene_ = std::make_shared<const Scene>(scene);
    plan_ = plan;
    changed();
}

void FrameScheduler::cancel() {
    still_.stop();
    job_.cancel();
    coarse_running_ = changed_since_start_ = false;
    Q_EMIT busyChanged(false);
}

void FrameScheduler::changed() {
    ++asked_;
    if (!engine_ || !scene_ || size_.isEmpty()) return;
    still_.start();
    if (coarse_running_ && since_start_.elapsed() < k_give_up_ms) {
        changed_since_start_ = true;
        return;
    }
    if (coarse_running_) divisor_ = std::min(8, divisor_ + 1);
    start(true);
}

void FrameScheduler::start(bool coarse) {
    if (!engine_ || !scene_ || size_.isEmpty()) return;
    Scene scene = *scene_;
    Plan plan = plan_;
    const int divisor = coarse ? divisor_ : 1;
    // Shear-warp paints whole voxels while the view moves; the still picture is another one.
    const bool draft = coarse && scene.mode == ViewMode::shear_warp && plan.sampler != Sampler::nearest;
    if (draft) plan.sampler = Sampler::nearest;
    const bool costs = std::any_of(scene.effects.begin(), scene.effects.end(), costly);
    // Fast enough to need no coarse frame before it.
    const bool complete = divisor == 1 && !draft && !(coarse && costs);
    scene.size = {std::max(1, size_.width() / divisor), std::max(1, size_.height() / divisor)};
    if (!complete && scene.mode != ViewMode::shear_warp) plan.step = std::max(plan.step, std::min(1.0, 2 * plan.step));
    if (coarse) std::erase_if(scene.effects, costly);
    coarse_running_ = coarse;
    changed_since_start_ = false;
    since_start_.start();
    const Task task{engine_, std::make_shared<const Scene>(std::move(scene)), std::move(plan), coarse, complete,
                    asked_};
    job_.start(
        [this, task](const JobContext& job) {
            const auto on_the_way = [&](Frame frame) {
                QMetaObject::invokeMethod(
                    this,
                    [this, task, drawn = to_drawn(std::move(frame)), stop = job.stop] {
                        if (!stop.stop_requested()) show(task, drawn, true);
                    },
                    Qt::QueuedConnection);
            };
            return to_drawn(task.engine->render(*task.scene, task.plan, job, false, on_the_way).frame);
        },
        [this, task](Outcome<DrawnFrame> outcome) { finish(task, std::move(outcome)); },
        [this](double share) { Q_EMIT progressed(share); });
    Q_EMIT busyChanged(true);
}

void FrameScheduler::finish(const Task& task, Outcome<DrawnFrame> outcome) {
    const bool coarse = task.coarse, complete = task.complete;
    coarse_running_ = false;
    if (const Error* error = std::get_if<Error>(&outcome)) {
        if (changed_since_start_) return start(true);  // what failed is no longer what is wanted
        still_.stop();
        Q_EMIT busyChanged(false);
        if (error->code() != Errc::cancelled) Q_EMIT failed(QString::fromStdString(error->what()));
        return;
    }
    const DrawnFrame& drawn = std::get<DrawnFrame>(outcome);
    // What a still picture's sampler or effects took says nothing of the coarse frames, which go without.
    const bool alike =
        scene_->mode != ViewMode::shear_warp && std::none_of(scene_->effects.begin(), scene_->effects.end(), costly);
    if (coarse || alike) adapt(*drawn.frame);
    show(task, drawn, !complete);
    if (changed_since_start_) {
        start(true);
        return;
    }
    if (complete) still_.stop();
    if (coarse && !complete && !still_.isActive())
        start(false);
    else
        Q_EMIT busyChanged(busy());
}

void FrameScheduler::show(const Task& task, const DrawnFrame& drawn, bool coarse) {
    FrameFacts facts;
    facts.coarse = coarse;
    facts.ms = drawn.frame->ms;
    facts.device = QString::fromStdString(task.engine->device_name());
    facts.plan = describe(*task.scene, task.plan);
    facts.bytes_held = task.engine->bytes_held();
    facts.scene = task.scene;
    facts.drawn = task.plan;
    facts.frame = drawn.frame;
    shown_ = task.asked;
    Q_EMIT frameReady(drawn.image, facts);
}

void FrameScheduler::adapt(const Frame& frame) {
    if (size_.isEmpty() || frame.pixels() == 0) return;
    const double full_pixels = double(size_.width()) * size_.height();
    const double full_ms = frame.ms * full_pixels / double(frame.pixels());
    const double wanted = std::sqrt(std::max(full_ms, 0.01) / k_coarse_ms);
    const int divisor = std::clamp(int(std::ceil(wanted)), 1, 8);
    divisor_ = std::clamp(divisor, std::max(1, divisor_ - 1), 8);  // grow at once, shrink slowly
}

}  // namespace lacuna::ui
