// Even films of paint in the real window: by keys, by a line, and as thick as is asked for.
#include "app/selection_fixture.hpp"
#include "dialogs/length_dialog.hpp"

#include <QDoubleSpinBox>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using testing::HasSubstr;

class FillWindow : public SelectionFixture {
  protected:
    double canvas_mm2() {
        const document::CanvasSettings& canvas = session().snapshot()->bare->settings;
        return canvas.width_mm * canvas.height_mm;
    }
    document::FillWithPaint last_fill() {
        session().wait_until_applied();
        const auto events = session().recording().events;
        return std::get<document::FillWithPaint>(events.back().action);
    }
};

TEST_F(FillWindow, KeysPourThePaintInHandAndTheSecondOne) {
    QTest::keyClick(&canvas(), Qt::Key_Backspace, Qt::ShiftModifier);
    settle();
    EXPECT_NEAR(volume_mm3(), canvas_mm2() * 0.2, 0.01);
    EXPECT_EQ(last_fill().paint, studio().easel().hand().paint);
    EXPECT_THAT(told(), HasSubstr("0.2 mm"));
    give(Command::Undo);
    EXPECT_EQ(volume_mm3(), 0.0);
    QTest::keyClick(&canvas(), Qt::Key_Backspace);
    settle();
    EXPECT_NEAR(volume_mm3(), canvas_mm2() * 0.2, 0.01);
    EXPECT_EQ(last_fill().paint, studio().easel().hand().second_paint);
}

TEST_F(FillWindow, FillsKeepToTheSelection) {
    give(Command::SelectRectangle);
    drag({{10.0, 10.0}, {40.0, 30.0}});
    give(Command::FillPaint);
    EXPECT_NEAR(volume_mm3(), selected_mm2() * 0.2, 0.01);
    EXPECT_THAT(told(), HasSubstr("what is selected"));
}

TEST_F(FillWindow, AGradientIsDragged) {
    give(Command::FillGradient);
    EXPECT_TRUE(action(Command::FillGradient)->isChecked());
    const QImage before = picture();
    send(QEvent::MouseButtonPress, {10.0, 20.0}, {});
    send(QEvent::MouseMove, {50.0, 20.0}, {});
    EXPECT_GT(difference(before, picture()).largest, 60) << "the line is seen";
    send(QEvent::MouseButtonRelease, {50.0, 20.0}, {});
    settle();
    EXPECT_NEAR(volume_mm3(), canvas_mm2() * 0.2, 0.01);
    const document::FillWithPaint fill = last_fill();
    EXPECT_EQ(fill.paint, studio().easel().hand().paint);
    EXPECT_EQ(fill.second, studio().easel().hand().second_paint);
    ASSERT_EQ(fill.line.size(), 2U);
    EXPECT_NEAR(fill.line[0].x_mm, 10.0, kSide_mm);
    EXPECT_NEAR(fill.line[1].x_mm, 50.0, kSide_mm);
    drag({{10.0, 20.0}, {50.0, 22.0}}, Qt::ShiftModifier);
    EXPECT_NEAR(last_fill().line[1].y_mm, last_fill().line[0].y_mm, 1e-9) << "level";
    EXPECT_TRUE(action(Command::FillGradient)->isChecked()) << "until Escape";
    const auto events = events_posted();
    drag({{30.0, 20.0}});
    EXPECT_EQ(events_posted(), events) << "a click has no direction";
    key(Qt::Key_Escape);
    EXPECT_FALSE(action(Command::FillGradient)->isChecked());
}

TEST_F(FillWindow, GradientsAndSelectionsTakeTurns) {
    give(Command::FillGradient);
    give(Command::SelectEllipse);
    EXPECT_FALSE(action(Command::FillGradient)->isChecked());
    drag({{10.0, 10.0}, {40.0, 30.0}});
    EXPECT_NE(selection(), nullptr);
    give(Command::FillGradient);
    EXPECT_FALSE(action(Command::SelectEllipse)->isChecked());
    drag({{10.0, 10.0}, {40.0, 30.0}});
    EXPECT_NEAR(volume_mm3(), selected_mm2() * 0.2, 0.01);
    give(Command::NextBrush);
    EXPECT_FALSE(action(Command::FillGradient)->isChecked());
}

TEST_F(FillWindow, TheThicknessIsAskedForAndStays) {
    give(Command::FillThickness);
    auto* dialog = window().findChild<dialogs::ThicknessDialog*>();
    ASSERT_NE(dialog, nullptr);
    auto* length = dialog->findChild<QDoubleSpinBox*>(QStringLiteral("length_mm"));
    EXPECT_EQ(length->value(), 0.2);
    length->setValue(5.0);
    EXPECT_EQ(length->value(), document::kMostFill_mm);
    length->setValue(0.5);
    dialog->accept();
    settle();
    give(Command::FillPaint);
    EXPECT_NEAR(volume_mm3(), canvas_mm2() * 0.5, 0.01);
}

TEST_F(FillWindow, AGroundIsTonedWithThePaintInHand) {
    give(Command::ToneGround);
    auto* dialog = window().findChild<dialogs::ThicknessDialog*>();
    ASSERT_NE(dialog, nullptr);
    dialog->findChild<QDoubleSpinBox*>()->setValue(0.05);
    dialog->accept();
    settle();
    const auto layers = session().snapshot()->layers;
    ASSERT_EQ(layers->layers.size(), 2U);
    EXPECT_EQ(layers->layers[0].look.name, "Ground");
    EXPECT_EQ(layers->active, 1U);
    session().wait_until_applied();
    const auto tone = std::get<document::ToneGround>(session().recording().events.back().action);
    EXPECT_EQ(tone.thickness_mm, 0.05);
    EXPECT_EQ(tone.paint, studio().easel().hand().paint);
    EXPECT_EQ(volume_mm3(), 0.0) << "nothing of it is wet";
    give(Command::Undo);
    EXPECT_EQ(session().snapshot()->layers->layers.size(), 1U);
}

}  // namespace
}  // namespace pastoso::tests
