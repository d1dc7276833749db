// Pictures of the window, of every panel, menu and dialog, to be looked at: docs/make_screens.sh runs this in every
// language, theme and scale. LACUNA_SHOTS names the folder, LACUNA_SHOTS_LANGUAGE and LACUNA_SHOTS_THEME what to show.
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QTemporaryDir>

#include "tests/gui/every_dialog.h"
#include "ui/features/import_feature.h"
#include "ui/language.h"
#include "ui/preferences.h"
#include "ui/theme_control.h"

namespace lacuna::ui::test {
namespace {

class GalleryTest : public WindowTest {
protected:
    void SetUp() override {
        if (qEnvironmentVariableIsEmpty("LACUNA_SHOTS")) GTEST_SKIP() << "LACUNA_SHOTS names no folder";
        preferences::set_language(qEnvironmentVariable("LACUNA_SHOTS_LANGUAGE", QStringLiteral("en")));
        Language::instance()->apply();
        ThemeControl::instance()->choose(qEnvironmentVariable("LACUNA_SHOTS_THEME") == QLatin1String("light")
                                             ? ThemeChoice::light
                                             : ThemeChoice::dark);
        WindowTest::SetUp();
        window->resize(1480, 940);
    }
    void TearDown() override {
        window.reset();
        preferences::set_language(QStringLiteral("en"));
        Language::instance()->apply();
        ThemeControl::instance()->choose(ThemeChoice::system);
    }
    void shot(QWidget* widget, const QString& name) {
        QApplication::processEvents();
        const QDir folder(qEnvironmentVariable("LACUNA_SHOTS"));
        QDir().mkpath(folder.path());
        ASSERT_TRUE(widget->grab().save(folder.filePath(name + QStringLiteral(".png")))) << name.toStdString();
    }
    void menus(QMenu* menu, const QString& name) {
        Q_EMIT menu->aboutToShow();
        menu->ensurePolished();
        menu->adjustSize();
        shot(menu, name);
        for (QAction* action : menu->actions())
            if (action->menu() && action->isVisible()) {
                QString word = plain_text(action->text());
                menus(action->menu(), name + QLatin1Char('-') + word.remove(QLatin1Char('/')));
            }
    }
};

TEST_F(GalleryTest, TheWindow) {
    shot(window.get(), QStringLiteral("window-0-empty"));
    open(QStringLiteral("sample:head@96"));
    shot(window.get(), QStringLiteral("window-1-head"));
    open(QStringLiteral("sample:casting@96"));
    QSignalSpy inspected(window->inspection(), &InspectionFeature::finished),
        gathered(window->inspection(), &InspectionFeature::gathered),
        found(window->regions(), &RegionsFeature::finished);
    window->inspection()->inspect(window->inspection()->panel()->form()->criteria().detection);
    ASSERT_TRUE(inspected.wait(k_patience_ms));
    ASSERT_TRUE(gathered.count() > 0 || gathered.wait(k_patience_ms));
    window->regions()->compute();
    ASSERT_TRUE(found.count() > 0 || found.wait(k_patience_ms));
    window->rangesPanel()->addRange();
    window->rangesPanel()->addRange();
    window->cutsPanel()->addCut();
    window->bench()->edit(QStringLiteral("Box"), [](ViewSettings& s) {
        s.roi = {{0.1, 0.05, 0}, {0.9, 1, 0.95}, true, true};
        s.effects = parse_effects("ssao,dof=0.3,gamma=1.2");
        Measurement m;
        m.id = 1;
        m.points_mm = {{-5, 0, 0}, {9, 4, 0}};
        s.measurements = {m};
        m.id = 2;
        m.kind = MeasurementKind::ellipse;
        m.points_mm = {{-5, 3, 0}, {4, 9, 0}};
        s.measurements.push_back(m);
    });
    for (int page = 0; page < window->tabs()->count(); ++page) {
        window->tabs()->setCurrentIndex(page);
        settle();
        shot(window.get(), QStringLiteral("window-2-scene-%1").arg(page));
    }
    window->tabs()->setCurrentIndex(0);
    for (const TransferPanel::Page colours : {TransferPanel::k_gradients, TransferPanel::k_shapes}) {
        window->transferPanel()->showPage(colours);
        shot(window->transferPanel(), QStringLiteral("panel-colours-%1").arg(int(colours)));
    }
    for (QDockWidget* dock : window->findChildren<QDockWidget*>()) {
        dock->show();
        dock->raise();
        settle();
        QTest::qWait(400);  // thumbnails, facts of the limits
        shot(window.get(), QStringLiteral("window-3-dock-") + dock->objectName());
    }
    for (const Arrangement arrangement : {Arrangement::one_and_three, Arrangement::single}) {
        window->views()->setArrangement(arrangement);
        settle();
        shot(window.get(), QStringLiteral("window-4-arrangement-%1").arg(int(arrangement)));
    }
    window->views()->setArrangement(Arrangement::four);
    window->messageBar()->showError(
        QStringLiteral("part.raw has 207361 bytes, but 72x60x48 voxels of u8 take 207360; "
                       "say --raw WxHxD:TYPE with numbers that fit."));
    shot(window.get(), QStringLiteral("window-5-error"));
    window->messageBar()->ask(QStringLiteral("Lacuna did not end as it should. What was open was last kept at 12:03."),
                              {{SessionFeature::tr("Restore"), [] {}}, {SessionFeature::tr("Discard"), [] {}}});
    window->bench()->tasks()->progress(window->bench()->tasks()->begin(ImportFeature::tr("Anonymising"), [] {}), 0.4);
    shot(window.get(), QStringLiteral("window-6-question"));
    window->messageBar()->dismiss();
    window->resize(1280, 800);
    settle();
    for (int page = 0; page < window->tabs()->count(); ++page) {
        window->tabs()->setCurrentIndex(page);
        shot(window.get(), QStringLiteral("window-7-small-%1").arg(page));
    }
    int number = 0;
    for (QAction* action : window->menuBar()->actions())
        if (action->menu() && action->isVisible())
            menus(action->menu(), QStringLiteral("menu-%1-%2").arg(++number).arg(plain_text(action->text())));
}

TEST_F(GalleryTest, EveryDialog) {
    open(k_casting);
    QTemporaryDir folder;
    for_each_dialog_page(*window, folder.path(), [&](QDialog& dialog, const char* name, int page, int pages) {
        shot(&dialog, QStringLiteral("dialog-%1%2")
                          .arg(QLatin1String(name))
                          .arg(pages > 0 ? QStringLiteral("-%1").arg(page) : QString()));
    });
}

}  // namespace
}  // namespace lacuna::ui::test
