#pragma once

#include <QGuiApplication>
#include <QTimer>
#include <functional>

namespace lacuna::ui {

/// Says when a gesture is over: a moment after its last change, though not while a mouse button is held.
class GestureEnd final : public QTimer {
public:
    /// @param ended  called on this object's thread
    GestureEnd(std::function<void()> ended, QObject* parent) : QTimer(parent) {
        setSingleShot(true);
        setInterval(k_pause_ms);
        connect(this, &QTimer::timeout, this, [this, ended = std::move(ended)] {
            if (QGuiApplication::mouseButtons() != Qt::NoButton)
                start();
            else
                ended();
        });
    }

private:
    static constexpr int k_pause_ms = 700;
};

}  // namespace lacuna::ui
