#include "ui/number_text.h"

#include <QLocale>
#include <QRegularExpression>
#include <cmath>

namespace lacuna::ui {

QString number_text(double value, char format, int digits) {
    return QString::number(value, format, digits).replace(QLatin1Char('.'), QLocale().decimalPoint());
}

namespace {
/// Decimals beyond those shown that have to be zero for a number to count as written with fewer: what is left of a
/// dragged value looks like that once in ten thousand.
constexpr int k_zeros = 4;
}  // namespace

QString as_typed_text(double value, int least) {
    const int most = least + k_more_decimals;
    const double fine = std::round(value * std::pow(10.0, most + k_zeros));  // so 0.1 + 0.2 is 0.3
    for (int decimals = least; decimals <= most; ++decimals)
        if (std::fmod(fine, std::pow(10.0, most + k_zeros - decimals)) == 0) return number_text(value, 'f', decimals);
    return number_text(value, 'f', least);
}

QString count_text(quint64 count) { return QLocale().toString(count); }

QString with_decimal_marks(QString words) {
    static const QRegularExpression decimal(QStringLiteral("(?<![\\w.])(\\d+)\\.(\\d+)(?![.\\d])"));
    return words.replace(decimal, QStringLiteral("\\1") + QLocale().decimalPoint() + QStringLiteral("\\2"));
}

std::optional<double> typed_number(const QString& text) {
    bool ok = false;
    const double value = text.trimmed().replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&ok);
    return ok ? std::optional(value) : std::nullopt;
}

void NumberBox::setShownDecimals(int least) {
    least_ = least;
    setDecimals(least + k_more_decimals + k_zeros);
}

QString NumberBox::textFromValue(double value) const {
    return least_ ? as_typed_text(value, *least_) : QDoubleSpinBox::textFromValue(value);
}

QValidator::State NumberBox::validate(QString& input, int& position) const {
    const QString own = locale().decimalPoint();
    const QString unit = suffix();
    const bool has_unit = !unit.isEmpty() && input.endsWith(unit);
    QString number = has_unit ? input.chopped(unit.size()) : input;
    number.replace(own == QLatin1String(",") ? QLatin1Char('.') : QLatin1Char(','), own);
    input = has_unit ? number + unit : number;
    return QDoubleSpinBox::validate(input, position);
}

}  // namespace lacuna::ui
