#include "ui/number_text.h"

#include <QLocale>
#include <QRegularExpression>

namespace lacuna::ui {

QString number_text(double value, char format, int digits) {
    return QString::number(value, format, digits).replace(QLatin1Char('.'), QLocale().decimalPoint());
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
