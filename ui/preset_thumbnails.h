#pragma once

#include <QHash>
#include <QImage>
#include <QObject>
#include <QTimer>
#include <deque>

#include "core/render/engine.h"
#include "core/session/document.h"
#include "ui/frame_scheduler.h"
#include "ui/latest_job.h"

namespace lacuna::ui {

/// Small pictures of the open volume under other settings, drawn one after the other by the window's engine while it
/// has nothing else to do: a picture being drawn is given up as soon as the view wants a frame, and taken up again
/// afterwards. No structure is built for them, so that those of the view stay.
class PresetThumbnails final : public QObject {
    Q_OBJECT
public:
    static constexpr QSize k_size{96, 80};

    PresetThumbnails(FrameScheduler* scheduler, QObject* parent);
    void setEngine(std::shared_ptr<Engine> engine);
    /// Forgets all pictures of the document before.
    void setDocument(const lacuna::Document& document);
    /// What is to be drawn, in this order; what was asked for before and is not in it any more is not drawn.
    void want(std::vector<std::pair<QString, lacuna::ViewSettings>> wanted);
    /// Null until it is drawn.
    QImage picture(const QString& key) const { return pictures_.value(key); }
    /// The settings of that key are others now: what was drawn of it, or is being drawn, is not to be seen.
    void forget(const QString& key);

Q_SIGNALS:
    void drawn(const QString& key, const QImage& picture);

private:
    void next();

    FrameScheduler* scheduler_;
    std::shared_ptr<Engine> engine_;
    Document document_;
    QHash<QString, QImage> pictures_;
    std::deque<std::pair<QString, ViewSettings>> wanted_;
    QTimer pause_;
    LatestJob<QImage> job_;
};

}  // namespace lacuna::ui
