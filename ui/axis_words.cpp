#include "ui/axis_words.h"

#include <QCoreApplication>

#include "ui/number_text.h"

namespace lacuna::ui {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(AxisWords)
};

QString text_of(std::string_view words) { return QString::fromUtf8(words.data(), qsizetype(words.size())); }

}  // namespace

QString coordinate_words(AxisNames names, int axis, double mm) {
    const AxisPlace place = place_along(names, axis, mm);
    return QStringLiteral("%1 %2").arg(text_of(place.name), number_text(place.mm, 'f', 2));
}

QString standard_view_name(AxisNames names, char side) {
    const bool patient = names == AxisNames::patient;
    const auto from = [](int axis, bool negative) {
        return Words::tr("From %1", "a standard view; %1: the end of an axis, +X")
            .arg(text_of(axis_end(AxisNames::xyz, axis, negative)));
    };
    switch (side) {
        case 'A':
            return patient ? Words::tr("Front (anterior)") : from(1, true);
        case 'P':
            return patient ? Words::tr("Back (posterior)") : from(1, false);
        case 'L':
            return patient ? Words::tr("Left") : from(0, false);
        case 'R':
            return patient ? Words::tr("Right") : from(0, true);
        case 'H':
            return patient ? Words::tr("Head") : from(2, false);
        default:
            return patient ? Words::tr("Feet") : from(2, true);
    }
}

}  // namespace lacuna::ui
