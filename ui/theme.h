#pragma once

#include <QColor>

class QApplication;

namespace lacuna::ui {

/// Colours the widgets share.
namespace theme {
inline const QColor k_window(36, 39, 44), k_base(27, 29, 33), k_text(222, 226, 232), k_dim(140, 147, 158);
inline const QColor k_accent(64, 156, 255), k_border(62, 67, 75), k_warning(240, 180, 70), k_error(232, 96, 84);
inline const QColor k_axial(232, 104, 96), k_coronal(112, 200, 120), k_sagittal(104, 160, 255), k_volume(224, 196, 120);
}  // namespace theme

/// Fusion style in a dark palette.
void apply_theme(QApplication& application);

}  // namespace lacuna::ui
