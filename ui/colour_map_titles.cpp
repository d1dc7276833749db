#include "ui/colour_map_titles.h"

#include <QCoreApplication>

namespace lacuna::ui {

namespace {
// For the translators: the names of colour_map_names().
[[maybe_unused]] constexpr const char* k_names[] = {
    QT_TRANSLATE_NOOP("ColourMap", "grey"),     QT_TRANSLATE_NOOP("ColourMap", "heat"),
    QT_TRANSLATE_NOOP("ColourMap", "meadow"),   QT_TRANSLATE_NOOP("ColourMap", "dusk"),
    QT_TRANSLATE_NOOP("ColourMap", "ocean"),    QT_TRANSLATE_NOOP("ColourMap", "bone"),
    QT_TRANSLATE_NOOP("ColourMap", "blood"),    QT_TRANSLATE_NOOP("ColourMap", "cubehelix"),
    QT_TRANSLATE_NOOP("ColourMap", "cold-warm")};
}  // namespace

QString colour_map_title(const std::string& name) { return QCoreApplication::translate("ColourMap", name.c_str()); }

}  // namespace lacuna::ui
