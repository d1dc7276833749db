#include "core/session/edit_history.h"

#include <gtest/gtest.h>

namespace lacuna {
namespace {

ViewSettings with_iso(double iso) {
    ViewSettings settings;
    settings.iso = iso;
    return settings;
}

TEST(EditHistory, EqualSettingsAreNoEdit) {
    EditHistory history;
    EXPECT_FALSE(history.note("Isovalue", with_iso(1), with_iso(1)));
    EXPECT_FALSE(history.can_undo());
    EXPECT_EQ(history.undo_name(), "");
}

TEST(EditHistory, UndoAndRedoGiveTheSettingsBack) {
    EditHistory history;
    history.note("Isovalue", with_iso(1), with_iso(2));
    history.note("Mode", with_iso(2), with_iso(3));
    EXPECT_EQ(history.undo_name(), "Mode");
    EXPECT_EQ(history.undo().iso, 2);
    EXPECT_EQ(history.redo_name(), "Mode");
    EXPECT_EQ(history.undo().iso, 1);
    EXPECT_FALSE(history.can_undo());
    EXPECT_EQ(history.redo().iso, 2);
    EXPECT_EQ(history.redo().iso, 3);
    EXPECT_FALSE(history.can_redo());
}

TEST(EditHistory, OneGestureIsOneStep) {
    EditHistory history;
    for (int i = 1; i < 20; ++i) history.note("Isovalue", with_iso(i), with_iso(i + 1));
    EXPECT_EQ(history.undo().iso, 1);
    EXPECT_FALSE(history.can_undo());
}

TEST(EditHistory, SealedGesturesStayApart) {
    EditHistory history;
    history.note("Isovalue", with_iso(1), with_iso(2));
    history.seal();
    history.note("Isovalue", with_iso(2), with_iso(3));
    EXPECT_EQ(history.undo().iso, 2);
    EXPECT_EQ(history.undo().iso, 1);
}

TEST(EditHistory, ANewEditForgetsWhatWasUndone) {
    EditHistory history;
    history.note("A", with_iso(1), with_iso(2));
    history.note("B", with_iso(2), with_iso(3));
    history.undo();
    history.note("C", with_iso(2), with_iso(9));
    EXPECT_FALSE(history.can_redo());
    EXPECT_EQ(history.undo().iso, 2);
    EXPECT_EQ(history.undo().iso, 1);
}

TEST(EditHistory, AGestureThatReturnsLeavesNoStep) {
    EditHistory history;
    history.note("Isovalue", with_iso(1), with_iso(2));
    history.note("Isovalue", with_iso(2), with_iso(1));
    EXPECT_FALSE(history.can_undo());
}

TEST(EditHistory, TheOldestStepsGoFirst) {
    EditHistory history(3);
    for (int i = 0; i < 10; ++i) {
        history.note("Isovalue", with_iso(i), with_iso(i + 1));
        history.seal();
    }
    for (int i = 9; i > 6; --i) EXPECT_EQ(history.undo().iso, i);
    EXPECT_FALSE(history.can_undo());
}

}  // namespace
}  // namespace lacuna
