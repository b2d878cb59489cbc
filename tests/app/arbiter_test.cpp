// Which of several devices is heard.
#include "input/arbiter.hpp"

#include <gtest/gtest.h>

namespace pastoso::input {
namespace {

using Verdict = Arbiter::Verdict;

PointerEvent event(Device device, Kind kind, bool down, std::uint64_t time_ms = 1000) {
    PointerEvent event;
    event.device = device;
    event.kind = kind;
    event.button = kind == Kind::Move ? Qt::NoButton : Qt::LeftButton;
    event.buttons = down ? Qt::LeftButton : Qt::NoButton;
    event.pointer.time_ms = time_ms;
    return event;
}

TEST(Arbiter, AStrokeBelongsToItsDeviceUntilItLifts) {
    for (const auto& [first, second] :
         {std::pair(Device::Pen, Device::Mouse), std::pair(Device::Mouse, Device::Pen)}) {
        Arbiter arbiter;
        EXPECT_EQ(arbiter.judge(event(first, Kind::Press, true)), Verdict::Hear);
        EXPECT_EQ(arbiter.judge(event(second, Kind::Press, true)), Verdict::Ignore);
        EXPECT_EQ(arbiter.judge(event(second, Kind::Release, false)), Verdict::Ignore);
        EXPECT_EQ(arbiter.judge(event(first, Kind::Move, true)), Verdict::Hear);
        EXPECT_EQ(arbiter.judge(event(first, Kind::Release, false)), Verdict::Hear);
        EXPECT_EQ(arbiter.judge(event(second, Kind::Press, true)), Verdict::Hear);
    }
}

TEST(Arbiter, AReleaseThatGotLostHoldsNobodyUp) {
    Arbiter arbiter;
    arbiter.judge(event(Device::Mouse, Kind::Press, true));
    arbiter.judge(event(Device::Mouse, Kind::Move, false));
    EXPECT_EQ(arbiter.judge(event(Device::Pen, Kind::Press, true)), Verdict::Hear);
}

TEST(Arbiter, BothEndsOfAPenAreOneDevice) {
    Arbiter arbiter;
    arbiter.judge(event(Device::Pen, Kind::Press, true));
    EXPECT_EQ(arbiter.judge(event(Device::Eraser, Kind::Move, true)), Verdict::Hear);
}

TEST(Arbiter, FingersBesideAPenAreTheHandThatHoldsIt) {
    Arbiter arbiter;
    EXPECT_TRUE(arbiter.hears_fingers(10));
    arbiter.judge(event(Device::Pen, Kind::Move, false, 1000));
    EXPECT_FALSE(arbiter.hears_fingers(1100));
    EXPECT_TRUE(arbiter.hears_fingers(2000));
    arbiter.judge(event(Device::Pen, Kind::Press, true, 2000));
    EXPECT_FALSE(arbiter.hears_fingers(9000)) << "it presses, however long ago it moved";
}

TEST(Arbiter, APenTakesThePlaceOfFingersAndAMouseDoesNot) {
    Arbiter arbiter;
    arbiter.fingers_hold(true);
    EXPECT_EQ(arbiter.judge(event(Device::Mouse, Kind::Press, true)), Verdict::Ignore);
    EXPECT_EQ(arbiter.judge(event(Device::Pen, Kind::Press, true)), Verdict::TakeOver);
    arbiter.fingers_hold(false);
    EXPECT_EQ(arbiter.judge(event(Device::Mouse, Kind::Press, true)), Verdict::Ignore)
        << "the pen has it";
}

}  // namespace
}  // namespace pastoso::input
