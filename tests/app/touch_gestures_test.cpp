// What fingers mean, event by event; and the notches of an airbrush's wheel.
#include "input/touch_gestures.hpp"

#include "input/wheel_steps.hpp"

#include <string>

#include <gtest/gtest.h>

namespace pastoso::input {
namespace {

class Touching : public testing::Test {
  protected:
    /// What follows from these fingers being down, a letter a step.
    std::string down(const std::vector<Finger>& fingers, int after_ms = 10) {
        now_ms_ += static_cast<std::uint64_t>(after_ms);
        return letters(gestures_.follow(fingers, now_ms_, yields_));
    }
    std::string letters(std::vector<TouchStep> steps) {
        steps_ = std::move(steps);
        std::string letters;
        for (const TouchStep& step : steps_)
            letters += "PMRCNT"[static_cast<int>(step.does)];
        return letters;
    }

    TouchGestures gestures_;
    std::vector<TouchStep> steps_;
    bool yields_ = false;

  private:
    std::uint64_t now_ms_ = 5000;
};

TEST_F(Touching, OneFingerWaitsUntilItMovesAndBeginsWhereItCameDown) {
    EXPECT_EQ(down({{7, {100, 50}}}), "");
    EXPECT_TRUE(gestures_.waits());
    EXPECT_EQ(down({{7, {103, 50}}}), "");
    EXPECT_EQ(down({{7, {109, 50}}}), "PM");
    EXPECT_EQ(steps_[0].finger.place, QPointF(100, 50));
    EXPECT_EQ(steps_[1].finger.place, QPointF(109, 50));
    EXPECT_EQ(down({{7, {130, 60}}}), "M");
    EXPECT_EQ(down({}), "R");
    EXPECT_EQ(steps_[0].finger.place, QPointF(130, 60));
}

TEST_F(Touching, AFingerThatHardlyMovedLeavesATouch) {
    down({{1, {100, 50}}});
    EXPECT_EQ(down({}), "PR");
}

TEST_F(Touching, AFingerThatWasHeldDoesNothingMore) {
    down({{1, {100, 50}}});
    gestures_.spend();
    EXPECT_EQ(down({{1, {150, 50}}}), "");
    EXPECT_EQ(down({{1, {150, 50}}, {2, {10, 10}}}), "");
    EXPECT_EQ(down({}), "");
    down({{1, {100, 50}}});
    EXPECT_TRUE(gestures_.waits()) << "the next one begins anew";
}

TEST_F(Touching, TwoFingersPinchAsFarAsTheyWent) {
    down({{1, {0, 0}}});
    EXPECT_EQ(down({{1, {0, 0}}, {2, {100, 0}}}), "");
    EXPECT_EQ(down({{1, {2, 0}}, {2, {104, 0}}}), "") << "they may still tap";
    EXPECT_EQ(down({{1, {4, 0}}, {2, {120, 0}}}), "N");
    EXPECT_EQ(steps_[0].from[1], QPointF(100, 0));
    EXPECT_EQ(steps_[0].to[1], QPointF(120, 0));
    EXPECT_EQ(down({{1, {5, 0}}, {2, {121, 0}}}), "N");
    EXPECT_EQ(steps_[0].from[1], QPointF(120, 0));
    EXPECT_EQ(down({{1, {5, 0}}}), "");
    EXPECT_EQ(down({{1, {50, 0}}}), "") << "the finger that is left paints nothing";
    EXPECT_EQ(down({}), "");
}

TEST_F(Touching, AnotherPairOfFingersBeginsWhereItIs) {
    down({{1, {0, 0}}, {2, {100, 0}}});
    down({{1, {0, 0}}, {2, {200, 0}}});
    EXPECT_EQ(down({{2, {200, 0}}, {3, {500, 0}}}), "");
    EXPECT_EQ(down({{2, {200, 0}}, {3, {520, 0}}}), "N");
    EXPECT_EQ(steps_[0].from[1], QPointF(500, 0));
}

TEST_F(Touching, ShortTapsAreCountedLongOnesAreNot) {
    for (int fingers = 2; fingers <= 4; ++fingers) {
        std::vector<Finger> all;
        for (int i = 0; i < fingers; ++i) {
            all.push_back({i, {50.0 * i, 10.0}});
            EXPECT_EQ(down(all), "");
        }
        all.pop_back();
        EXPECT_EQ(down(all), "") << "they do not lift at once";
        ASSERT_EQ(down({}), "T");
        EXPECT_EQ(steps_[0].fingers, fingers);
    }
    down({{1, {0, 0}}, {2, {100, 0}}});
    EXPECT_EQ(down({}, 400), "") << "they rested";
}

TEST_F(Touching, WhatOneFingerPaintsIsNotEndedByASecond) {
    down({{1, {0, 0}}});
    down({{1, {20, 0}}});
    EXPECT_EQ(down({{1, {20, 0}}, {2, {90, 90}}}), "");
    EXPECT_EQ(down({{1, {20, 0}}, {2, {90, 130}}}), "");
    EXPECT_EQ(down({}), "R");
}

TEST_F(Touching, WhatOneFingerPaintsIsItsOwnWhateverOthersDo) {
    down({{1, {0, 0}}});
    down({{1, {20, 0}}});
    EXPECT_EQ(down({{1, {25, 0}}, {2, {90, 90}}}), "M") << "it goes on beside another";
    EXPECT_EQ(steps_[0].finger.id, 1);
    EXPECT_EQ(down({{2, {95, 95}}, {1, {30, 0}}}), "M") << "in whatever order they are told";
    EXPECT_EQ(steps_[0].finger.place, QPointF(30, 0));
    EXPECT_EQ(down({{2, {95, 95}}}), "R") << "its stroke ends where it lifts, not at the other";
    EXPECT_EQ(steps_[0].finger.place, QPointF(30, 0));
    EXPECT_EQ(down({{2, {300, 95}}}), "");
    EXPECT_EQ(down({}), "");
    down({{2, {0, 0}}});
    EXPECT_EQ(down({{2, {20, 0}}}), "PM") << "the next one begins anew";
}

TEST_F(Touching, AFingerThatIsReplacedAtOnceLeavesItsTouch) {
    down({{1, {100, 50}}});
    EXPECT_EQ(down({{2, {300, 50}}}), "PR");
    EXPECT_EQ(steps_[1].finger.id, 1);
    EXPECT_EQ(down({{2, {400, 50}}}), "");
    EXPECT_EQ(down({}), "");
}

TEST_F(Touching, WhatOneFingerMovesIsMovedOnByTwo) {
    yields_ = true;
    down({{1, {0, 0}}});
    down({{1, {20, 0}}});
    EXPECT_EQ(down({{1, {20, 0}}, {2, {90, 90}}}), "R");
    EXPECT_EQ(down({{1, {20, 0}}, {2, {90, 130}}}), "N");
    EXPECT_EQ(down({}), "");
}

TEST_F(Touching, GivenUpTheyMeanNothing) {
    down({{1, {0, 0}}});
    EXPECT_EQ(letters(gestures_.cancel()), "") << "it has not begun";
    down({{1, {0, 0}}});
    down({{1, {20, 0}}});
    EXPECT_EQ(letters(gestures_.cancel()), "C");
    down({{1, {0, 0}}, {2, {100, 0}}});
    EXPECT_EQ(letters(gestures_.cancel()), "");
    EXPECT_EQ(down({}), "");
}

TEST(WheelSteps, AreWholeNotchesFromWhereItWas) {
    WheelSteps wheel;
    EXPECT_EQ(wheel.moved_to(0.4), 0) << "nobody knows how it came there";
    EXPECT_EQ(wheel.moved_to(0.45), 0);
    EXPECT_EQ(wheel.moved_to(0.5), 1);
    EXPECT_EQ(wheel.moved_to(0.45), 0);
    EXPECT_EQ(wheel.moved_to(0.19), -3);
    EXPECT_EQ(wheel.moved_to(1.0), 8);
    EXPECT_EQ(wheel.moved_to(-1.0), -20);
}

}  // namespace
}  // namespace pastoso::input
