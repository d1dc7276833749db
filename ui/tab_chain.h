#pragma once

#include <QWidget>
#include <initializer_list>

namespace lacuna::ui {

/// Makes Tab visit the widgets in this order.
inline void chain_tabs(std::initializer_list<QWidget*> widgets) {
    QWidget* before = nullptr;
    for (QWidget* widget : widgets) {
        if (before) QWidget::setTabOrder(before, widget);
        before = widget;
    }
}

}  // namespace lacuna::ui
