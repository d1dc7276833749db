#pragma once

#include <QIcon>

namespace lacuna::ui {

/// The signs of the tool bar, drawn by the program itself: sharp at every scale, in the colours of the theme in force
/// when they are painted.
enum class Icon {
    folder,
    file,
    save,
    picture,
    undo,
    redo,
    four_views,
    one_and_three,
    single_view,
    reset_view,
    range,
    cut,
    regions,
    inspect,
    measure,
    search,
    settings,
    help
};

QIcon make_icon(Icon icon);

}  // namespace lacuna::ui
