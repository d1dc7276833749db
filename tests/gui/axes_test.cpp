// What the axes of space are called in the window: a patient's letters, or X, Y, Z of a part.
#include <QLabel>
#include <QMenu>

#include "tests/gui/window_fixture.h"
#include "ui/axis_words.h"
#include "ui/views/slice_annotations.h"

namespace lacuna::ui::test {
namespace {

class AxesTest : public WindowTest {
protected:
    QAction* command(const QString& key) const {
        for (QAction* action : window->findChildren<QAction*>())
            if (action->shortcut() == QKeySequence(key)) return action;
        return nullptr;
    }
    std::string views() const {
        std::string all;
        for (const char* key : {"A", "P", "L", "R", "H", "F"})
            if (const QAction* action = command(QLatin1String(key))) all += action->text().toStdString() + "|";
        return all;
    }
    std::string sides() const {
        std::string all;
        for (const SliceView* slice : window->views()->slices()) {
            const SlicePose& pose = slice->pose();
            all += pose.left + " " + pose.right + " " + pose.top + " " + pose.bottom + "|";
        }
        return all;
    }
    std::string boxAxes() const {
        std::string all;
        for (const char* name : {"axis0", "axis1", "axis2"})
            all += window->findChild<QLabel*>(QLatin1String(name))->text().toStdString() + "|";
        return all;
    }
};

TEST_F(AxesTest, APartHasXYZ) {
    open(k_casting);
    EXPECT_EQ(sides(), "-X +X -Y +Y|-X +X +Z -Z|-Y +Y +Z -Z|");
    EXPECT_EQ(views(), "From -Y|From +Y|From +X|From -X|From +Z|From -Z|");
    EXPECT_EQ(boxAxes(), "-X…+X|-Y…+Y|-Z…+Z|");
    EXPECT_EQ(window->views()->slice(SliceKind::axial)->accessibleName(), "XY slice");
    EXPECT_EQ(command(QStringLiteral("Ctrl+3"))->text(), "X&Z slice");
    window->documents()->setCursor({-3, 0, 2});
    const QString read_out = window->statusLine()->readout();
    EXPECT_TRUE(read_out.contains(QStringLiteral("X -"))) << read_out.toStdString();
    EXPECT_TRUE(read_out.contains(QStringLiteral("Z 1")) || read_out.contains(QStringLiteral("Z 2")))
        << read_out.toStdString();
    EXPECT_FALSE(read_out.contains(QStringLiteral(" R "))) << read_out.toStdString();
}

TEST_F(AxesTest, APatientHasLettersAndTheNextPartNot) {
    open(QStringLiteral("sample:head@32"));
    EXPECT_EQ(sides(), "R L A P|R L H F|A P H F|");
    EXPECT_EQ(views(), "Front (anterior)|Back (posterior)|Left|Right|Head|Feet|");
    EXPECT_EQ(boxAxes(), "R–L|A–P|F–H|");
    EXPECT_EQ(window->views()->slice(SliceKind::axial)->accessibleName(), "Axial slice");
    window->documents()->setCursor({-30, 0, 20});
    EXPECT_TRUE(window->statusLine()->readout().contains(QStringLiteral(" R ")))
        << window->statusLine()->readout().toStdString();
    open(k_casting);
    EXPECT_EQ(views(), "From -Y|From +Y|From +X|From -X|From +Z|From -Z|");
    EXPECT_EQ(sides(), "-X +X -Y +Y|-X +X +Z -Z|-Y +Y +Z -Z|");
}

TEST_F(AxesTest, TheViewFromAnEndLooksFromThere) {
    open(k_casting);
    const std::pair<const char*, glm::dvec3> looks[] = {{"A", {0, -1, 0}}, {"P", {0, 1, 0}}, {"L", {1, 0, 0}},
                                                        {"R", {-1, 0, 0}}, {"H", {0, 0, 1}}, {"F", {0, 0, -1}}};
    for (const auto& [key, from] : looks) {
        command(QLatin1String(key))->trigger();
        EXPECT_EQ(command(QLatin1String(key))->text().toStdString(), "From " + sides_of(AxisNames::xyz, from));
        EXPECT_NEAR(glm::dot(window->views()->volumeView()->rays().forward, from), -1, 1e-9) << key;
    }
}

TEST(AxisWords, PositionsAreToldByTheAxisClosest) {
    EXPECT_EQ(position_text(AxisNames::patient, {1, 2, -12.5}, {0, 0, -1}), "F 12.50 mm");
    EXPECT_EQ(position_text(AxisNames::xyz, {1, 2, -12.5}, {0, 0, -1}), "Z -12.50 mm");
    EXPECT_EQ(position_text(AxisNames::xyz, {1, 2, -12.5}, {1, 0, 0}), "X 1.00 mm");
    EXPECT_EQ(coordinate_words(AxisNames::patient, 0, -3), "R 3.00");
    EXPECT_EQ(coordinate_words(AxisNames::xyz, 0, -3), "X -3.00");
}

}  // namespace
}  // namespace lacuna::ui::test
