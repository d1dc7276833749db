#pragma once

#include <QDoubleSpinBox>
#include <QString>
#include <optional>

namespace lacuna::ui {

/// A number as the window shows it: with the decimal mark of its language, and no marks between thousands, which would
/// look like one. Every measured number on screen goes through here; files keep the point.
/// @param format  'f', 'e' or 'g' as of QString::number; @param digits  decimals, or for 'g' significant digits
QString number_text(double value, char format = 'g', int digits = 6);

/// A number by as many decimals as it was written with, from `least` to k_more_decimals more; one of more decimals
/// than that (a dragged or computed one) is rounded to `least`.
QString as_typed_text(double value, int least);
inline constexpr int k_more_decimals = 4;

/// How many of something, its thousands set apart as the language does.
QString count_text(quint64 count);

/// Words of the core with every decimal number in them (0.5, not 1.2.3) written with the language's mark.
QString with_decimal_marks(QString words);

/// What a person typed, with either decimal mark; nullopt if it is no number.
std::optional<double> typed_number(const QString& text);

/// A spin box that takes either decimal mark: the mark that is not the language's would else count as one between
/// thousands, and 0.5 typed in German as 5.
class NumberBox : public QDoubleSpinBox {
    Q_OBJECT
public:
    using QDoubleSpinBox::QDoubleSpinBox;
    /// Takes k_more_decimals more than it shows of a number that does not need them, so that what was typed comes back
    /// as it was typed.
    void setShownDecimals(int least);
    QString textFromValue(double value) const override;

protected:
    QValidator::State validate(QString& input, int& position) const override;

private:
    std::optional<int> least_;
};

}  // namespace lacuna::ui
