// Masking fluid and tape in the real window, and what is bare locked in the list of layers.
#include "app/selection_fixture.hpp"

#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using testing::HasSubstr;

class MaskingWindow : public SelectionFixture {
  protected:
    std::shared_ptr<const grid::Mask> masked() {
        session().wait_until_applied();
        return session().snapshot()->masking.cells;
    }
    double masked_mm2() {
        const auto cells = masked();
        const double cell_mm = session().snapshot()->film.cell_mm;
        return cells ? static_cast<double>(grid::chosen_cells(*cells)) * cell_mm * cell_mm : 0.0;
    }
    bool is_masked(double x_mm, double y_mm) {
        const auto cells = masked();
        const double cell_mm = session().snapshot()->film.cell_mm;
        return cells &&
               cells->at(static_cast<int>(x_mm / cell_mm), static_cast<int>(y_mm / cell_mm)) != 0;
    }
    bool is_painted(double x_mm, double y_mm) {
        session().wait_until_applied();
        const film::FilmState film = session().snapshot()->film;
        return film.thickness.at(static_cast<int>(x_mm / film.cell_mm),
                                 static_cast<int>(y_mm / film.cell_mm)) > 0;
    }
};

TEST_F(MaskingWindow, TapeIsDraggedFromPlaceToPlace) {
    give(Command::MaskingTape);
    EXPECT_THAT(told(), HasSubstr("masking tape"));
    drag({{10.0, 20.0}, {25.0, 22.0}, {40.0, 20.0}});
    EXPECT_NEAR(masked_mm2(), 30.0 * 4.0, 68.0 * kSide_mm);
    EXPECT_TRUE(is_masked(11.0, 20.0) && is_masked(39.0, 21.0));
    EXPECT_FALSE(is_masked(8.5, 20.0) || is_masked(25.0, 23.0)) << "its ends are straight";
    drag({{20.0, 15.0}, {20.0, 25.0}}, Qt::AltModifier);
    EXPECT_FALSE(is_masked(20.0, 20.0)) << "peeled there";
    EXPECT_TRUE(is_masked(12.0, 20.0) && is_masked(30.0, 20.0));
    EXPECT_EQ(volume_mm3(), 0.0) << "it does not paint";
    const auto events = events_posted();
    drag({{20.0, 30.0}});
    EXPECT_THAT(told(), HasSubstr("Nothing was masked"));
    EXPECT_EQ(events_posted(), events) << "a click lays no tape";
    give(Command::Undo);
    give(Command::Undo);
    EXPECT_EQ(masked(), nullptr);
}

TEST_F(MaskingWindow, ShiftKeepsTapeLevel) {
    give(Command::MaskingTape);
    drag({{10.0, 20.0}, {40.0, 23.0}}, Qt::ShiftModifier);
    EXPECT_TRUE(is_masked(38.0, 20.0));
    EXPECT_FALSE(is_masked(38.0, 23.0));
}

TEST_F(MaskingWindow, FluidIsPaintedAlongTheWayOfThePointer) {
    give(Command::MaskingFluid);
    drag({{10.0, 10.0}, {30.0, 10.0}, {30.0, 30.0}});
    EXPECT_NEAR(masked_mm2(), 40.0 * 4.0 + 3.1416 * 4.0, 90.0 * kSide_mm);
    EXPECT_TRUE(is_masked(20.0, 11.0) && is_masked(31.0, 25.0) && is_masked(8.6, 10.0));
    EXPECT_FALSE(is_masked(20.0, 20.0));
    drag({{45.0, 25.0}});
    EXPECT_TRUE(is_masked(45.0, 25.0)) << "a click is a dot";
    EXPECT_EQ(volume_mm3(), 0.0);
}

TEST_F(MaskingWindow, PaintKeepsOffWhatIsMaskedUntilItIsPeeledOff) {
    give(Command::MaskingTape);
    drag({{10.0, 20.0}, {40.0, 20.0}});
    give(Command::FillPaint);
    EXPECT_TRUE(is_painted(25.0, 10.0));
    EXPECT_FALSE(is_painted(25.0, 20.0));
    give(Command::PeelMasking);
    EXPECT_THAT(told(), HasSubstr("peeled off"));
    EXPECT_FALSE(action(Command::PeelMasking)->isEnabled());
    EXPECT_FALSE(is_painted(25.0, 20.0));
    give(Command::FillPaint);
    EXPECT_TRUE(is_painted(25.0, 20.0));
}

TEST_F(MaskingWindow, TheMaskingIsSeen) {
    give(Command::MaskingTape);
    drag({{10.0, 20.0}, {40.0, 20.0}});
    key(Qt::Key_Escape);
    settle();
    const QImage with_tape = canvas().picture();
    give(Command::PeelMasking);
    EXPECT_NE(canvas().picture(), with_tape);
    give(Command::Undo);
    EXPECT_EQ(canvas().picture(), with_tape);
}

TEST_F(MaskingWindow, WhatIsSelectedIsMaskedAndTheOtherWayRound) {
    EXPECT_FALSE(action(Command::MaskSelection)->isEnabled());
    EXPECT_FALSE(action(Command::SelectMasked)->isEnabled());
    give(Command::SelectRectangle);
    drag({{10.0, 10.0}, {30.0, 30.0}});
    give(Command::MaskSelection);
    EXPECT_NEAR(masked_mm2(), selected_mm2(), 1e-9);
    give(Command::SelectEverything);
    give(Command::SelectMasked);
    EXPECT_NEAR(masked_mm2(), selected_mm2(), 1e-9);
}

TEST_F(MaskingWindow, OneWayToUseAPressEndsAnother) {
    const auto on = [this](Command command) { return action(command)->isChecked(); };
    give(Command::MaskingTape);
    give(Command::MaskingFluid);
    EXPECT_TRUE(on(Command::MaskingFluid) && !on(Command::MaskingTape));
    give(Command::SelectLasso);
    EXPECT_TRUE(on(Command::SelectLasso) && !on(Command::MaskingFluid));
    give(Command::MaskingTape);
    EXPECT_TRUE(on(Command::MaskingTape) && !on(Command::SelectLasso));
    give(Command::FillGradient);
    EXPECT_TRUE(on(Command::FillGradient) && !on(Command::MaskingTape));
    give(Command::MaskingFluid);
    EXPECT_FALSE(on(Command::FillGradient));
    key(Qt::Key_Escape);
    EXPECT_FALSE(on(Command::MaskingFluid));
    drag({{10.0, 10.0}, {30.0, 10.0}});
    EXPECT_GT(volume_mm3(), 0.0) << "the brush paints again";
    EXPECT_EQ(masked(), nullptr);
}

TEST_F(MaskingWindow, EscapeGivesUpWhatIsBeingLaid) {
    give(Command::MaskingFluid);
    send(QEvent::MouseButtonPress, {10.0, 10.0}, {});
    send(QEvent::MouseMove, {30.0, 10.0}, {});
    key(Qt::Key_Escape);
    send(QEvent::MouseButtonRelease, {30.0, 10.0}, {});
    settle();
    EXPECT_EQ(masked(), nullptr);
    EXPECT_TRUE(action(Command::MaskingFluid)->isChecked());
}

TEST_F(MaskingWindow, WhatIsBareIsLocked) {
    give(Command::SelectRectangle);
    drag({{10.0, 10.0}, {30.0, 30.0}});
    key(Qt::Key_Escape);
    give(Command::FillPaint);
    give(Command::SelectEverything);
    give(Command::LockBare);
    EXPECT_TRUE(action(Command::LockBare)->isChecked());
    const double painted_mm3 = volume_mm3();
    give(Command::FillPaint);
    EXPECT_GT(volume_mm3(), painted_mm3);
    EXPECT_TRUE(is_painted(20.0, 20.0));
    EXPECT_FALSE(is_painted(45.0, 20.0));
    give(Command::LockBare);
    EXPECT_FALSE(action(Command::LockBare)->isChecked());
    give(Command::FillPaint);
    EXPECT_TRUE(is_painted(45.0, 20.0));
}

}  // namespace
}  // namespace pastoso::tests
