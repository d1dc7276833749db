// How soon the window answers the hand: from a mouse move over the 3D view to the first picture painted, and how often
// pictures come while the mouse goes on; mode by mode, on the device found. The hand turns the volume (with all effects
// on), drags a cutting plane, or the levels.
//   bench_interaction INPUT [ROUNDS [WIDTHxHEIGHT [turn|effects|cut|levels]]]      default sample:head@256 9 700x560
#include <fmt/format.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "core/base/order_statistics.h"
#include "core/compute/device.h"
#include "ui/main_window.h"
#include "ui/preferences.h"
#include "ui/theme.h"

namespace {

using namespace lacuna;
using namespace lacuna::ui;

constexpr int k_patience_ms = 600000;

/// Notes when the view was painted.
class PaintClock final : public QObject {
public:
    using QObject::QObject;
    int paints = 0;
    bool eventFilter(QObject*, QEvent* event) override {
        paints += event->type() == QEvent::Paint;
        return false;
    }
};

struct Hand {
    MainWindow& window;
    lacuna::ui::VolumeView* view = window.views()->volumeView();
    Qt::MouseButton button = Qt::LeftButton;
    Qt::KeyboardModifiers modifiers = Qt::NoModifier;

    void settle() const {
        (void)QTest::qWaitFor(
            [this] { return !window.scheduler()->busy() && view->image().size() == view->pixelSize(); }, k_patience_ms);
    }
    void move(const QPoint& to) const {
        QMouseEvent event(QEvent::MouseMove, to, view->mapToGlobal(to), Qt::NoButton, button, modifiers);
        QApplication::sendEvent(view, &event);
    }
    /// Handles are where they were for the next gesture.
    void takeBack() const {
        const EditHistory& history = window.documents()->history();
        const std::string name = history.undo_name();
        if (name == "Move a cut" || name == "Levels") window.documents()->undo();
    }
    /// Milliseconds from a first move to the first picture on the widget; drawn: until it came from the worker.
    double firstPicture(const QPoint& from, double& drawn) const {
        settle();
        QTest::mousePress(view, button, modifiers, from);
        bool came = false;
        PaintClock clock;
        QElapsedTimer watch;
        const auto listen = QObject::connect(window.scheduler(), &FrameScheduler::frameReady, view,
                                             [&](const QImage&, const FrameFacts&) {
                                                 if (came) return;
                                                 came = true;
                                                 drawn = double(watch.nsecsElapsed()) * 1e-6;
                                                 view->installEventFilter(&clock);
                                             });
        watch.start();
        move(from + QPoint(25, 6));
        while ((!came || clock.paints == 0) && watch.elapsed() < 10000)
            QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, 1);
        const double ms = double(watch.nsecsElapsed()) * 1e-6;
        QObject::disconnect(listen);
        QTest::mouseRelease(view, button, modifiers, from);
        takeBack();
        return ms;
    }
    /// Pictures a second during a second of moves every 8 ms; longest: the longest the event loop did not turn.
    double pace(const QPoint& from, double& longest) const {
        settle();
        int pictures = 0;
        const auto listen = QObject::connect(window.scheduler(), &FrameScheduler::frameReady, view,
                                             [&](const QImage&, const FrameFacts&) { ++pictures; });
        QTest::mousePress(view, button, modifiers, from);
        QElapsedTimer whole, turn;
        whole.start();
        longest = 0;
        for (int i = 0; whole.elapsed() < 1000; ++i) {
            turn.start();
            move(from + QPoint(12 + i % 90, i % 40));
            QCoreApplication::processEvents();
            longest = std::max(longest, double(turn.nsecsElapsed()) * 1e-6);
            QTest::qWait(8);
        }
        const double seconds = double(whole.elapsed()) / 1000;
        QTest::mouseRelease(view, button, modifiers, from);
        QObject::disconnect(listen);
        takeBack();
        return pictures / seconds;
    }
};

}  // namespace

int main(int argc, char** argv) {
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    const QTemporaryDir preferences;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, preferences.path());
    name_application(QStringLiteral("bench"));
    apply_theme(application);
    const QString input = argc > 1 ? QString::fromLocal8Bit(argv[1]) : QStringLiteral("sample:head@256");
    const int rounds = argc > 2 ? std::max(1, std::atoi(argv[2])) : 9;
    const QStringList size = QString::fromLocal8Bit(argc > 3 ? argv[3] : "700x560").split(QLatin1Char('x'));
    const std::string extra = argc > 4 ? argv[4] : "turn";

    MainWindow window([](const JobContext& job) { return std::make_shared<Engine>(open_device("", job)); });
    window.show();
    window.views()->toggleMaximized(window.views()->volumeView());
    window.openInput(input);
    Hand hand{window};
    const bool opened = QTest::qWaitFor(
        [&] { return window.documents()->hasDocument() && window.scheduler()->hasEngine(); }, k_patience_ms);
    if (!opened) return 1;
    window.resize(window.size() + QSize(size[0].toInt(), size[1].toInt()) - hand.view->size());
    QTest::qWait(50);
    const glm::ivec3 voxels = window.documents()->document().volume.geometry().size;
    fmt::print("{} ({}x{}x{}), 3D view {}x{}, {} rounds, {}\n", input.toStdString(), voxels.x, voxels.y, voxels.z,
               hand.view->width(), hand.view->height(), rounds, extra);
    fmt::print(
        "| mode | first picture ms (median, worst) | of it drawing | pictures a second | longest turn ms |\n"
        "| --- | --- | --- | --- | --- |\n");
    for (const ModeName& mode : mode_names()) {
        ViewSettings settings = window.documents()->document().settings;
        switch_mode(settings, mode.mode);
        if (extra == "effects")
            for (const EffectKind kind : {EffectKind::ssao, EffectKind::dof, EffectKind::ao})
                if (serves(kind, mode.mode)) settings.effects.push_back({kind, {}});
        if (extra == "cut" && settings.cuts.empty())
            settings.cuts.push_back(
                {{{0, 1, 0}, -window.documents()->document().volume.geometry().centre_mm().y, true}, true});
        window.documents()->edit(QStringLiteral("Mode"), settings);
        std::vector<double> first, drawing;
        QPoint from = hand.view->rect().center();
        if (extra == "cut") {
            hand.settle();
            const ViewRays rays = hand.view->rays();
            const PlaneGizmo gizmo =
                gizmo_of(settings.cuts[0].plane, window.documents()->document().volume.geometry(), rays);
            from = to_point(*in_picture(rays, gizmo.anchor)).toPoint();
        }
        if (extra == "levels") hand.button = Qt::RightButton, hand.modifiers = Qt::ControlModifier;
        for (int i = 0; i <= rounds; ++i) {
            double drawn = 0;
            const double ms = hand.firstPicture(from, drawn);
            if (i == 0) continue;  // structures are built, and how long a frame takes is learnt
            first.push_back(ms);
            drawing.push_back(drawn);
        }
        double longest = 0;
        const double pace = hand.pace(from, longest);
        fmt::print("| {} | {:.0f}, {:.0f} | {:.0f} | {:.0f} | {:.0f} |\n", name_of(mode.mode), median(first),
                   *std::max_element(first.begin(), first.end()), median(drawing), pace, longest);
        std::fflush(stdout);
    }
    return 0;
}
