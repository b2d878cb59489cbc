// What is read of pens that announce what they tell, and of those that do not.
#include "input/event_reader.hpp"

#include <QPointingDevice>
#include <QTabletEvent>
#include <gtest/gtest.h>

namespace pastoso::input {
namespace {

using Capability = QInputDevice::Capability;

class Pens : public testing::Test {
  protected:
    /// As Qt makes them up for pens under Wayland: they announce place and pressure alone.
    static QPointingDevice made_up(QPointingDevice::PointerType end) { return of(end, {}); }
    static QPointingDevice of(QPointingDevice::PointerType end, QInputDevice::Capabilities more) {
        return {QStringLiteral("fake tablet"),
                2,
                QInputDevice::DeviceType::Stylus,
                end,
                Capability::Position | Capability::Pressure | more,
                1,
                1};
    }

    tools::Pointer told(const QPointingDevice& device, float tilt_x_deg, float tilt_y_deg,
                        double rotation_deg) {
        const QTabletEvent event(QEvent::TabletMove, &device, {10.0, 20.0}, {10.0, 20.0}, 0.5,
                                 tilt_x_deg, tilt_y_deg, 0.0F, rotation_deg, 0.0F, Qt::NoModifier,
                                 Qt::NoButton, Qt::NoButton);
        return reader_.read(event).pointer;
    }

    EventReader reader_;
};

TEST_F(Pens, AnUprightPenThatAnnouncesTiltTellsIt) {
    const QPointingDevice pen = of(QPointingDevice::PointerType::Pen, Capability::XTilt);
    EXPECT_TRUE(told(pen, 0.0F, 0.0F, 0.0).tells_tilt);
    EXPECT_FALSE(told(pen, 0.0F, 0.0F, 0.0).rotation_deg);
}

TEST_F(Pens, TiltThatIsNotAnnouncedIsHeardFromTheFirstLeanOn) {
    for (const auto& [x_deg, y_deg] : {std::pair(7.0F, 0.0F), std::pair(0.0F, -7.0F)}) {
        const QPointingDevice pen = made_up(QPointingDevice::PointerType::Pen);
        EXPECT_FALSE(told(pen, 0.0F, 0.0F, 0.0).tells_tilt);
        const tools::Pointer leaning = told(pen, x_deg, y_deg, 0.0);
        EXPECT_TRUE(leaning.tells_tilt);
        EXPECT_EQ(leaning.tilt_x_deg, x_deg);
        EXPECT_EQ(leaning.tilt_y_deg, y_deg);
        EXPECT_TRUE(told(pen, 0.0F, 0.0F, 0.0).tells_tilt);  // it is held upright now
        reader_ = {};
    }
}

TEST_F(Pens, RotationThatIsNotAnnouncedIsHeardFromTheFirstTurnOn) {
    const QPointingDevice pen = made_up(QPointingDevice::PointerType::Pen);
    EXPECT_FALSE(told(pen, 5.0F, 0.0F, 0.0).rotation_deg);
    EXPECT_EQ(told(pen, 5.0F, 0.0F, 30.0).rotation_deg, 30.0);
    EXPECT_EQ(told(pen, 5.0F, 0.0F, 0.0).rotation_deg, 0.0);
}

TEST_F(Pens, WhatOneTellsIsNotBelievedOfAnother) {
    const QPointingDevice pen = made_up(QPointingDevice::PointerType::Pen);
    const QPointingDevice eraser = made_up(QPointingDevice::PointerType::Eraser);
    told(pen, 30.0F, 0.0F, 40.0);
    EXPECT_FALSE(told(eraser, 0.0F, 0.0F, 0.0).tells_tilt);
    EXPECT_FALSE(told(eraser, 0.0F, 0.0F, 0.0).rotation_deg);
    EXPECT_TRUE(told(pen, 0.0F, 0.0F, 0.0).tells_tilt);
}

}  // namespace
}  // namespace pastoso::input
