// Selections in the real window by ellipse, polygon and colour, from the layer, and with margins.
#include "app/selection_fixture.hpp"
#include "dialogs/length_dialog.hpp"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using testing::HasSubstr;

class SelectionTools : public SelectionFixture {
  protected:
    void click(const glm::dvec2& place_mm, Qt::KeyboardModifiers keys = {}) { drag({place_mm}, keys); }
    void click_each(const std::vector<glm::dvec2>& places_mm) {
        for (const glm::dvec2& place_mm : places_mm)
            click(place_mm);
    }
    /// Fills a rectangle with the paint in hand, or the second one.
    void fill_box(const glm::dvec2& from_mm, const glm::dvec2& to_mm, Command fill) {
        give(Command::SelectRectangle);
        drag({from_mm, to_mm});
        give(fill);
        give(Command::SelectEverything);
        key(Qt::Key_Escape);
    }
    dialogs::MarginDialog* dialog() { return window().findChild<dialogs::MarginDialog*>(); }
    QDoubleSpinBox& length() {
        return *dialog()->findChild<QDoubleSpinBox*>(QStringLiteral("length_mm"));
    }
};

TEST_F(SelectionTools, AnEllipseIsDraggedByTheRectangleAroundIt) {
    give(Command::SelectEllipse);
    EXPECT_EQ(reading(), "ellipse");
    drag({{10.0, 10.0}, {25.0, 20.0}, {50.0, 30.0}});
    EXPECT_NEAR(selected_mm2(), 3.1416 * 20.0 * 10.0, 98.0 * kSide_mm);
    EXPECT_TRUE(selected(30.0, 20.0) && selected(11.0, 20.0) && selected(30.0, 29.0));
    EXPECT_FALSE(selected(12.0, 12.0) || selected(48.0, 28.0));
    drag({{10.0, 10.0}, {30.0, 14.0}}, Qt::ControlModifier);
    EXPECT_NEAR(selected_mm2(), 3.1416 * 10.0 * 10.0, 63.0 * kSide_mm) << "a circle";
    drag({{40.0, 10.0}, {50.0, 20.0}}, Qt::ShiftModifier);
    EXPECT_TRUE(selected(20.0, 20.0) && selected(45.0, 15.0));
    drag({{15.0, 15.0}, {25.0, 25.0}}, Qt::AltModifier);
    EXPECT_FALSE(selected(20.0, 20.0));
    EXPECT_EQ(volume_mm3(), 0.0);
    click({5.0, 5.0});
    EXPECT_EQ(selection(), nullptr) << "a click ends the selection";
}

TEST_F(SelectionTools, APolygonIsClickedCornerByCorner) {
    give(Command::SelectPolygon);
    EXPECT_EQ(reading(), "polygon");
    click_each({{10.0, 10.0}, {40.0, 10.0}, {40.0, 30.0}});
    EXPECT_EQ(selection(), nullptr) << "it is open";
    key(Qt::Key_Return);
    EXPECT_NEAR(selected_mm2(), 0.5 * 30.0 * 20.0, 86.0 * kSide_mm);
    EXPECT_TRUE(selected(38.0, 20.0));
    EXPECT_FALSE(selected(15.0, 25.0));
    click_each({{10.0, 10.0}, {20.0, 10.0}, {20.0, 20.0}, {10.0, 20.0}, {10.0, 20.0}});
    EXPECT_NEAR(selected_mm2(), 100.0, 40.0 * kSide_mm) << "closed by a double click";
    click_each({{30.0, 10.0}, {40.0, 10.0}, {40.0, 20.0}, {30.2, 10.2}});
    EXPECT_NEAR(selected_mm2(), 50.0, 35.0 * kSide_mm) << "closed on its first corner";
    EXPECT_EQ(volume_mm3(), 0.0);
}

TEST_F(SelectionTools, BackspaceTakesTheLastCornerBackAndPoursNoPaint) {
    give(Command::SelectPolygon);
    click_each({{10.0, 10.0}, {40.0, 10.0}, {40.0, 30.0}, {10.0, 35.0}});
    key(Qt::Key_Backspace);
    key(Qt::Key_Enter);
    EXPECT_NEAR(selected_mm2(), 0.5 * 30.0 * 20.0, 86.0 * kSide_mm);
    const auto events = events_posted();
    click_each({{10.0, 10.0}, {40.0, 10.0}});
    key(Qt::Key_Backspace);
    key(Qt::Key_Backspace);
    EXPECT_THAT(told(), HasSubstr("Nothing was selected"));
    click_each({{10.0, 10.0}, {40.0, 10.0}, {40.0, 30.0}});
    key(Qt::Key_Escape);
    EXPECT_TRUE(action(Command::SelectPolygon)->isChecked());
    key(Qt::Key_Return);
    EXPECT_EQ(events_posted(), events) << "Escape gave it up";
    key(Qt::Key_Escape);
    EXPECT_FALSE(action(Command::SelectPolygon)->isChecked());
    EXPECT_EQ(volume_mm3(), 0.0);
}

TEST_F(SelectionTools, APolygonIsAddedAndTakenAway) {
    give(Command::SelectRectangle);
    drag({{10.0, 10.0}, {30.0, 30.0}});
    give(Command::SelectPolygon);
    click({30.0, 10.0}, Qt::ShiftModifier);
    click_each({{50.0, 10.0}, {50.0, 30.0}, {30.0, 30.0}});
    key(Qt::Key_Return);
    EXPECT_TRUE(selected(15.0, 20.0) && selected(45.0, 20.0));
    click({10.0, 10.0}, Qt::AltModifier);
    click_each({{20.0, 10.0}, {20.0, 30.0}, {10.0, 30.0}});
    key(Qt::Key_Return);
    EXPECT_FALSE(selected(15.0, 20.0));
    EXPECT_TRUE(selected(45.0, 20.0));
}

TEST_F(SelectionTools, TheWandSelectsTheColourThatIsClicked) {
    fill_box({5.0, 5.0}, {20.0, 30.0}, Command::FillPaint);
    fill_box({35.0, 5.0}, {50.0, 30.0}, Command::FillPaint);
    give(Command::SelectContiguous);
    EXPECT_EQ(reading(), "contiguous colour");
    const double painted_mm3 = volume_mm3();
    click({12.0, 20.0});
    EXPECT_TRUE(selected(6.0, 6.0) && selected(19.0, 29.0));
    EXPECT_FALSE(selected(25.0, 20.0) || selected(42.0, 20.0));
    click({42.0, 20.0}, Qt::ShiftModifier);
    EXPECT_TRUE(selected(12.0, 20.0) && selected(42.0, 20.0));
    give(Command::SelectSimilar);
    EXPECT_FALSE(action(Command::SelectContiguous)->isChecked());
    click({42.0, 20.0});
    EXPECT_TRUE(selected(12.0, 20.0) && selected(42.0, 20.0));
    EXPECT_FALSE(selected(27.0, 20.0));
    EXPECT_EQ(volume_mm3(), painted_mm3) << "it does not paint";
    key(Qt::Key_Escape);
    EXPECT_FALSE(action(Command::SelectSimilar)->isChecked());
}

TEST_F(SelectionTools, DraggingTheWandTakesMoreOrLessOfAColour) {
    fill_box({5.0, 5.0}, {20.0, 30.0}, Command::FillPaint);
    give(Command::SelectContiguous);
    const auto difference = [&] {
        session().wait_until_applied();
        const auto events = session().recording().events;
        return std::get<document::SelectSimilarColour>(events.back().action).difference;
    };
    click({12.0, 20.0});
    EXPECT_EQ(difference(), 10.0);
    drag({{12.0, 20.0}, {30.0, 20.0}});
    const double more = difference();
    EXPECT_GT(more, 15.0);
    EXPECT_THAT(told(), HasSubstr("up to " + std::to_string(static_cast<int>(more))));
    click({12.0, 20.0});
    EXPECT_EQ(difference(), more) << "it stays";
    drag({{30.0, 20.0}, {3.0, 20.0}});
    EXPECT_LT(difference(), more);
    send(QEvent::MouseButtonPress, {12.0, 20.0}, {});
    send(QEvent::MouseMove, {58.0, 20.0}, {});
    const auto events = events_posted();
    const double before = difference();
    key(Qt::Key_Escape);
    send(QEvent::MouseButtonRelease, {58.0, 20.0}, {});
    EXPECT_EQ(events_posted(), events);
    click({12.0, 20.0});
    EXPECT_EQ(difference(), before) << "given up";
}

TEST_F(SelectionTools, FromTheLayerTakesItsPaint) {
    fill_box({5.0, 5.0}, {20.0, 30.0}, Command::FillPaint);
    give(Command::SelectPaint);
    EXPECT_NEAR(selected_mm2(), 15.0 * 25.0, 80.0 * kSide_mm);
    EXPECT_TRUE(selected(12.0, 20.0));
    EXPECT_FALSE(selected(30.0, 20.0));
}

TEST_F(SelectionTools, MarginsAreAskedForAndSeenBeforehand) {
    EXPECT_FALSE(action(Command::GrowSelection)->isEnabled()) << "nothing is selected";
    give(Command::SelectRectangle);
    drag({{20.0, 10.0}, {40.0, 30.0}});
    key(Qt::Key_Escape);
    const QImage before = picture();
    give(Command::GrowSelection);
    ASSERT_NE(dialog(), nullptr);
    length().setValue(5.0);
    EXPECT_GT(difference(before, picture()).largest, 60) << "it is outlined";
    EXPECT_FALSE(selected(16.0, 20.0)) << "but not selected yet";
    dialog()->accept();
    settle();
    EXPECT_TRUE(selected(16.0, 20.0));
    EXPECT_FALSE(selected(14.0, 20.0));
    EXPECT_NEAR(selected_mm2(), 400.0 + 4 * 100.0 + 3.1416 * 25.0, 112.0 * kSide_mm);
    give(Command::ShrinkSelection);
    EXPECT_EQ(length().value(), 5.0) << "as it was chosen last";
    dialog()->accept();
    settle();
    EXPECT_EQ(difference(before, picture()).largest, 0);
    give(Command::BorderSelection);
    length().setValue(4.0);
    dialog()->accept();
    settle();
    EXPECT_TRUE(selected(18.5, 20.0) && selected(21.5, 20.0));
    EXPECT_FALSE(selected(17.5, 20.0) || selected(22.5, 20.0));
    give(Command::Undo);
    give(Command::GrowSelection);
    dialog()->reject();
    settle();
    EXPECT_EQ(difference(before, picture()).largest, 0);
}

TEST_F(SelectionTools, AFeatheredSelectionFadesOut) {
    EXPECT_FALSE(action(Command::FeatherSelection)->isEnabled()) << "nothing is selected";
    give(Command::SelectRectangle);
    drag({{20.0, 10.0}, {40.0, 30.0}});
    key(Qt::Key_Escape);
    give(Command::FeatherSelection);
    ASSERT_NE(dialog(), nullptr);
    length().setValue(4.0);
    dialog()->accept();
    settle();
    const double cell_mm = session().snapshot()->film.cell_mm;
    const auto share = [&](double x_mm) {
        return selection()->at(static_cast<int>(x_mm / cell_mm), static_cast<int>(20.0 / cell_mm));
    };
    EXPECT_EQ(share(30.0), grid::kWhole);
    EXPECT_EQ(share(15.0), 0);
    EXPECT_GT(share(21.0), share(19.0));
    EXPECT_GT(share(19.0), 0);
    // Its corners become round.
    EXPECT_NEAR(selected_mm2(), 400.0, 16.0);
    give(Command::Undo);
    EXPECT_FALSE(grid::is_soft(*selection()));
}

TEST_F(SelectionTools, AFeatherFinerThanTheCanvasSaysThatNothingChanges) {
    give(Command::SelectRectangle);
    drag({{20.0, 10.0}, {40.0, 30.0}});
    give(Command::FeatherSelection);
    auto* button = dialog()->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    auto* problem = dialog()->findChild<QLabel*>(QStringLiteral("problem"));
    // Cells of a quarter of a millimetre: from one and a half of them on shares change.
    length().setValue(0.3);
    EXPECT_FALSE(button->isEnabled());
    EXPECT_THAT(problem->text().toStdString(), HasSubstr("stay as it is"));
    length().setValue(0.5);
    EXPECT_TRUE(button->isEnabled());
    EXPECT_FALSE(problem->isVisible());
}

TEST_F(SelectionTools, ASelectionIsNotShrunkToNothing) {
    give(Command::SelectRectangle);
    drag({{20.0, 10.0}, {40.0, 30.0}});
    give(Command::ShrinkSelection);
    auto* buttons = dialog()->findChild<QDialogButtonBox*>();
    auto* problem = dialog()->findChild<QLabel*>(QStringLiteral("problem"));
    length().setValue(11.0);
    EXPECT_FALSE(buttons->button(QDialogButtonBox::Ok)->isEnabled());
    EXPECT_TRUE(problem->isVisible());
    QTest::keyClick(dialog(), Qt::Key_Return);
    settle();
    EXPECT_TRUE(selected(21.0, 11.0)) << "as it was";
    length().setValue(9.0);
    EXPECT_FALSE(problem->isVisible());
    QTest::keyClick(dialog(), Qt::Key_Return);
    settle();
    EXPECT_TRUE(selected(30.0, 20.0));
    EXPECT_FALSE(selected(28.0, 20.0));
}

}  // namespace
}  // namespace pastoso::tests
