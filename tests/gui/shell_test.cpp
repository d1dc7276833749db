// What holds the window together: commands and their keys, palette, sheet, layout, settings, log.
#include <QClipboard>
#include <QComboBox>
#include <QMenuBar>
#include <QPdfWriter>
#include <QSettings>
#include <QTabBar>
#include <QTemporaryDir>
#include <QToolButton>
#include <map>
#include <set>
#include <thread>

#include "core/base/log.h"
#include "core/io/library_versions.h"
#include "tests/gui/window_fixture.h"
#include "ui/action_catalog.h"
#include "ui/dialogs/about_dialog.h"
#include "ui/dialogs/command_palette.h"
#include "ui/dialogs/log_window.h"
#include "ui/dialogs/shortcut_sheet.h"
#include "ui/gestures.h"
#include "ui/icons.h"
#include "ui/preferences.h"

namespace lacuna::ui::test {
namespace {

TEST(FuzzyScore, LettersInOrderMatchAndWordsCountMore) {
    EXPECT_GE(fuzzy_score(QStringLiteral("acp"), QStringLiteral("Add a cutting plane")), 0);
    EXPECT_LT(fuzzy_score(QStringLiteral("pca"), QStringLiteral("Cutting plane")), 0);
    EXPECT_LT(fuzzy_score(QStringLiteral("x"), QString()), 0);
    EXPECT_EQ(fuzzy_score(QString(), QStringLiteral("anything")), 0);
    const auto score = [](const char* text) { return fuzzy_score(QStringLiteral("cut"), QString::fromUtf8(text)); };
    EXPECT_GT(score("Add a cut"), score("Execute"));
    EXPECT_GT(score("Execute"), score("xcxuxt"));
    // The dynamic programme finds the best place, not the first: "c" of "cut", not of "access".
    EXPECT_EQ(score("access cut"), score("a cut"));
    EXPECT_EQ(fuzzy_score(QStringLiteral("flache"), QString::fromUtf8("Fläche")),
              fuzzy_score(QString::fromUtf8("FLÄCHE"), QString::fromUtf8("Fläche")));
}

/// The best score by trying every way to place the letters.
int brute_score(const QString& pattern, const QString& text, int i, int j, bool row) {
    if (i == pattern.size()) return 0;
    int best = -1;
    for (int at = j; at < text.size(); ++at) {
        if (text[at] != pattern[i]) continue;
        const int rest = brute_score(pattern, text, i + 1, at + 1, true);
        if (rest < 0) continue;
        const bool word = at == 0 || text[at - 1] == QLatin1Char(' ');
        best = std::max(best, rest + 1 + (word ? 8 : 0) + (row && at == j ? 5 : 0));
    }
    return best;
}

TEST(FuzzyScore, IsTheBestOfAllPlacings) {
    std::uint32_t seed = 7;
    const auto draw = [&seed](int below) {
        seed = seed * 1664525u + 1013904223u;
        return int((seed >> 16) % std::uint32_t(below));
    };
    for (int round = 0; round < 400; ++round) {
        QString text, pattern;
        for (int i = 0; i < 12; ++i) text += QLatin1Char("abc "[draw(4)]);
        for (int i = draw(4); i >= 0; --i) pattern += QLatin1Char("abc"[draw(3)]);
        EXPECT_EQ(fuzzy_score(pattern, text), brute_score(pattern, text, 0, 0, false))
            << pattern.toStdString() << " in " << text.toStdString();
    }
}

TEST(PlainText, HasNeitherMnemonicNorDots) {
    EXPECT_EQ(plain_text(QStringLiteral("&Open file…")), QStringLiteral("Open file"));
    EXPECT_EQ(plain_text(QStringLiteral("Lo&g...")), QStringLiteral("Log"));
    EXPECT_EQ(plain_text(QStringLiteral("Black && white")), QStringLiteral("Black & white"));
    EXPECT_EQ(plain_text(QString()), QString());
}

class ShellTest : public WindowTest {
protected:
    QList<CatalogEntry> catalog() const { return catalog_of(window->menuBar()); }
    QAction* action(const QString& text) const {
        for (const CatalogEntry& entry : catalog())
            if (entry.text == text) return entry.action;
        return nullptr;
    }
};

TEST_F(ShellTest, NoShortcutStandsTwiceAndEveryCommandHasAName) {
    std::map<QString, QString> owner;
    int with_key = 0;
    for (const CatalogEntry& entry : catalog()) {
        EXPECT_FALSE(entry.text.isEmpty()) << entry.path.join('/').toStdString();
        for (const QKeySequence& key : entry.action->shortcuts()) {
            const QString keys = key.toString(QKeySequence::PortableText);
            const auto [at, is_new] = owner.emplace(keys, entry.text);
            EXPECT_TRUE(is_new) << keys.toStdString() << " stands at " << at->second.toStdString() << " and at "
                                << entry.text.toStdString();
            ++with_key;
        }
    }
    EXPECT_GT(with_key, 40);
    // Commands outside the menus would be found by nobody.
    std::set<QAction*> known;
    for (const CatalogEntry& entry : catalog()) known.insert(entry.action);
    for (QAction* one : window->findChildren<QAction*>())
        EXPECT_TRUE(one->shortcut().isEmpty() || one->menu() || known.contains(one))
            << one->text().toStdString() << " has a key and stands in no menu";
}

TEST_F(ShellTest, TwoCommandsOfOneMenuAreToldApart) {
    std::set<QString> names;
    for (const CatalogEntry& entry : catalog()) {
        const QString name = entry.path.join(QLatin1Char('/')) + QLatin1Char('/') + entry.text;
        EXPECT_TRUE(names.insert(name).second) << name.toStdString();
    }
}

TEST_F(ShellTest, TabReachesEveryControl) {
    open(k_casting);
    window->rangesPanel()->addRange();
    for (int page = 0; page < window->tabs()->count(); ++page) {
        window->tabs()->setCurrentIndex(page);
        window->views()->volumeView()->setFocus();
        std::set<QWidget*> reached;
        for (int i = 0; i < 400 && QApplication::focusWidget(); ++i) {
            reached.insert(QApplication::focusWidget());
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        }
        for (QWidget* widget : window->findChildren<QWidget*>()) {
            const bool wanted = (widget->focusPolicy() & Qt::TabFocus) && widget->isEnabled() &&
                                widget->isVisibleTo(window.get()) && widget->visibleRegion().isEmpty() == false &&
                                widget->window() == window.get() && !widget->focusProxy();
            if (!wanted) continue;
            // Of a group of radio buttons or tabs one is reached, the arrows lead to the others.
            if (qobject_cast<QAbstractButton*>(widget) && widget->inherits("QRadioButton")) continue;
            EXPECT_TRUE(reached.contains(widget)) << widget->metaObject()->className() << " \""
                                                  << widget->accessibleName().toStdString() << "\" on page " << page;
        }
    }
}

TEST_F(ShellTest, ThePaletteFindsAndRunsACommand) {
    open(k_casting);
    QTest::keyClick(window.get(), Qt::Key_K, Qt::ControlModifier);
    auto* palette = window->findChild<CommandPalette*>();
    ASSERT_NE(palette, nullptr);
    const int all = palette->list()->model()->rowCount();
    EXPECT_EQ(all, int(catalog().size()));
    QTest::keyClicks(palette->edit(), QStringLiteral("cutpl"));
    EXPECT_LT(palette->list()->model()->rowCount(), all);
    EXPECT_EQ(palette->list()->currentIndex().data().toString(), QStringLiteral("Add a cutting plane"));
    QTest::keyClick(palette->edit(), Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([this] { return document().settings.cuts.size() == 1; }, 2000));
}

TEST_F(ShellTest, ThePaletteRunsNothingThatIsDisabled) {
    QTest::keyClick(window.get(), Qt::Key_K, Qt::ControlModifier);
    auto* palette = window->findChild<CommandPalette*>();
    ASSERT_NE(palette, nullptr);
    QTest::keyClicks(palette->edit(), QStringLiteral("add a cutting plane"));
    QTest::keyClick(palette->edit(), Qt::Key_Return);
    EXPECT_TRUE(palette->isVisible());
    QTest::keyClicks(palette->edit(), QStringLiteral("zzzzzz"));
    EXPECT_EQ(palette->list()->model()->rowCount(), 0);
    QTest::keyClick(palette->edit(), Qt::Key_Return);
    QTest::keyClick(palette->edit(), Qt::Key_Escape);
    EXPECT_TRUE(QTest::qWaitFor([this] { return window->findChild<CommandPalette*>() == nullptr; }, 2000));
}

TEST_F(ShellTest, TheSheetHoldsEveryKeyAndIsPrinted) {
    QTest::keyClick(window.get(), Qt::Key_F1);
    auto* sheet = window->findChild<ShortcutSheet*>();
    ASSERT_NE(sheet, nullptr);
    int keys = 0;
    for (const CatalogEntry& entry : catalog()) keys += !entry.shortcut.isEmpty();
    EXPECT_EQ(sheet->shownRows(), keys + int(gestures().size()));
    sheet->edit()->setText(QStringLiteral("file quit"));
    EXPECT_EQ(sheet->shownRows(), 1);
    sheet->edit()->clear();
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("keys.pdf"));
    {
        QPdfWriter writer(file);
        sheet->print(&writer);
    }
    QFile printed(file);
    ASSERT_TRUE(printed.open(QIODevice::ReadOnly));
    EXPECT_TRUE(printed.readAll().startsWith("%PDF"));
    EXPECT_GT(printed.size(), 5000);
}

TEST_F(ShellTest, ArrangementsShowTheirViews) {
    open(k_casting);
    FourUp* views = window->views();
    const auto visible = [views] {
        int count = views->volumeView()->isVisible();
        for (SliceView* slice : views->slices()) count += slice->isVisible();
        return count;
    };
    QTest::keyClick(window.get(), Qt::Key_F6);
    EXPECT_EQ(views->arrangement(), Arrangement::one_and_three);
    EXPECT_EQ(visible(), 4);
    QApplication::processEvents();
    EXPECT_GT(views->volumeView()->width(), 1.5 * views->slices()[0]->width());
    EXPECT_GT(views->volumeView()->height(), 2.5 * views->slices()[0]->height());
    QTest::keyClick(window.get(), Qt::Key_F7);
    EXPECT_EQ(visible(), 1);
    QTest::mouseDClick(views->volumeView(), Qt::LeftButton);
    EXPECT_EQ(views->arrangement(), Arrangement::one_and_three);
    QTest::keyClick(window.get(), Qt::Key_F5);
    EXPECT_EQ(visible(), 4);
    QApplication::processEvents();
    EXPECT_NEAR(views->volumeView()->width(), views->slices()[0]->width(), 3);
    // A view that is hidden shows itself where it is wanted.
    QTest::keyClick(window.get(), Qt::Key_F7);
    QTest::keyClick(window.get(), Qt::Key_3, Qt::ControlModifier);
    EXPECT_TRUE(views->slice(SliceKind::coronal)->isVisible());
    EXPECT_TRUE(views->slice(SliceKind::coronal)->hasFocus());
    EXPECT_EQ(visible(), 1);
    QTest::keyClick(window.get(), Qt::Key_F5);
}

TEST_F(ShellTest, FitsASmallScreenWithNothingOverAnother) {
    open(k_casting);
    window->resize(800, 600);
    (void)QTest::qWaitFor([this] { return window->size() == QSize(800, 600); }, 2000);
    EXPECT_EQ(window->size(), QSize(800, 600));
    EXPECT_LE(window->minimumSizeHint().width(), 800);
    EXPECT_LE(window->minimumSizeHint().height(), 600);
    for (QDockWidget* dock : window->findChildren<QDockWidget*>()) {
        if (dock->visibleRegion().isEmpty()) continue;
        EXPECT_TRUE(window->rect().contains(dock->geometry())) << dock->objectName().toStdString();
        EXPECT_FALSE(dock->geometry().intersects(window->centralWidget()->geometry()))
            << dock->objectName().toStdString();
    }
    // What has no room is said in part, and ends in dots.
    StatusLine* line = window->statusLine();
    window->bench()->tasks()->begin(QStringLiteral("Inspecting a series of many parts"), {});
    QApplication::processEvents();
    EXPECT_TRUE(line->rect().contains(line->frameLabel()->geometry()));
    EXPECT_TRUE(line->frameLabel()->shownText() == line->frameText() ||
                line->frameLabel()->shownText().endsWith(QChar(0x2026)))
        << line->frameLabel()->shownText().toStdString();
    EXPECT_GT(line->readoutLabel()->width(), 60);
    window->bench()->tasks()->end(window->bench()->tasks()->rows().back().id);
}

TEST_F(ShellTest, APanelComesBackAtItsHeight) {
    open(k_casting);
    QDockWidget* dock = window->inspection()->dock();
    dock->raise();
    window->resizeDocks({dock}, {250}, Qt::Vertical);
    QApplication::processEvents();
    const int height = dock->height();
    EXPECT_NEAR(height, 250, 40);  // the tabs take some of it
    window->close();
    SetUp();
    open(k_casting);
    dock = window->inspection()->dock();
    dock->raise();
    QApplication::processEvents();
    EXPECT_NEAR(dock->height(), height, 10);
}

TEST_F(ShellTest, TheLayoutIsRememberedAndReset) {
    open(k_casting);
    QTest::keyClick(window.get(), Qt::Key_F6);
    auto* scene = window->findChild<QDockWidget*>(QStringLiteral("scene"));
    ASSERT_NE(scene, nullptr);
    EXPECT_TRUE(scene->features() & QDockWidget::DockWidgetClosable);
    scene->close();
    window->close();
    SetUp();
    scene = window->findChild<QDockWidget*>(QStringLiteral("scene"));
    EXPECT_TRUE(scene->isHidden());
    EXPECT_EQ(window->views()->arrangement(), Arrangement::one_and_three);
    QTest::keyClick(window.get(), Qt::Key_0, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_FALSE(scene->isHidden());
    EXPECT_EQ(window->views()->arrangement(), Arrangement::four);
    EXPECT_TRUE(preferences::window_state().isEmpty());
}

TEST_F(ShellTest, TheWindowFitsASmallScreen) {
    open(k_casting);
    EXPECT_LE(window->minimumSizeHint().width(), 1280);
    EXPECT_LE(window->minimumSizeHint().height(), 900);
    const MainWindow fresh([](const JobContext&) { return std::make_shared<Engine>(nullptr); });
    EXPECT_LE(fresh.width(), 1480);
    for (QDockWidget* dock : window->findChildren<QDockWidget*>())
        EXPECT_LE(dock->minimumSizeHint().width(), 820) << dock->objectName().toStdString();
}

TEST_F(ShellTest, RubbishInTheRememberedLayoutDoesNoHarm) {
    preferences::set_window("rubbish", QByteArray(3000, '\x7f'));
    preferences::set_views_state(QByteArray("\0\0\0\1\0\0\0\7", 8));
    SetUp();
    EXPECT_EQ(window->views()->arrangement(), Arrangement::four);
    EXPECT_FALSE(window->findChild<QDockWidget*>(QStringLiteral("scene"))->isHidden());
    preferences::forget_window();
}

TEST_F(ShellTest, TheToolBarHasWordsUnderPictures) {
    const QList<QToolButton*> buttons = window->layoutFeature()->toolBar()->findChildren<QToolButton*>();
    int shown = 0;
    for (QToolButton* button : buttons) {
        if (!button->defaultAction()) continue;
        EXPECT_FALSE(button->defaultAction()->icon().isNull());
        EXPECT_FALSE(button->defaultAction()->iconText().isEmpty());
        EXPECT_FALSE(button->accessibleName().isEmpty());
        EXPECT_EQ(button->toolButtonStyle(), Qt::ToolButtonTextUnderIcon);
        ++shown;
    }
    EXPECT_GE(shown, 12);
}

TEST(Icons, AreAllDrawnAndDifferent) {
    std::vector<QImage> seen;
    for (int i = int(Icon::folder); i <= int(Icon::help); ++i) {
        const QImage image = make_icon(Icon(i)).pixmap(48, 48).toImage();
        int drawn = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) drawn += qAlpha(image.pixel(x, y)) > 128;
        EXPECT_GT(drawn, 40) << i;
        for (const QImage& other : seen) EXPECT_NE(image, other) << i;
        seen.push_back(image);
    }
}

TEST_F(ShellTest, TheSettingsAreKeptAndTold) {
    QTest::keyClick(window.get(), Qt::Key_Comma, Qt::ControlModifier);
    SettingsDialog* dialog = window->settingsFeature()->dialog();
    ASSERT_NE(dialog, nullptr);
    QSignalSpy measured(dialog, &SettingsDialog::measured), engine(dialog, &SettingsDialog::engineChosen);
    ASSERT_TRUE(measured.count() > 0 || measured.wait(k_patience_ms));
    EXPECT_EQ(dialog->deviceTable()->rowCount(), dialog->deviceBox()->count() - 2);
    QTest::mouseClick(dialog->measureButton(), Qt::LeftButton);
    EXPECT_FALSE(dialog->measureButton()->isEnabled());
    ASSERT_TRUE(measured.wait(k_patience_ms));
    EXPECT_TRUE(dialog->measureButton()->isEnabled());
    dialog->deviceBox()->setCurrentIndex(1);
    dialog->memoryBox()->setValue(2048);
    dialog->autosaveBox()->setValue(7);
    dialog->privacyBox()->setChecked(true);
    QSignalSpy ready(window->bench(), &Workbench::engineReady);
    dialog->accept();
    EXPECT_EQ(engine.count(), 1);
    EXPECT_EQ(preferences::device(), QStringLiteral("none"));
    EXPECT_EQ(preferences::memory_limit_mib(), 2048);
    EXPECT_EQ(preferences::autosave_minutes(), 7);
    EXPECT_TRUE(preferences::hide_patient());
    ASSERT_TRUE(ready.count() > 0 || ready.wait(k_patience_ms));  // the window works on with the device chosen
    QSettings().clear();
}

TEST_F(ShellTest, CancelledSettingsChangeNothing) {
    window->settingsFeature()->show();
    SettingsDialog* dialog = window->settingsFeature()->dialog();
    dialog->autosaveBox()->setValue(33);
    dialog->reject();
    EXPECT_EQ(preferences::autosave_minutes(), 2);
}

TEST_F(ShellTest, TheLogIsShownAsItGoesAndCopied) {
    LogStore::instance()->clear();
    LogWindow log_window;
    log(LogLevel::info, "A line from here.");
    std::thread([] { log(LogLevel::info, "A line from another thread."); }).join();
    log(LogLevel::debug, "A detail.");
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return log_window.text().contains(QStringLiteral("another thread")); }, k_patience_ms));
    EXPECT_TRUE(log_window.text().contains(QStringLiteral("note: A line from here.")));
    EXPECT_FALSE(log_window.text().contains(QStringLiteral("A detail.")));
    log_window.levelBox()->setCurrentIndex(0);
    EXPECT_TRUE(log_window.text().contains(QStringLiteral("A detail.")));
    log_window.copy();
    EXPECT_EQ(QGuiApplication::clipboard()->text(), log_window.text());
    LogStore::instance()->clear();
}

TEST(About, NamesWhatTheProgramIsMadeOf) {
    const AboutDialog about(version_rows(QStringLiteral("a device"), QStringLiteral("a driver 3.1")), nullptr);
    for (const char* word : {"Lacuna: ", "Qt: 6.", "a device", "a driver 3.1", "DCMTK: 3.", "ITK: 5.", "GDCM: "})
        EXPECT_TRUE(about.text().contains(QLatin1String(word))) << word << " in " << about.text().toStdString();
    bool notice = false;
    for (const QLabel* label : about.findChildren<QLabel*>())
        notice = notice || label->text().contains(QStringLiteral("Not a medical device"));
    EXPECT_TRUE(notice);
}

}  // namespace
}  // namespace lacuna::ui::test
