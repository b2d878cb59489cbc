// Paint : medium, above the canvas, in the pop-up palette and by keys.
#include "app/window_fixture.hpp"
#include "main/window_parts.hpp"
#include "panels/paint/swatch_colours.hpp"
#include "panels/paint/thinning_slider.hpp"
#include "panels/popup/popup_palette.hpp"

#include <algorithm>
#include <cstddef>
#include <variant>

#include <QAction>
#include <QDoubleSpinBox>
#include <QSlider>
#include <QTest>
#include <QToolBar>

namespace pastoso::tests {
namespace {

using commands::Command;

class ThinningWindow : public WindowTest {
  protected:
    panels::ThinningSlider& thinning() {
        return *window().findChild<QToolBar*>()->findChild<panels::ThinningSlider*>();
    }
    QSlider& slider() { return *thinning().slider(); }
    const document::UseMedium& medium() { return studio().easel().hand().medium; }
    std::ptrdiff_t times_poured() {
        const auto events = session().recording().events;
        return std::ranges::count_if(events, [](const document::Event& event) {
            return std::holds_alternative<document::UseMedium>(event.action);
        });
    }
};

TEST_F(ThinningWindow, TheSliderPoursOnceItRests) {
    session().wait_until_applied();
    const auto poured = times_poured();
    for (const int step : {40, 80, 100})
        slider().setValue(step);
    EXPECT_EQ(medium().paint_share, 1.0);
    wait_for([&] { return medium().paint_share < 1.0; });
    EXPECT_NEAR(medium().paint_share, 0.1414, 0.0001) << "halfway by equal factors";
    session().wait_until_applied();
    EXPECT_EQ(times_poured(), poured + 1);
}

TEST_F(ThinningWindow, TheBrushThatComesOverTheCanvasHoldsWhatWasSetAMomentAgo) {
    slider().setValue(slider().maximum());
    mouse_stroke(line_mm({10, 10}, {30, 10}));
    EXPECT_EQ(medium().paint_share, film::kLeastPaintShare);
    session().wait_until_applied();
    EXPECT_GT(volume_mm3(), 0.0);
}

TEST_F(ThinningWindow, KeysThinAndThickenAndWash) {
    QTest::keyClick(&window(), Qt::Key_O);
    EXPECT_EQ(medium().paint_share, 0.75);
    EXPECT_GT(slider().value(), 0);
    QTest::keyClick(&window(), Qt::Key_U);
    EXPECT_EQ(medium().paint_share, 0.08);
    EXPECT_TRUE(action(Command::ThinWash)->isChecked());
    QTest::keyClick(&window(), Qt::Key_U);
    EXPECT_EQ(medium().paint_share, 0.75);
    EXPECT_FALSE(action(Command::ThinWash)->isChecked());
    QTest::keyClick(&window(), Qt::Key_O, Qt::ShiftModifier);
    EXPECT_EQ(medium().paint_share, 1.0);
    EXPECT_EQ(slider().value(), 0);
}

TEST_F(ThinningWindow, NothingThinsThinner) {
    EXPECT_TRUE(thinning().isEnabled());
    studio().easel().use_medium("thinner");
    studio().show_hand();
    EXPECT_FALSE(thinning().isEnabled());
    for (const auto command : {Command::MoreMedium, Command::MorePaint, Command::ThinWash})
        EXPECT_FALSE(action(command)->isEnabled());
}

TEST_F(ThinningWindow, ThePhysicsPanelShowsTheNumbersBeforeThinningAndKeepsTheShare) {
    action(Command::ThinWash)->trigger();
    auto& yield = *window().findChild<QDoubleSpinBox*>("yield_stress");
    EXPECT_EQ(yield.value(), 80.0);
    yield.setValue(40.0);
    wait_for([&] { return medium().own.has_value(); });
    EXPECT_EQ(medium().own->yield_stress_Pa, 40.0);
    EXPECT_EQ(medium().paint_share, 0.08);
}

/// Swatches of glazes over the ground are not those of paint from the tube.
TEST_F(ThinningWindow, SwatchesFollow) {
    studio().easel().choose_paint({{{"PB29", 1.0}}, 1.0});
    studio().show_hand();
    const QColor full = panels::shown_colour(studio().easel().hand().paint, parts().swatches.view());
    slider().setValue(slider().maximum());
    thinning().finish();
    const QColor stain = panels::shown_colour(studio().easel().hand().paint, parts().swatches.view());
    EXPECT_GT(stain.lightness(), full.lightness() + 20);
}

TEST_F(ThinningWindow, PaintPickedFromAWashIsAsStrongInTheWash) {
    studio().easel().choose_paint({{{"PB29", 1.0}}, 1.0});
    action(Command::ThinWash)->trigger();
    mouse_stroke(line_mm({10, 20}, {50, 20}));
    settle();
    action(Command::PickPaint)->trigger();
    press({30, 20});
    release({30, 20});
    EXPECT_EQ(studio().easel().hand().paint, (document::PaintRecipe{{{"PB29", 1.0}}, 1.0}));
}

TEST_F(ThinningWindow, ThePopUpPaletteThinsToo) {
    action(Command::PopupPalette)->trigger();
    auto& palette = *window().findChild<panels::PopupPalette*>();
    wait_until_shown(palette);
    auto& there = *palette.findChild<QSlider*>("paint_share");
    there.setValue(100);
    palette.hide();
    EXPECT_NEAR(medium().paint_share, 0.1414, 0.0001);
    EXPECT_EQ(slider().value(), 100);
}

}  // namespace
}  // namespace pastoso::tests
