#pragma once

#include <QColor>

class QApplication;

namespace lacuna::ui {

enum class Scheme { dark, light };

/// Every colour the widgets draw with, of one scheme. Text is readable on what it stands on (contrast 4.5:1 and more),
/// and so are edges of controls (3:1), by WCAG 2.1, 1.4.3 and 1.4.11.
struct ThemeColors {
    QColor window, base, alternate, button, tooltip, title;  ///< surfaces
    QColor text, dim, disabled;                              ///< words on them; disabled ones at least 2:1
    QColor accent, highlight, highlighted_text;              ///< focus and links; what is chosen
    QColor control;                                          ///< edges of boxes, grooves, handles
    QColor border, separator;                                ///< quiet lines between parts
    QColor plot_fill, plot_line;                             ///< histogram, curve
    QColor warning, error, good;                             ///< signs
};

namespace theme {

/// The colours in force.
const ThemeColors& colors();
const ThemeColors& colors_of(Scheme scheme);
Scheme scheme();

/// Inks on pictures. Pictures are dark in both schemes, because grey levels are read best against black; use these for
/// what is drawn over voxels only, and colors() for everything else.
inline const QColor k_window(36, 39, 44), k_base(27, 29, 33), k_text(222, 226, 232), k_dim(140, 147, 158);
inline const QColor k_accent(64, 156, 255), k_border(62, 67, 75), k_warning(240, 180, 70), k_error(232, 96, 84);
inline const QColor k_axial(232, 104, 96), k_coronal(112, 200, 120), k_sagittal(104, 160, 255), k_volume(224, 196, 120);

/// Contrast of two opaque colours by WCAG 2.1: 1 (none) to 21 (black on white).
double contrast(const QColor& a, const QColor& b);

}  // namespace theme

/// Fusion style with clearly drawn controls, in the colours of a scheme. May be called again at any time: everything
/// shown changes at once.
void apply_theme(QApplication& application, Scheme scheme = Scheme::dark);

}  // namespace lacuna::ui
