// The panel of what the paint is like.
#include "app/window_fixture.hpp"
#include "film/medium.hpp"

#include <stdexcept>

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QTest>

namespace pastoso::tests {
namespace {

using commands::Command;

class PhysicsWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (!IsSkipped()) action(Command::PhysicsPanel)->trigger();
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
    const document::UseMedium& medium() { return window().easel().hand().medium; }
};

TEST_F(PhysicsWindow, AKeyShowsIt) {
    find<QDockWidget>("physics_panel").hide();
    QTest::keyClick(&window(), Qt::Key_F6, Qt::ShiftModifier);
    EXPECT_TRUE(find<QDockWidget>("physics_panel").isVisible());
}

TEST_F(PhysicsWindow, ShowsTheNumbersOfTheMediumInHand) {
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(&find<QComboBox>("kind_of_paint"), Qt::Key_Down);
    EXPECT_EQ(medium(), document::UseMedium{"house paint"});
    EXPECT_DOUBLE_EQ(find<QDoubleSpinBox>("viscosity").value(), 3000.0);
    EXPECT_DOUBLE_EQ(find<QDoubleSpinBox>("surface_tension").value(), 30.0);
    EXPECT_DOUBLE_EQ(find<QDoubleSpinBox>("solids").value(), 55.0);
    EXPECT_FALSE(find<QPushButton>("medium_reset").isEnabled());
}

TEST_F(PhysicsWindow, ANumberGoesIntoThePaintAndBack) {
    type("yield_stress", QStringLiteral("12.5"));
    film::Medium expected = film::find_medium("heavy-body oil");
    expected.yield_stress_Pa = 12.5;
    EXPECT_EQ(medium(), (document::UseMedium{expected.name, expected}));
    mouse_stroke(line_mm({10, 10}, {30, 10}));
    session().wait_until_applied();
    EXPECT_GT(volume_mm3(), 0.0);
    EXPECT_EQ(session().capture().painting.medium, medium());

    QTest::mouseClick(&find<QPushButton>("medium_reset"), Qt::LeftButton);
    EXPECT_EQ(medium(), document::UseMedium{"heavy-body oil"});
    EXPECT_DOUBLE_EQ(find<QDoubleSpinBox>("yield_stress").value(), 80.0);
}

TEST_F(PhysicsWindow, TheViscosityGoesByFactors) {
    auto& slider = find<QSlider>("viscosity_slider");
    slider.setValue(slider.maximum() / 2);
    EXPECT_NEAR(medium().own.value().viscosity_m2_s, 1e-3, 1e-6);
}

TEST_F(PhysicsWindow, NumbersThatContradictGoAlong) {
    type("receding_angle", QStringLiteral("50"));
    EXPECT_DOUBLE_EQ(medium().own.value().advancing_angle_deg, 50.0);
    EXPECT_DOUBLE_EQ(find<QDoubleSpinBox>("advancing_angle").value(), 50.0);
    session().wait_until_applied();
    EXPECT_TRUE(session().take_errors().empty());
}

}  // namespace
}  // namespace pastoso::tests
