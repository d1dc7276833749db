// Colours that can be read, controls that can be seen, and a scheme that follows its choice.
#include "ui/theme.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QLineEdit>
#include <QRadioButton>
#include <QSettings>
#include <QSlider>
#include <QVBoxLayout>
#include <memory>

#include "ui/theme_control.h"
#include "ui/widgets/message_bar.h"
#include "ui/widgets/range_slider.h"

namespace lacuna::ui {
namespace {

class Schemes : public testing::TestWithParam<Scheme> {
protected:
    void SetUp() override { apply_theme(*qApp, GetParam()); }
    void TearDown() override { apply_theme(*qApp, Scheme::dark); }
    const ThemeColors& c() const { return theme::colors(); }
};
INSTANTIATE_TEST_SUITE_P(Both, Schemes, testing::Values(Scheme::dark, Scheme::light),
                         [](const auto& row) { return row.param == Scheme::dark ? "dark" : "light"; });

TEST(Contrast, IsThatOfTheStandard) {
    EXPECT_NEAR(theme::contrast(Qt::black, Qt::white), 21, 1e-3);
    EXPECT_NEAR(theme::contrast(QColor(119, 119, 119), Qt::white), 4.48, 0.01);  // the well-known failing grey
    EXPECT_EQ(theme::contrast(Qt::red, Qt::red), 1);
}

TEST_P(Schemes, WordsAreReadableOnEverySurface) {
    const std::pair<const char*, QColor> surfaces[] = {{"window", c().window},       {"base", c().base},
                                                       {"alternate", c().alternate}, {"button", c().button},
                                                       {"tooltip", c().tooltip},     {"title", c().title}};
    const std::pair<const char*, QColor> words[] = {{"text", c().text},     {"dim", c().dim},
                                                    {"accent", c().accent}, {"warning", c().warning},
                                                    {"error", c().error},   {"good", c().good}};
    for (const auto& [surface, under] : surfaces) {
        for (const auto& [word, ink] : words) EXPECT_GE(theme::contrast(ink, under), 4.5) << word << " on " << surface;
        EXPECT_GE(theme::contrast(c().disabled, under), 2) << "disabled on " << surface;
    }
    EXPECT_GE(theme::contrast(c().highlighted_text, c().highlight), 4.5);
}

TEST_P(Schemes, ThePaletteHoldsThemToo) {
    const QPalette p = QApplication::palette();
    const std::pair<QPalette::ColorRole, QPalette::ColorRole> pairs[] = {
        {QPalette::WindowText, QPalette::Window},       {QPalette::Text, QPalette::Base},
        {QPalette::Text, QPalette::AlternateBase},      {QPalette::ButtonText, QPalette::Button},
        {QPalette::ToolTipText, QPalette::ToolTipBase}, {QPalette::HighlightedText, QPalette::Highlight},
        {QPalette::PlaceholderText, QPalette::Base},    {QPalette::Link, QPalette::Window}};
    for (const auto& [ink, under] : pairs)
        EXPECT_GE(theme::contrast(p.color(ink), p.color(under)), 4.5) << int(ink) << " on " << int(under);
}

TEST_P(Schemes, InksOnPicturesAreReadableOnBlack) {
    for (const QColor& ink :
         {theme::k_text, theme::k_axial, theme::k_coronal, theme::k_sagittal, theme::k_volume, theme::k_warning})
        EXPECT_GE(theme::contrast(ink, Qt::black), 4.5) << ink.name().toStdString();
}

/// The largest contrast of any of the widget's pixels with what it stands on.
double edge_contrast(QWidget& widget, const QColor& surface) {
    const QImage image = widget.grab().toImage();
    double most = 1;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) most = std::max(most, theme::contrast(image.pixelColor(x, y), surface));
    return most;
}

TEST_P(Schemes, UncheckedBoxesAndSlidersStandOut) {
    QWidget parent;
    auto* column = new QVBoxLayout(&parent);
    auto* box = new QCheckBox(&parent);
    auto* radio = new QRadioButton(&parent);
    auto* slider = new QSlider(Qt::Horizontal, &parent);
    auto* range = new RangeSlider(&parent);
    auto* edit = new QLineEdit(&parent);
    for (QWidget* each : std::initializer_list<QWidget*>{box, radio, slider, range, edit}) column->addWidget(each);
    parent.setAttribute(Qt::WA_DontShowOnScreen);
    parent.resize(200, 200);
    parent.show();
    for (QWidget* each : std::initializer_list<QWidget*>{box, radio, slider, range, edit})
        EXPECT_GE(edge_contrast(*each, c().window), 3) << each->metaObject()->className();
}

TEST_P(Schemes, ACheckedBoxIsAnotherPicture) {
    QCheckBox box;
    box.resize(24, 24);
    const QImage off = box.grab().toImage();
    box.setChecked(true);
    const QImage on = box.grab().toImage();
    box.setTristate(true);
    box.setCheckState(Qt::PartiallyChecked);
    EXPECT_NE(off, on);
    EXPECT_NE(box.grab().toImage(), on);
}

TEST_P(Schemes, AMessageTakesTheSchemesColours) {
    MessageBar bar;
    bar.resize(300, 40);
    bar.showError(QStringLiteral("The disk is full."));
    const QImage image = bar.grab().toImage();
    EXPECT_EQ(image.pixelColor(1, 20).name(), c().error.name());
    EXPECT_EQ(image.pixelColor(6, 2).name(), c().title.name());
}

TEST(SystemScheme, ThePortalIsAskedFirstThenThePlatform) {
    const QPalette dark(QColor(40, 40, 40)), light(QColor(230, 230, 230));
    EXPECT_EQ(system_scheme(1u, light, true), Scheme::dark);
    EXPECT_EQ(system_scheme(2u, dark, true), Scheme::light);
    for (const std::optional<unsigned> none : {std::optional<unsigned>(), std::optional<unsigned>(0u)}) {
        EXPECT_EQ(system_scheme(none, dark, true), Scheme::dark);
        EXPECT_EQ(system_scheme(none, light, true), Scheme::light);
        EXPECT_EQ(system_scheme(none, light, false), Scheme::dark);
    }
}

TEST(ThemeControl, AChoiceHoldsAtOnceAndIsKept) {
    ThemeControl* control = ThemeControl::instance();
    control->choose(ThemeChoice::light);
    EXPECT_EQ(theme::scheme(), Scheme::light);
    EXPECT_EQ(QApplication::palette().color(QPalette::Window).name(), theme::colors_of(Scheme::light).window.name());
    EXPECT_EQ(preferences::theme(), ThemeChoice::light);
    control->choose(ThemeChoice::dark);
    EXPECT_EQ(theme::scheme(), Scheme::dark);
    control->choose(ThemeChoice::system);
    EXPECT_EQ(preferences::theme(), ThemeChoice::system);
}

TEST(Preferences, WrongValuesReadAsTheirDefaults) {
    QSettings kept;
    kept.setValue(QStringLiteral("look/theme"), QStringLiteral("purple"));
    kept.setValue(QStringLiteral("look/language"), 7);
    kept.setValue(QStringLiteral("session/autosave_minutes"), -3);
    kept.setValue(QStringLiteral("compute/memory_limit_mib"), QStringLiteral("much"));
    EXPECT_EQ(preferences::theme(), ThemeChoice::system);
    EXPECT_EQ(preferences::language(), QString());
    EXPECT_EQ(preferences::autosave_minutes(), 2);
    EXPECT_EQ(preferences::memory_limit_mib(), 0);
    kept.clear();
}

}  // namespace
}  // namespace lacuna::ui
