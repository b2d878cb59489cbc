// The panel of what the paint is like.
#include "app/window_fixture.hpp"
#include "film/medium.hpp"
#include "main/window_parts.hpp"
#include "panels/paint/medium_box.hpp"
#include "panels/paint/medium_panel.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <variant>

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QToolButton>

namespace pastoso::tests {
namespace {

using commands::Command;

class PhysicsWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (HasFatalFailure()) return;
        action(Command::PhysicsPanel)->trigger();
        find<panels::MediumPanel>("medium_panel").open_numbers(true);
    }
    template <class Widget>
    Widget& find(const char* name) {
        auto* found = window().findChild<Widget*>(QString::fromLatin1(name));
        if (found == nullptr) throw std::runtime_error(name);
        return *found;
    }
    void type(const char* number, const QString& text) {
        auto& box = find<QDoubleSpinBox>(number);
        box.setFocus();
        box.selectAll();
        QTest::keyClicks(&box, text);
        QTest::keyClick(&box, Qt::Key_Return);
    }
    /// In the panel, as if it had rested.
    void finish() { find<panels::MediumPanel>("medium_panel").finish(); }
    const document::UseMedium& medium() { return studio().easel().hand().medium; }
    std::ptrdiff_t times_poured() {
        const auto events = session().recording().events;
        return std::ranges::count_if(events, [](const document::Event& event) {
            return std::holds_alternative<document::UseMedium>(event.action);
        });
    }
};

TEST_F(PhysicsWindow, AKeyShowsIt) {
    find<QDockWidget>("physics_panel").hide();
    QTest::keyClick(&window(), Qt::Key_F6, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_TRUE(find<QDockWidget>("physics_panel").isVisible());
}

TEST_F(PhysicsWindow, ShowsTheNumbersOfTheMediumInHand) {
    // Eight below the first; the heading between the families is stepped over.
    for (int i = 0; i < 8; ++i)
        QTest::keyClick(&find<QComboBox>("kind_of_paint"), Qt::Key_Down);
    EXPECT_EQ(medium(), document::UseMedium{"house paint"});
    EXPECT_DOUBLE_EQ(find<QDoubleSpinBox>("viscosity").value(), 3000.0);
    EXPECT_DOUBLE_EQ(find<QDoubleSpinBox>("surface_tension").value(), 30.0);
    EXPECT_DOUBLE_EQ(find<QDoubleSpinBox>("solids").value(), 55.0);
    EXPECT_FALSE(find<QPushButton>("medium_reset").isEnabled());
}

TEST_F(PhysicsWindow, ANumberGoesIntoThePaintAndBack) {
    type("yield_stress", QStringLiteral("12.5"));
    finish();
    film::Medium expected = film::find_medium("heavy-body oil");
    expected.yield_stress_Pa = 12.5;
    EXPECT_EQ(medium(), (document::UseMedium{expected.name, expected}));
    mouse_stroke(line_mm({10, 10}, {30, 10}));
    session().wait_until_applied();
    EXPECT_GT(volume_mm3(), 0.0);
    EXPECT_EQ(session().capture().painting.value.medium, medium());

    QTest::mouseClick(&find<QPushButton>("medium_reset"), Qt::LeftButton);
    EXPECT_EQ(medium(), document::UseMedium{"heavy-body oil"});
    EXPECT_DOUBLE_EQ(find<QDoubleSpinBox>("yield_stress").value(), 80.0);
}

TEST_F(PhysicsWindow, TheViscosityGoesByFactors) {
    auto& slider = find<QSlider>("viscosity_slider");
    slider.setValue(slider.maximum() / 2);
    finish();
    EXPECT_NEAR(medium().own.value().viscosity_m2_s, 1e-3, 1e-6);
}

TEST_F(PhysicsWindow, NumbersThatContradictGoAlong) {
    type("receding_angle", QStringLiteral("50"));
    EXPECT_DOUBLE_EQ(find<QDoubleSpinBox>("advancing_angle").value(), 50.0);
    finish();
    EXPECT_DOUBLE_EQ(medium().own.value().advancing_angle_deg, 50.0);
    session().wait_until_applied();
    EXPECT_TRUE(session().take_errors().empty());
}

TEST_F(PhysicsWindow, ASliderThatIsDraggedPoursOnceWhenItRests) {
    session().wait_until_applied();
    const std::ptrdiff_t before = times_poured();
    auto& slider = find<QSlider>("yield_stress_slider");
    for (int step = 0; step < 40; ++step)
        slider.setValue(step);
    EXPECT_EQ(medium(), document::UseMedium{"heavy-body oil"});
    const double shown_Pa = find<QDoubleSpinBox>("yield_stress").value();
    wait_for([this] { return medium().own.has_value(); });
    EXPECT_EQ(medium().own.value().yield_stress_Pa, shown_Pa);
    session().wait_until_applied();
    EXPECT_EQ(times_poured(), before + 1);
}

TEST_F(PhysicsWindow, ABrushThatComesOverTheCanvasHoldsTheNewPaint) {
    find<QSlider>("yield_stress_slider").setValue(10);
    ASSERT_FALSE(medium().own.has_value());
    press({10, 10});
    EXPECT_TRUE(medium().own.has_value());
    release({10, 10});
    session().wait_until_applied();
    const auto events = session().recording().events;
    const auto poured = std::ranges::find_if(events, [](const document::Event& event) {
        const auto* use = std::get_if<document::UseMedium>(&event.action);
        return use != nullptr && use->own.has_value();
    });
    ASSERT_NE(poured, events.end());
    EXPECT_TRUE(std::ranges::any_of(poured, events.end(), [](const document::Event& event) {
        return std::holds_alternative<document::PenDown>(event.action);
    }));
}

TEST_F(PhysicsWindow, WhatIsSavedHasTheNumbersSetAMomentAgo) {
    const TemporaryFolder folder;
    find<QSlider>("yield_stress_slider").setValue(10);
    parts().files.save_painting(QString::fromStdString((folder.path() / "a.pastoso").string()));
    EXPECT_TRUE(session().capture().painting.value.medium.own.has_value());
    EXPECT_TRUE(parts().files.saver().wait().isEmpty());
}

TEST_F(PhysicsWindow, AnotherKindOfPaintDropsANumberThatMoves) {
    find<QSlider>("yield_stress_slider").setValue(10);
    for (int i = 0; i < 8; ++i)
        QTest::keyClick(&find<QComboBox>("kind_of_paint"), Qt::Key_Down);
    finish();
    EXPECT_EQ(medium(), document::UseMedium{"house paint"});
}

TEST_F(PhysicsWindow, ANumberThatMovesStaysWhenAnotherChoiceIsMade) {
    find<QSlider>("yield_stress_slider").setValue(10);
    const double chosen_Pa = find<QDoubleSpinBox>("yield_stress").value();
    action(Command::LargerBrush)->trigger();
    finish();
    EXPECT_EQ(medium().own.value().yield_stress_Pa, chosen_Pa);
}

TEST_F(PhysicsWindow, AWordMovesSeveralNumbersAndTheyMoveIt) {
    auto& stiff = find<QSlider>("stiff_to_runny");
    const int oil = stiff.value();
    stiff.setValue(stiff.maximum());
    EXPECT_DOUBLE_EQ(find<QDoubleSpinBox>("viscosity").value(), 20.0);
    EXPECT_DOUBLE_EQ(find<QDoubleSpinBox>("yield_stress").value(), 0.0);
    EXPECT_DOUBLE_EQ(find<QDoubleSpinBox>("density").value(), 1300.0);
    finish();
    EXPECT_EQ(medium().own.value().yield_stress_Pa, 0.0);
    find<QDoubleSpinBox>("viscosity").setValue(300000.0);
    EXPECT_EQ(stiff.value(), oil);
    auto& opaque = find<QSlider>("opaque_to_transparent");
    EXPECT_EQ(opaque.value(), 0);
    opaque.setValue(opaque.maximum());
    finish();
    EXPECT_DOUBLE_EQ(medium().own.value().pigment_share, 0.01);
}

TEST_F(PhysicsWindow, TheNumbersAreFoldedAtFirstAndComeBackAsTheyWere) {
    EXPECT_TRUE(find<QDoubleSpinBox>("viscosity").isVisible());
    start_again();
    action(Command::PhysicsPanel)->trigger();
    EXPECT_TRUE(find<QDoubleSpinBox>("viscosity").isVisible());
    QTest::mouseClick(&find<QToolButton>("medium_numbers"), Qt::LeftButton);
    EXPECT_FALSE(find<QDoubleSpinBox>("viscosity").isVisible());
    EXPECT_TRUE(find<QSlider>("stiff_to_runny").isVisible());
    start_again();
    EXPECT_FALSE(find<panels::MediumPanel>("medium_panel").numbers_open());
}

TEST_F(PhysicsWindow, TheListHasHeadingsSwatchesAndCapitals) {
    auto& box = find<panels::MediumBox>("kind_of_paint");
    EXPECT_EQ(box.itemText(0), QStringLiteral("Oils"));
    EXPECT_EQ(box.itemText(1), QStringLiteral("Heavy-body oil"));
    EXPECT_FALSE(box.model()->index(0, 0).flags() & Qt::ItemIsEnabled);
    const int last = box.findData(QStringLiteral("thinner"));
    EXPECT_EQ(box.count(), last + 1);
    box.showPopup();
    wait_for([&] { return !box.swatch(QStringLiteral("thinner")).isNull(); });
    for (const film::Medium& medium : film::bundled_media()) {
        const QImage swatch = box.swatch(QString::fromStdString(medium.name));
        EXPECT_EQ(swatch.deviceIndependentSize().toSize(), panels::kMediumSwatch) << medium.name;
    }
    box.hidePopup();
}

}  // namespace
}  // namespace pastoso::tests
