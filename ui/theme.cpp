#include "ui/theme.h"

#include <QApplication>
#include <QPalette>
#include <cmath>

#include "ui/theme_style.h"

namespace lacuna::ui {

namespace {

const ThemeColors k_dark{
    .window = {36, 39, 44},
    .base = {27, 29, 33},
    .alternate = {32, 35, 40},
    .button = {50, 54, 61},
    .tooltip = {52, 57, 64},
    .title = {43, 47, 53},
    .text = {222, 226, 232},
    .dim = {160, 167, 178},
    .disabled = {118, 124, 134},
    .accent = {92, 172, 255},
    .highlight = {34, 98, 176},
    .highlighted_text = {255, 255, 255},
    .control = {134, 142, 154},
    .border = {62, 67, 75},
    .separator = {27, 29, 33},
    .plot_fill = {90, 100, 116},
    .plot_line = {230, 234, 240},
    .warning = {240, 180, 70},
    .error = {255, 128, 116},
    .good = {84, 204, 150},
};

const ThemeColors k_light{
    .window = {242, 244, 247},
    .base = {255, 255, 255},
    .alternate = {246, 248, 250},
    .button = {228, 232, 238},
    .tooltip = {255, 255, 255},
    .title = {228, 232, 238},
    .text = {26, 30, 36},
    .dim = {84, 92, 104},
    .disabled = {140, 147, 158},
    .accent = {8, 92, 188},
    .highlight = {26, 104, 196},
    .highlighted_text = {255, 255, 255},
    .control = {104, 112, 124},
    .border = {196, 202, 211},
    .separator = {212, 217, 224},
    .plot_fill = {176, 186, 200},
    .plot_line = {40, 46, 56},
    .warning = {138, 82, 0},
    .error = {180, 34, 22},
    .good = {8, 112, 70},
};

Scheme g_scheme = Scheme::dark;

QPalette palette_of(const ThemeColors& c) {
    QPalette palette;
    palette.setColor(QPalette::Window, c.window);
    palette.setColor(QPalette::WindowText, c.text);
    palette.setColor(QPalette::Base, c.base);
    palette.setColor(QPalette::AlternateBase, c.alternate);
    palette.setColor(QPalette::Text, c.text);
    palette.setColor(QPalette::PlaceholderText, c.dim);
    palette.setColor(QPalette::Button, c.button);
    palette.setColor(QPalette::ButtonText, c.text);
    palette.setColor(QPalette::BrightText, c.error);
    palette.setColor(QPalette::ToolTipBase, c.tooltip);
    palette.setColor(QPalette::ToolTipText, c.text);
    palette.setColor(QPalette::Highlight, c.highlight);
    palette.setColor(QPalette::HighlightedText, c.highlighted_text);
    palette.setColor(QPalette::Link, c.accent);
    palette.setColor(QPalette::LinkVisited, c.accent);
    palette.setColor(QPalette::Light, c.button.lighter(120));
    palette.setColor(QPalette::Midlight, c.button.lighter(108));
    palette.setColor(QPalette::Mid, c.border);
    palette.setColor(QPalette::Dark, c.window.darker(150));
    palette.setColor(QPalette::Shadow, c.window.darker(230));
    for (const QPalette::ColorRole role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::PlaceholderText})
        palette.setColor(QPalette::Disabled, role, c.disabled);
    palette.setColor(QPalette::Disabled, QPalette::Base, c.window);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, c.border);
    palette.setColor(QPalette::Disabled, QPalette::HighlightedText, c.text);
    return palette;
}

QString sheet_of(const ThemeColors& c) {
    QString sheet = QStringLiteral(
        "QToolTip { color: @text; background: @tooltip; border: 1px solid @control; padding: 3px; }"
        "QMainWindow::separator { background: @separator; width: 5px; height: 5px; }"
        "QSplitter::handle { background: @separator; }"
        "QDockWidget::title { background: @title; padding: 5px 8px; }"
        "QGroupBox { border: 1px solid @border; border-radius: 4px; margin-top: 9px; padding-top: 5px; }"
        "QGroupBox::title { subcontrol-origin: margin; left: 8px; padding: 0 3px; color: @dim; }"
        "QStatusBar::item { border: none; }"
        "QToolBar { background: @title; border: none; border-bottom: 1px solid @border; padding: 2px; spacing: 1px; }"
        "QHeaderView::section { background: @button; color: @text; border: none; border-right: 1px solid @border;"
        " padding: 3px 6px; }"
        "QTableView { gridline-color: @border; selection-background-color: @highlight;"
        " selection-color: @chosen; }");
    const std::pair<const char*, QColor> names[] = {{"@text", c.text},
                                                    {"@tooltip", c.tooltip},
                                                    {"@control", c.control},
                                                    {"@separator", c.separator},
                                                    {"@title", c.title},
                                                    {"@border", c.border},
                                                    {"@dim", c.dim},
                                                    {"@button", c.button},
                                                    {"@highlight", c.highlight},
                                                    {"@chosen", c.highlighted_text}};
    for (const auto& [name, color] : names) sheet.replace(QLatin1String(name), color.name());
    return sheet;
}

/// WCAG 2.1, relative luminance.
double luminance(const QColor& color) {
    const auto linear = [](double share) {
        return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

}  // namespace

namespace theme {

const ThemeColors& colors_of(Scheme scheme) { return scheme == Scheme::light ? k_light : k_dark; }
const ThemeColors& colors() { return colors_of(g_scheme); }
Scheme scheme() { return g_scheme; }

double contrast(const QColor& a, const QColor& b) {
    const double one = luminance(a) + 0.05, other = luminance(b) + 0.05;
    return one > other ? one / other : other / one;
}

}  // namespace theme

void apply_theme(QApplication& application, Scheme scheme) {
    // The style is made once: to replace it would polish every widget twice.
    static ThemeStyle* style = nullptr;
    g_scheme = scheme;
    if (!style) {
        style = new ThemeStyle;
        application.setStyle(style);  // which it then owns
    }
    application.setPalette(palette_of(theme::colors()));
    application.setStyleSheet(sheet_of(theme::colors()));
}

}  // namespace lacuna::ui
