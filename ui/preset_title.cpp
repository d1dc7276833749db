#include "ui/preset_title.h"

#include <QCoreApplication>

namespace lacuna::ui {

namespace {
// For the translators: preset_names().
[[maybe_unused]] constexpr const char* k_names[] = {
    QT_TRANSLATE_NOOP("PresetName", "bone"),  QT_TRANSLATE_NOOP("PresetName", "soft-tissue"),
    QT_TRANSLATE_NOOP("PresetName", "skin"),  QT_TRANSLATE_NOOP("PresetName", "lung"),
    QT_TRANSLATE_NOOP("PresetName", "angio"), QT_TRANSLATE_NOOP("PresetName", "metal"),
    QT_TRANSLATE_NOOP("PresetName", "voids"), QT_TRANSLATE_NOOP("PresetName", "grey")};
}  // namespace

QString preset_title(const std::string& name) { return QCoreApplication::translate("PresetName", name.c_str()); }

QString preset_title(const PresetEntry& entry) {
    return entry.built_in() ? preset_title(entry.name) : QString::fromStdString(entry.name);
}

}  // namespace lacuna::ui
