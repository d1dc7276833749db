#include "ui/theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>

namespace lacuna::ui {

void apply_theme(QApplication& application) {
    application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QPalette palette;
    palette.setColor(QPalette::Window, theme::k_window);
    palette.setColor(QPalette::WindowText, theme::k_text);
    palette.setColor(QPalette::Base, theme::k_base);
    palette.setColor(QPalette::AlternateBase, QColor(32, 35, 40));
    palette.setColor(QPalette::Text, theme::k_text);
    palette.setColor(QPalette::PlaceholderText, theme::k_dim);
    palette.setColor(QPalette::Button, QColor(50, 54, 61));
    palette.setColor(QPalette::ButtonText, theme::k_text);
    palette.setColor(QPalette::BrightText, Qt::white);
    palette.setColor(QPalette::ToolTipBase, QColor(52, 57, 64));
    palette.setColor(QPalette::ToolTipText, theme::k_text);
    palette.setColor(QPalette::Highlight, QColor(42, 110, 190));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Link, theme::k_accent);
    palette.setColor(QPalette::Light, QColor(70, 75, 84));
    palette.setColor(QPalette::Midlight, QColor(60, 65, 72));
    palette.setColor(QPalette::Mid, QColor(44, 48, 54));
    palette.setColor(QPalette::Dark, QColor(24, 26, 30));
    palette.setColor(QPalette::Shadow, QColor(14, 15, 17));
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, QColor(110, 116, 125));
    palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor(70, 75, 82));
    application.setPalette(palette);
    application.setStyleSheet(QStringLiteral(
        "QToolTip { color: #dee2e8; background: #343940; border: 1px solid #4a515b; padding: 3px; }"
        "QMainWindow::separator { background: #1b1d21; width: 5px; height: 5px; }"
        "QSplitter::handle { background: #1b1d21; }"
        "QDockWidget { titlebar-close-icon: none; }"
        "QDockWidget::title { background: #2b2f35; padding: 5px 8px; }"
        "QGroupBox { border: 1px solid #3e434b; border-radius: 4px; margin-top: 9px; padding-top: 5px; }"
        "QGroupBox::title { subcontrol-origin: margin; left: 8px; padding: 0 3px; color: #aab2be; }"
        "QStatusBar::item { border: none; }"
        "QHeaderView::section { background: #2f343b; color: #c6ccd6; border: none; border-right: 1px solid #3e434b;"
        " padding: 3px 6px; }"
        "QTableView { gridline-color: #33383f; selection-background-color: #2a6ebe; }"));
}

}  // namespace lacuna::ui
