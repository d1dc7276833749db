// The German window: every control is named in German, and its longer words have room at 1280x720.
#include <QAbstractButton>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QTableView>

#include "core/classify/colour_maps.h"
#include "tests/gui/window_fixture.h"
#include "ui/colour_map_titles.h"
#include "ui/language.h"
#include "ui/panels/speed_panel.h"
#include "ui/preferences.h"

namespace lacuna::ui::test {
namespace {

class GermanWindow : public testing::Test {
protected:
    void TearDown() override {
        window_.reset();
        use("en");
        preferences::forget_window();
    }
    static void use(const char* code) {
        preferences::set_language(QLatin1String(code));
        Language::instance()->apply();
    }
    /// A new window in a language, with a part in it and a range and a cut set.
    MainWindow& made(const char* code) {
        window_.reset();
        preferences::forget_window();
        use(code);
        window_ = std::make_unique<MainWindow>([](const JobContext&) { return std::make_shared<Engine>(nullptr); });
        window_->resize(1280, 720);
        window_->show();
        QSignalSpy finished(window_->loader(), &LoadController::finished);
        window_->openInput(k_casting);
        EXPECT_TRUE(finished.wait(k_patience_ms));
        window_->rangesPanel()->addRange();
        window_->cutsPanel()->addCut();
        QApplication::processEvents();
        return *window_;
    }
    /// Until every widget has the place its words ask for: a frame's may have changed with the last event.
    static void settle() {
        QApplication::processEvents();
        QApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    }
    /// Calls `check` with every page of the panels and every dock in view, one after the other.
    template <class Check>
    static void eachPanel(MainWindow& window, Check&& check) {
        for (int page = 0; page < window.tabs()->count(); ++page) {
            window.tabs()->setCurrentIndex(page);
            settle();
            check("page " + window.tabs()->tabText(page).toStdString());
        }
        for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
            dock->show();
            dock->raise();
            settle();
            check("dock " + dock->windowTitle().toStdString());
        }
    }
    std::unique_ptr<MainWindow> window_;
};

struct Named {
    std::string kind;
    QString name, description;
};

std::vector<Named> names_of(const MainWindow& window) {
    std::vector<Named> all;
    for (const QWidget* widget : window.findChildren<QWidget*>())
        all.push_back({widget->metaObject()->className(), widget->accessibleName(), widget->accessibleDescription()});
    return all;
}

TEST_F(GermanWindow, ColourMapsHaveGermanNames) {
    (void)made("de");
    for (const std::string& name : colour_map_names()) {
        if (name == "cubehelix") continue;  // Green's own name for it
        EXPECT_NE(colour_map_title(name), QString::fromStdString(name));
    }
    const QAction* meadow = nullptr;
    for (const QMenu* menu : window_->findChildren<QMenu*>())
        for (const QAction* action : menu->actions())
            if (action->text() == colour_map_title("meadow")) meadow = action;
    EXPECT_TRUE(meadow);
}

TEST_F(GermanWindow, DefectsAreFilteredByTheNamesOfTheirColumns) {
    InspectionFeature* inspection = made("de").inspection();
    QSignalSpy finished(inspection, &InspectionFeature::finished);
    inspection->inspect(inspection->panel()->form()->criteria().detection);
    ASSERT_TRUE(finished.wait(k_patience_ms));
    const auto rows_of = [&](const QString& words) {
        for (QLineEdit* field : inspection->panel()->findChildren<QLineEdit*>())
            if (field->placeholderText().contains(QStringLiteral("Durchmesser"))) field->setText(words);
        return inspection->panel()->table()->model()->rowCount();
    };
    ASSERT_GT(rows_of({}), 0);
    for (const char* name : {"Durchmesser", "durchmesser mm", "diameter"}) {
        EXPECT_GT(rows_of(QLatin1String(name) + QStringLiteral(" > 0,001")), 0) << name;
        EXPECT_EQ(rows_of(QLatin1String(name) + QStringLiteral(" > 1000")), 0) << name;
    }
}

TEST_F(GermanWindow, ControlsAreNamedInGerman) {
    const std::vector<Named> english = names_of(made("en")), german = names_of(made("de"));
    ASSERT_EQ(english.size(), german.size());
    int named = 0;
    for (std::size_t i = 0; i < english.size(); ++i) {
        ASSERT_EQ(english[i].kind, german[i].kind);
        ASSERT_EQ(english[i].name.isEmpty(), german[i].name.isEmpty()) << english[i].name.toStdString();
        for (const auto& [in_english, in_german] :
             {std::pair{english[i].name, german[i].name}, {english[i].description, german[i].description}}) {
            static const QString same = QStringLiteral("Gamma: Gamma");
            // Single words may be the same in both.
            if (!in_english.contains(QLatin1Char(' ')) || in_english == same) continue;
            ++named;
            EXPECT_NE(in_english, in_german) << english[i].kind;
        }
    }
    EXPECT_GT(named, 60);
}

TEST_F(GermanWindow, WordsHaveRoom) {
    for (const char* code : {"en", "de"}) {
        MainWindow& window = made(code);
        ASSERT_EQ(window.size(), QSize(1280, 720)) << "the panels ask for more than the screen has";
        std::set<std::string> cut;
        eachPanel(window, [&](const std::string& where) {
            for (const QWidget* widget : window.findChildren<QWidget*>()) {
                const auto* label = qobject_cast<const QLabel*>(widget);
                const bool elided = label && label->sizePolicy().horizontalPolicy() == QSizePolicy::Ignored;
                const bool words = qobject_cast<const QAbstractButton*>(widget) || (label && !label->wordWrap());
                if (!words || elided || !widget->isVisible() || widget->visibleRegion().isEmpty()) continue;
                const QString text = widget->property("text").toString();
                if (!text.isEmpty() && widget->width() < widget->minimumSizeHint().width())
                    cut.insert(where + ": " + text.toStdString());
            }
            for (const QComboBox* box : window.findChildren<QComboBox*>())
                if (box->isVisible() && box->width() < box->minimumSizeHint().width())
                    cut.insert(where + ": " + box->accessibleName().toStdString());
            for (const QTableView* table : window.findChildren<QTableView*>()) {
                const QHeaderView* header = table->horizontalHeader();
                if (!table->isVisible() || header->isHidden()) continue;
                for (int section = 0; section < header->count(); ++section) {
                    const QString title =
                        table->model()->headerData(section, Qt::Horizontal, Qt::DisplayRole).toString();
                    const int needed = header->fontMetrics().horizontalAdvance(title);
                    if (!header->isSectionHidden(section) && header->sectionSize(section) < needed)
                        cut.insert(where + ", column: " + title.toStdString());
                }
            }
        });
        for (const std::string& words : cut) ADD_FAILURE() << code << ", cut off on " << words;
    }
}

}  // namespace
}  // namespace lacuna::ui::test
