// Numbers are shown and typed as the language of the window writes them.
#include "ui/number_text.h"

#include <QDirIterator>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QTableWidget>

#include "core/chart/axis_scale.h"
#include "tests/gui/window_fixture.h"
#include "ui/language.h"
#include "ui/models/defect_model.h"
#include "ui/preferences.h"

namespace lacuna::ui::test {
namespace {

void use(const char* code) {
    preferences::set_language(QLatin1String(code));
    Language::instance()->apply();
}

class Numbers : public WindowTest {
protected:
    void SetUp() override {
        use("de");
        WindowTest::SetUp();
    }
    void TearDown() override {
        WindowTest::TearDown();
        use("en");
    }
};

TEST_F(Numbers, AreWrittenWithTheLanguagesMark) {
    EXPECT_EQ(number_text(0.25), QStringLiteral("0,25"));
    EXPECT_EQ(number_text(1234.5, 'f', 2), QStringLiteral("1234,50"));  // a point for thousands would look like a mark
    EXPECT_EQ(number_text(1.5e9, 'g', 3), QStringLiteral("1,5e+09"));
    EXPECT_EQ(number_text(std::nan("")), QStringLiteral("nan"));
    EXPECT_EQ(count_text(1234567), QStringLiteral("1.234.567"));
    EXPECT_EQ(with_decimal_marks(QStringLiteral("octree, step 0.5, ert 0.002 (1.2.840, v1.5)")),
              QStringLiteral("octree, step 0,5, ert 0,002 (1.2.840, v1.5)"));
    use("en");
    EXPECT_EQ(number_text(0.25), QStringLiteral("0.25"));
    EXPECT_EQ(number_text(1234.5, 'f', 2), QStringLiteral("1234.50"));
    EXPECT_EQ(with_decimal_marks(QStringLiteral("step 0.5")), QStringLiteral("step 0.5"));
}

TEST_F(Numbers, AreTakenWithEitherMark) {
    EXPECT_EQ(typed_number(QStringLiteral(" 0,5 ")), 0.5);
    EXPECT_EQ(typed_number(QStringLiteral("-1.5e3")), -1500.0);
    EXPECT_FALSE(typed_number(QStringLiteral("1.234,5")));
    EXPECT_FALSE(typed_number(QStringLiteral("x")));
    for (const char* language : {"de", "en"})
        for (const char* typed : {"0.5", "0,5"})
            for (const bool unit : {false, true}) {
                use(language);
                NumberBox box;
                box.setRange(-1e6, 1e6);  // wide: there Qt takes a wrong mark for one between thousands
                box.setDecimals(3);
                if (unit) box.setSuffix(QStringLiteral(" mm"));
                box.show();
                box.selectAll();
                QTest::keyClicks(&box, QString::fromLatin1(typed));
                QTest::keyClick(&box, Qt::Key_Return);
                EXPECT_EQ(box.value(), 0.5) << language << ", " << typed;
                const QString shown = box.cleanText();
                box.setValue(7);
                box.selectAll();
                QTest::keyClicks(&box, shown);  // what it shows it takes
                QTest::keyClick(&box, Qt::Key_Return);
                EXPECT_EQ(box.value(), 0.5) << shown.toStdString();
            }
}

TEST_F(Numbers, AreMadeInOnePlace) {
    // A number made into text past number_text keeps the point in every language.
    static const QRegularExpression made(
        QStringLiteral("(QString::number|\\.arg|toString|setNum|asprintf)\\([^;]*'[eEfgG]'|new QDoubleSpinBox"));
    int files = 0;
    for (QDirIterator at(QStringLiteral(LACUNA_SOURCE_DIR "/ui"), {QStringLiteral("*.cpp"), QStringLiteral("*.h")},
                         QDir::Files, QDirIterator::Subdirectories);
         at.hasNext();) {
        QFile file(at.next());
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        if (file.fileName().contains(QLatin1String("number_text"))) continue;
        ++files;
        const QString text = QString::fromUtf8(file.readAll());
        static const QRegularExpression own(QStringLiteral("number_text\\([^;]*?'[efg]'"));
        const auto found = made.match(QString(text).remove(own));
        EXPECT_FALSE(found.hasMatch()) << file.fileName().toStdString() << ": " << found.captured().toStdString();
    }
    EXPECT_GT(files, 100);
}

TEST_F(Numbers, OfChartsHaveTheAxissMark) {
    Axis axis;
    axis.decimal_mark = ',';
    Extent extent;
    extent.add(0, axis.scale);
    extent.add(1, axis.scale);
    QStringList labels;
    for (const Tick& tick : AxisScale(axis, extent, 0, 100).ticks(5)) labels << QString::fromStdString(tick.label);
    EXPECT_TRUE(labels.contains(QStringLiteral("0,2"))) << labels.join(' ').toStdString();
}

TEST_F(Numbers, OfAWholeWindowHaveADecimalComma) {
    open(k_casting);
    window->views()->setArrangement(Arrangement::one_and_three);
    window->rangesPanel()->addRange();
    for (int page = 0; page < window->tabs()->count(); ++page) window->tabs()->setCurrentIndex(page);
    settle();
    window->documents()->setCursor(glm::dvec3(1.25, 2.5, 3.75));
    static const QRegularExpression point(QStringLiteral("(?<![\\w.])\\d+\\.\\d+(?![.\\d]|\\.)"));
    const auto check = [](const QObject* of, QString text) {
        static const QRegularExpression thousands(QStringLiteral("\\b[1-9]\\d{0,2}(\\.\\d{3})+ Voxel"));
        text.remove(thousands);  // a count
        EXPECT_FALSE(point.match(text).hasMatch())
            << of->metaObject()->className() << " " << of->objectName().toStdString() << ": " << text.toStdString();
    };
    static const QRegularExpression readout(QStringLiteral("X -?\\d+,\\d\\d "));
    EXPECT_TRUE(window->statusLine()->readout().contains(readout)) << window->statusLine()->readout().toStdString();
    for (const QLabel* label : window->findChildren<QLabel*>()) {
        check(label, label->text());
        check(label, label->toolTip());
    }
    for (const QWidget* widget : window->findChildren<QWidget*>()) check(widget, widget->accessibleDescription());
    for (const QLineEdit* edit : window->findChildren<QLineEdit*>()) check(edit, edit->text());
    for (const QComboBox* box : window->findChildren<QComboBox*>())
        for (int i = 0; i < box->count(); ++i) check(box, box->itemText(i));
    for (const QTableWidget* table : window->findChildren<QTableWidget*>())
        for (int row = 0; row < table->rowCount(); ++row)
            for (int column = 0; column < table->columnCount(); ++column)
                if (table->item(row, column)) check(table, table->item(row, column)->text());
}

}  // namespace
}  // namespace lacuna::ui::test
