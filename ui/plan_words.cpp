#include "ui/plan_words.h"

#include <QCoreApplication>
#include <QStringList>

#include "ui/number_text.h"

namespace lacuna::ui {

namespace {

// The words of structure_names(), of difference_in_words()'s keys, and of their values.
[[maybe_unused]] constexpr const char* k_structures[] = {
    QT_TRANSLATE_NOOP("PlanStructure", "none"),   QT_TRANSLATE_NOOP("PlanStructure", "macrocells"),
    QT_TRANSLATE_NOOP("PlanStructure", "octree"), QT_TRANSLATE_NOOP("PlanStructure", "pyramid"),
    QT_TRANSLATE_NOOP("PlanStructure", "pc"),     QT_TRANSLATE_NOOP("PlanStructure", "acd"),
    QT_TRANSLATE_NOOP("PlanStructure", "eacd"),   QT_TRANSLATE_NOOP("PlanStructure", "leap"),
    QT_TRANSLATE_NOOP("PlanStructure", "visible")};
constexpr const char* k_keys[] = {QT_TRANSLATE_NOOP("PlanKey", "mode %1"),
                                  QT_TRANSLATE_NOOP("PlanKey", "step %1"),
                                  QT_TRANSLATE_NOOP("PlanKey", "sampler %1"),
                                  QT_TRANSLATE_NOOP("PlanKey", "gradient %1"),
                                  QT_TRANSLATE_NOOP("PlanKey", "integration %1"),
                                  QT_TRANSLATE_NOOP("PlanKey", "refine %1"),
                                  QT_TRANSLATE_NOOP("PlanKey", "refine steps %1"),
                                  QT_TRANSLATE_NOOP("PlanKey", "ert %1"),
                                  QT_TRANSLATE_NOOP("PlanKey", "sparse %1"),
                                  QT_TRANSLATE_NOOP("PlanKey", "sparse aware %1"),
                                  QT_TRANSLATE_NOOP("PlanKey", "cells %1"),
                                  QT_TRANSLATE_NOOP("PlanKey", "directions %1"),
                                  QT_TRANSLATE_NOOP("PlanKey", "voxel gradient %1"),
                                  QT_TRANSLATE_NOOP("PlanKey", "homogeneity %1"),
                                  QT_TRANSLATE_NOOP("PlanKey", "homogeneity angle %1"),
                                  QT_TRANSLATE_NOOP("PlanKey", "brick %1"),
                                  QT_TRANSLATE_NOOP("PlanKey", "kernel %1")};
[[maybe_unused]] constexpr const char* k_values[] = {QT_TRANSLATE_NOOP("PlanValue", "nearest"),
                                                     QT_TRANSLATE_NOOP("PlanValue", "linear"),
                                                     QT_TRANSLATE_NOOP("PlanValue", "adaptive"),
                                                     QT_TRANSLATE_NOOP("PlanValue", "bisect"),
                                                     QT_TRANSLATE_NOOP("PlanValue", "regula-falsi"),
                                                     QT_TRANSLATE_NOOP("PlanValue", "newton"),
                                                     QT_TRANSLATE_NOOP("PlanValue", "regula-falsi-plain"),
                                                     QT_TRANSLATE_NOOP("PlanValue", "cubic"),
                                                     QT_TRANSLATE_NOOP("PlanValue", "central,on-the-fly"),
                                                     QT_TRANSLATE_NOOP("PlanValue", "central,stored"),
                                                     QT_TRANSLATE_NOOP("PlanValue", "sobel,on-the-fly"),
                                                     QT_TRANSLATE_NOOP("PlanValue", "sobel,stored"),
                                                     QT_TRANSLATE_NOOP("PlanValue", "central"),
                                                     QT_TRANSLATE_NOOP("PlanValue", "sobel"),
                                                     QT_TRANSLATE_NOOP("PlanValue", "gaussian"),
                                                     QT_TRANSLATE_NOOP("PlanValue", "riemann"),
                                                     QT_TRANSLATE_NOOP("PlanValue", "preintegrated"),
                                                     QT_TRANSLATE_NOOP("PlanValue", "lossless"),
                                                     QT_TRANSLATE_NOOP("PlanValue", "confirmed"),
                                                     QT_TRANSLATE_NOOP("PlanValue", "published"),
                                                     QT_TRANSLATE_NOOP("PlanValue", "true"),
                                                     QT_TRANSLATE_NOOP("PlanValue", "false"),
                                                     QT_TRANSLATE_NOOP("PlanValue", "mean"),
                                                     QT_TRANSLATE_NOOP("PlanValue", "shear-warp")};

QString text_of(std::string_view words) { return QString::fromUtf8(words.data(), qsizetype(words.size())); }

QString in_context(const char* context, const QString& word) {
    return QCoreApplication::translate(context, word.toUtf8().constData());
}

QString value_words(const QString& english) {
    if (english == QLatin1String("none")) return QCoreApplication::translate("PlanValue", "none", "no refinement");
    const QString own = in_context("PlanValue", english);
    return own == english ? with_decimal_marks(english) : own;
}

/// "step 0.5" by its key; nullopt where that is not known.
std::optional<QString> part_words(const QString& part) {
    for (const char* key : k_keys) {
        const QString stem = QString::fromUtf8(key).chopped(2);  // "step "
        const QString value = part.mid(stem.size());
        if (!part.startsWith(stem) || value.isEmpty() || value.contains(QLatin1Char(' '))) continue;
        return QCoreApplication::translate("PlanKey", key).arg(value_words(value));
    }
    return std::nullopt;
}

std::optional<Structure> structure_of(const QString& word) {
    for (const auto& [structure, name] : structure_names())
        if (text_of(name) == word) return structure;
    return std::nullopt;
}

/// nullopt where a part is not known and all have to be.
std::optional<QString> translated(const QString& english, bool all_known) {
    QStringList parts = english.split(QStringLiteral(", "));
    const auto structure = structure_of(parts.front());
    if (!structure && all_known) return std::nullopt;
    if (structure) parts.front() = structure_word(*structure);
    for (qsizetype i = structure ? 1 : 0; i < parts.size(); ++i) {
        const auto words = part_words(parts[i]);
        if (!words && all_known) return std::nullopt;
        parts[i] = words.value_or(with_decimal_marks(parts[i]));
    }
    return parts.join(QStringLiteral(", "));
}

}  // namespace

QString structure_word(Structure structure) { return in_context("PlanStructure", text_of(name_of(structure))); }

QString structure_title(Structure structure) {
    const QString word = structure_word(structure), name = text_of(name_of(structure));
    return word.compare(name, Qt::CaseInsensitive) == 0 ? word : QStringLiteral("%1 (%2)").arg(word, name);
}

QString plan_value(std::string_view word) { return value_words(text_of(word)); }

std::optional<QString> plan_in_own_words(const QString& english) {
    if (!english.contains(QStringLiteral(", "))) return std::nullopt;  // a structure's name alone may be anything's
    return translated(english, true);
}

QString plan_words(const QString& english) { return translated(english, false).value_or(english); }

}  // namespace lacuna::ui
