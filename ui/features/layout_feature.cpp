#include "ui/features/layout_feature.h"

#include <QEvent>
#include <QLayout>
#include <QScreen>
#include <algorithm>

#include "ui/preferences.h"
#include "ui/theme_control.h"
#include "ui/tool_bar.h"
#include "ui/widgets/panel_scroll.h"

namespace lacuna::ui {

using Menu = Workbench::Menu;

namespace {
constexpr QSize k_first_size{1480, 940};
constexpr int k_scene_width = 380;
constexpr double k_most_below = 0.3;  ///< of the window's height for the panels below the views

/// Gives the panels below the views the height at which none of them is scrolled, where the window has it.
void fit_panels_below(QMainWindow* window) {
    QDockWidget* shown = nullptr;
    int height = 0;
    for (QDockWidget* dock : window->findChildren<QDockWidget*>()) {
        const auto* scroll = dynamic_cast<const PanelScroll*>(dock->widget());
        if (!scroll || dock->isHidden() || dock->isFloating() ||
            window->dockWidgetArea(dock) != Qt::BottomDockWidgetArea)
            continue;
        height =
            std::max(height, scroll->wholePanel().height() + dock->sizeHint().height() - scroll->sizeHint().height());
        shown = dock;
    }
    if (shown) window->resizeDocks({shown}, {std::min(height, int(k_most_below * window->height()))}, Qt::Vertical);
}
}  // namespace

LayoutFeature::LayoutFeature(Workbench& bench) : QObject(&bench), bench_(bench), arrangements_(new QActionGroup(this)) {
    addArrangements();
    addThemes();
    QMenu* panels = bench.submenu(Menu::view, Workbench::tr("&Panels"));
    bar_ = make_tool_bar(bench.window());
    panels->addAction(bar_->toggleViewAction());
    panels->addSeparator();
    bench.addAlways(panels, tr("&Reset the layout"), QKeySequence(QStringLiteral("Ctrl+Shift+0")), this,
                    &LayoutFeature::reset);
    first_state_ = bench.window()->saveState();
    bench.window()->restoreState(preferences::window_state());
    bench.views()->restoreState(preferences::views_state());
    // Docks stand side by side until they are stacked, which widened the window and its least size: both are found
    // anew.
    QMainWindow* window = bench.window();
    window->setMinimumSize(0, 0);
    window->layout()->invalidate();
    window->layout()->activate();
    if (!window->restoreGeometry(preferences::window_geometry())) {
        window->resize(k_first_size.boundedTo(window->screen()->availableSize()));
        if (auto* scene = window->findChild<QDockWidget*>(QStringLiteral("scene")))
            window->resizeDocks({scene}, {k_scene_width}, Qt::Horizontal);
        fit_panels_below(window);
    } else {
        window->restoreState(preferences::window_state());  // the panels' sizes are those within this size
    }
    bench.window()->installEventFilter(this);
}

void LayoutFeature::addArrangements() {
    QMenu* menu = bench_.submenu(Menu::view, tr("&Arrangement"));
    struct Entry {
        Arrangement arrangement;
        QString text, words;
        int key;
        Icon icon;
    };
    const Entry entries[] = {{Arrangement::four, tr("&Four views"), tr("Four"), Qt::Key_F5, Icon::four_views},
                             {Arrangement::one_and_three, tr("&Large 3D view and three slices"), tr("One and three"),
                              Qt::Key_F6, Icon::one_and_three},
                             {Arrangement::single, tr("&One view"), tr("One"), Qt::Key_F7, Icon::single_view}};
    for (const Entry& entry : entries) {
        QAction* action = bench_.add(menu, entry.text, QKeySequence(entry.key), this,
                                     [this, wanted = entry.arrangement] { bench_.views()->setArrangement(wanted); });
        action->setCheckable(true);
        action->setData(int(entry.arrangement));
        offer_tool(action, ToolGroup::layout, entry.icon, entry.words);
        arrangements_->addAction(action);
    }
    const auto show = [this] {
        for (QAction* action : arrangements_->actions())
            action->setChecked(action->data().toInt() == int(bench_.views()->arrangement()));
    };
    connect(bench_.views(), &FourUp::arrangementChanged, this, show);
    show();
}

void LayoutFeature::addThemes() {
    QMenu* menu = bench_.submenu(Menu::view, tr("&Theme"));
    auto* group = new QActionGroup(this);
    const std::pair<ThemeChoice, QString> choices[] = {{ThemeChoice::system, tr("As the &system")},
                                                       {ThemeChoice::dark, tr("&Dark")},
                                                       {ThemeChoice::light, tr("&Light")}};
    ThemeControl* control = ThemeControl::instance();
    for (const auto& [choice, text] : choices) {
        QAction* action =
            bench_.addAlways(menu, text, {}, control, [control, choice = choice] { control->choose(choice); });
        action->setCheckable(true);
        action->setChecked(control->choice() == choice);
        group->addAction(action);
        connect(control, &ThemeControl::choiceChanged, action,
                [action, choice = choice](ThemeChoice now) { action->setChecked(now == choice); });
    }
}

void LayoutFeature::reset() {
    bench_.window()->restoreState(first_state_);
    bench_.views()->reset();
    fit_panels_below(bench_.window());
    preferences::forget_window();
}

void LayoutFeature::save() {
    preferences::set_window(bench_.window()->saveGeometry(), bench_.window()->saveState());
    preferences::set_views_state(bench_.views()->saveState());
}

bool LayoutFeature::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Close) save();
    return QObject::eventFilter(watched, event);
}

}  // namespace lacuna::ui
