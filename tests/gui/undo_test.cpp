// Everything that can be edited in the window, in any order, is undone to the start and redone to the end: the session
// file has the same bytes again. LACUNA_SEED=N takes another course than the built-in ones.
#include <QAbstractButton>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSlider>
#include <QTemporaryDir>

#include "core/io/volume_writer.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/random_edits.h"
#include "ui/action_catalog.h"

namespace lacuna::ui::test {
namespace {

constexpr int k_edits = 200;

class UndoTest : public WindowTest, public testing::WithParamInterface<unsigned> {
protected:
    /// The session file as the window writes it, but for the line that holds the time.
    QByteArray sessionBytes() {
        const QString file = folder.filePath(QStringLiteral("s.lacuna"));
        QSignalSpy saved(window->session(), &SessionFeature::saved);
        window->session()->saveTo(file);
        EXPECT_TRUE(saved.count() > 0 || saved.wait(k_patience_ms));
        QFile in(file);
        EXPECT_TRUE(in.open(QIODevice::ReadOnly));
        QString text = QString::fromUtf8(in.readAll());
        const QRegularExpression time(QStringLiteral("\"saved\": \"[^\"]*\""));
        EXPECT_TRUE(text.contains(time));
        return text.remove(time).toUtf8();
    }

    /// One value anywhere in the settings, as a panel would send it.
    QString editField() {
        ViewSettings next = document().settings;
        const std::string path =
            lacuna::test::change_something(next, document().statistics->range, random, fields_seen);
        window->documents()->edit(QString::fromStdString(path), next);
        return QString::fromStdString(path);
    }

    /// A key pressed on a control of the scene's panels, as a person would.
    QString pokeControl() {
        window->tabs()->setCurrentIndex(int(random() % unsigned(window->tabs()->count())));
        QList<QWidget*> controls;
        for (QWidget* widget : window->findChild<QDockWidget*>(QStringLiteral("scene"))->findChildren<QWidget*>()) {
            const bool value = qobject_cast<QAbstractSlider*>(widget) || qobject_cast<QComboBox*>(widget) ||
                               qobject_cast<QCheckBox*>(widget) || qobject_cast<QAbstractSpinBox*>(widget) ||
                               qobject_cast<RangeSlider*>(widget) || qobject_cast<TransferPlot*>(widget);
            if (value && widget->isEnabled() && widget->isVisible() && !widget->inherits("QScrollBar"))
                controls << widget;
        }
        if (controls.isEmpty()) return {};
        QWidget* control = controls[qsizetype(random() % unsigned(controls.size()))];
        const Qt::Key keys[] = {Qt::Key_Up, Qt::Key_Down, Qt::Key_PageUp, Qt::Key_PageDown};
        control->setFocus();
        QTest::keyClick(control, qobject_cast<QCheckBox*>(control) ? Qt::Key_Space : keys[random() % 4]);
        return QLatin1String(control->metaObject()->className()) + QLatin1Char(' ') + control->accessibleName();
    }

    /// A command that edits, by the menus; those that ask first end in dots.
    QString chooseCommand() {
        QList<QAction*> commands;
        for (const CatalogEntry& entry : catalog_of(window->menuBar())) {
            const QString place = entry.path.join(QLatin1Char('/'));
            const bool edits =
                place.startsWith(QStringLiteral("View/View mode")) || place.startsWith(QStringLiteral("View/Window")) ||
                place.startsWith(QStringLiteral("View/Slices")) || place.startsWith(QStringLiteral("View/Levels")) ||
                place.startsWith(QStringLiteral("Tools/Cutting planes")) ||
                place.startsWith(QStringLiteral("Tools/Colours/Colour map")) ||
                entry.text == QStringLiteral("Remove all measurements") ||
                entry.text == QStringLiteral("Add a segmentation range");
            if (edits && entry.action->isEnabled() && !entry.action->text().endsWith(QChar(0x2026)))
                commands << entry.action;
        }
        QAction* command = commands[qsizetype(random() % unsigned(commands.size()))];
        command->trigger();
        return plain_text(command->text());
    }

    std::mt19937 random;
    std::set<std::string> fields_seen;
    QTemporaryDir folder;
};

TEST_P(UndoTest, TwoHundredEditsAreUndoneAndRedoneToTheSameBytes) {
    const unsigned seed =
        qEnvironmentVariableIsSet("LACUNA_SEED") ? qEnvironmentVariable("LACUNA_SEED").toUInt() : GetParam();
    SCOPED_TRACE("LACUNA_SEED=" + std::to_string(seed));
    random.seed(seed);
    open(QStringLiteral("sample:casting@24"));
    const ViewSettings start = document().settings;
    const Camera camera = document().camera;
    const glm::dvec3 cursor = document().cursor_mm;
    const QByteArray start_bytes = sessionBytes();
    const EditHistory& history = window->documents()->history();
    int edits = 0;
    for (int attempt = 0; edits < k_edits; ++attempt) {
        ASSERT_LT(attempt, 20 * k_edits);
        const ViewSettings before = document().settings;
        const unsigned way = random() % 4;
        const QString what = way < 2 ? editField() : way == 2 ? pokeControl() : chooseCommand();
        window->documents()->endGesture();
        QApplication::processEvents();
        if (document().settings == before) continue;
        ++edits;
        // What no session could hold would be lost with the next crash.
        ASSERT_NO_THROW(check(document().settings, "settings")) << what.toStdString();
        ASSERT_EQ(view_settings_from_json(to_json(document().settings), "settings"), document().settings)
            << what.toStdString();
        ASSERT_TRUE(history.can_undo()) << what.toStdString();
        EXPECT_FALSE(history.undo_name().empty()) << what.toStdString();
        if (random() % 8 == 0) {  // a step back and forth on the way
            const ViewSettings here = document().settings;
            window->documents()->undo();
            ASSERT_EQ(document().settings, before) << what.toStdString();
            window->documents()->redo();
            ASSERT_EQ(document().settings, here) << what.toStdString();
        }
    }
    const ViewSettings end = document().settings;
    window->documents()->setCamera(camera);  // which has a history of its own
    window->documents()->setCursor(cursor);
    const QByteArray end_bytes = sessionBytes();
    EXPECT_NE(start_bytes, end_bytes);
    int steps = 0;
    for (; history.can_undo(); ++steps) {
        window->documents()->undo();
        if (steps % 20 == 0) QApplication::processEvents();
    }
    EXPECT_GE(steps, k_edits);
    EXPECT_EQ(document().settings, start);
    EXPECT_EQ(sessionBytes(), start_bytes);
    while (history.can_redo()) window->documents()->redo();
    EXPECT_EQ(document().settings, end);
    EXPECT_EQ(sessionBytes(), end_bytes);
    // No field went without: those of settings in which every list and option has something.
    ViewSettings full = start;
    full.ranges = {{{"a", {0, 1}, start.tf}, true}};
    full.cuts.resize(1);
    full.measurements.resize(1);
    for (const lacuna::test::SettingsLeaf& leaf : lacuna::test::leaves_of(full, document().statistics->range))
        EXPECT_TRUE(fields_seen.contains(leaf.path)) << leaf.path << " was never edited";
}

INSTANTIATE_TEST_SUITE_P(Seeds, UndoTest, testing::Values(1u, 20u, 300u));

}  // namespace
}  // namespace lacuna::ui::test
