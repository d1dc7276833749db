#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QObject>
#include <QTimer>
#include <memory>

#include "core/render/engine.h"
#include "ui/latest_job.h"

namespace lacuna::ui {

/// What is said of a frame in the status line, and what it was made of.
struct FrameFacts {
    bool coarse = false;
    double ms = 0;
    QString device, plan;
    std::size_t bytes_held = 0;
    std::shared_ptr<const Scene> scene;  ///< as drawn, its size included
    Plan drawn;                          ///< likewise
    std::shared_ptr<const Frame> frame;
};

/// A frame as it comes from the worker: ready to be shown.
struct DrawnFrame {
    std::shared_ptr<const Frame> frame;
    QImage image;
};

/// Turns scenes into pictures off the UI thread: at once a coarse one, small and with long steps; a full one as soon as
/// nothing has changed for a moment, where an effect takes long by way of pictures with ever more of its samples. A
/// full frame is cancelled by any change; a coarse one is let finish, unless it turns out slow or other data is to be
/// seen, so that a fast hand still sees pictures. How coarse follows from the frames measured before.
class FrameScheduler final : public QObject {
    Q_OBJECT
public:
    static constexpr int k_still_ms = 120;       ///< after this long without a change the full frame starts
    static constexpr double k_coarse_ms = 30;    ///< what a coarse frame may take, so that it is seen within 50 ms
    static constexpr qint64 k_give_up_ms = 300;  ///< a coarse frame slower than this makes way for the next

    explicit FrameScheduler(QObject* parent = nullptr);
    ~FrameScheduler() override;

    /// Rendering begins once there is an engine, a scene and a size.
    void setEngine(std::shared_ptr<Engine> engine);
    bool hasEngine() const { return engine_ != nullptr; }
    const std::shared_ptr<Engine>& engine() const { return engine_; }
    /// Size of the picture in device pixels; an empty one stops.
    void setSize(QSize pixels);
    void setScene(const Scene& scene, const Plan& plan);
    /// Stops the frame being drawn; the next change starts again.
    void cancel();
    bool busy() const { return job_.running() || still_.isActive(); }
    /// The last picture shown is of the scene and size asked for last, be it a coarse one.
    bool current() const { return shown_ == asked_; }

Q_SIGNALS:
    void frameReady(const QImage& image, const lacuna::ui::FrameFacts& facts);
    void failed(const QString& sentence);
    void busyChanged(bool busy);
    void progressed(double share);

private:
    void changed();
    void start(bool coarse);
    struct Task {
        std::shared_ptr<Engine> engine;  ///< may be another one by the time the frame comes
        std::shared_ptr<const Scene> scene;
        Plan plan;
        bool coarse, complete;
        int asked;
    };
    void finish(const Task& task, Outcome<DrawnFrame> outcome);
    void show(const Task& task, const DrawnFrame& drawn, bool coarse);
    void adapt(const Frame& frame);

    std::shared_ptr<Engine> engine_;
    std::shared_ptr<const Scene> scene_;
    Plan plan_;
    QSize size_;
    QTimer still_;
    QElapsedTimer since_start_;
    bool coarse_running_ = false, changed_since_start_ = false;
    int divisor_ = 3;
    int asked_ = 0, shown_ = 0;  ///< scenes and sizes so far; of which of them the last picture is
    LatestJob<DrawnFrame> job_;
};

/// A frame as a picture with transparency (sRGB, premultiplied).
QImage to_image(const Frame& frame);

}  // namespace lacuna::ui
