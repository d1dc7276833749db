#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <memory>

#include "ui/main_window.h"

namespace lacuna::ui::test {

inline const QString k_casting = QStringLiteral("sample:casting@48");
constexpr int k_patience_ms = 60000;  ///< for slow machines; a passing test waits for signals, not for this

/// Share of pixels that differ visibly between two pictures; 1 when the sizes differ.
inline double difference(const QImage& a, const QImage& b) {
    if (a.size() != b.size() || a.isNull()) return 1;
    const QImage left = a.convertToFormat(QImage::Format_RGB32), right = b.convertToFormat(QImage::Format_RGB32);
    std::int64_t differing = 0;
    for (int y = 0; y < left.height(); ++y)
        for (int x = 0; x < left.width(); ++x) {
            const QRgb p = left.pixel(x, y), q = right.pixel(x, y);
            if (std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) + std::abs(qBlue(p) - qBlue(q)) > 6)
                ++differing;
        }
    return double(differing) / (double(left.width()) * left.height());
}

/// Share of pixels that are neither black nor transparent.
inline double lit(const QImage& image) {
    std::int64_t count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) count += qGray(image.pixel(x, y)) > 20 && qAlpha(image.pixel(x, y)) > 0;
    return image.isNull() ? 0 : double(count) / (double(image.width()) * image.height());
}

/// A window on the reference renderer, which needs no device and is exact; small, because it is slow.
class WindowTest : public testing::Test {
protected:
    void SetUp() override {
        window = std::make_unique<MainWindow>([](const JobContext&) { return std::make_shared<Engine>(nullptr); });
        window->resize(1100, 760);
        window->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        window->activateWindow();
        (void)QTest::qWaitForWindowActive(window.get());
    }

    void open(const QString& input) {
        QSignalSpy finished(window->loader(), &LoadController::finished);
        window->openInput(input);
        ASSERT_TRUE(finished.wait(k_patience_ms));
        ASSERT_TRUE(window->documents()->hasDocument()) << window->messageBar()->text().toStdString();
        settle();
    }

    /// Waits until the full frame of the current scene is shown.
    void settle() {
        ASSERT_TRUE(QTest::qWaitFor(
            [this] {
                return window->scheduler()->hasEngine() && !window->scheduler()->busy() && !picture().isNull() &&
                       picture().size() == window->views()->volumeView()->pixelSize();
            },
            k_patience_ms))
            << "busy " << window->scheduler()->busy() << ", picture " << picture().width() << "x" << picture().height()
            << ", view " << window->views()->volumeView()->pixelSize().width() << "x"
            << window->views()->volumeView()->pixelSize().height() << ", "
            << window->messageBar()->text().toStdString();
    }

    const QImage& picture() const { return window->views()->volumeView()->image(); }
    const Document& document() const { return window->documents()->document(); }

    /// Presses, moves in steps and releases the left button.
    static void drag(QWidget* widget, QPointF from, QPointF to) {
        QTest::mousePress(widget, Qt::LeftButton, {}, from.toPoint());
        for (int i = 1; i <= 4; ++i) QTest::mouseMove(widget, (from + (to - from) * i / 4.0).toPoint());
        QTest::mouseRelease(widget, Qt::LeftButton, {}, to.toPoint());
    }

    std::unique_ptr<MainWindow> window;
};

}  // namespace lacuna::ui::test
