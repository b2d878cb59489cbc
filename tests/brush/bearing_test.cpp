// What a tool bears on: hairs sink to the dry surface, a stiff edge lies on its highest parts, a flat
// blade is carried by the wet paint that it finds, never by its own.

#include "brush/bearing.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::brush::test {
namespace {

constexpr float kSupport_mm = 0.1F, kEdge_mm = 0.25F, kWet_mm = 0.4F;

/// 8 x 8 cells of a millimetre, level; the right half lies under wet paint.
class BearingTest : public ::testing::Test {
  protected:
    BearingTest() {
        for (int y = 0; y < 8; ++y) {
            for (int x = 0; x < 8; ++x) {
                film_.support_mm.set(x, y, kSupport_mm);
                if (x >= 4) film_.thickness.set(x, y, quanta(kWet_mm));
            }
        }
        poses_.resize(2);
        place(poses_[0], 1.5);
        place(poses_[1], 6.5);
    }

    static std::int32_t quanta(float mm) {
        return static_cast<std::int32_t>(mm / film::kThicknessQuantum_mm);
    }
    static void place(BristlePose& pose, double x_mm) {
        pose.down = true;
        pose.x_mm = x_mm;
        pose.y_mm = 3.5;
        pose.support_mm = kSupport_mm;
    }
    void bear_once(float rigidity, float ride, float sinking_mm = 100.0F) {
        bear({.rigidity = rigidity,
              .ride = ride,
              .edge_support_mm = kEdge_mm,
              .sinking_mm = sinking_mm},
             film_, pass_, poses_);
    }
    void bear_hairs(float ride, double tuft_mm = 0.0) {
        bear({.ride = ride, .is_edge = false, .tuft_mm = tuft_mm, .sinking_mm = 100.0F}, film_, pass_,
             poses_);
    }
    /// A pass over the cell below the second element begins.
    void find_there() {
        const int tile = film_.shape.tile_at(6, 3), cell = grid::Shape::cell_in_tile(6, 3);
        const PassTile pass = pass_.tile(tile);
        pass.begun_mm[cell] = 0.0F;
        pass.found[cell] = film_.thickness.at(6, 3);
    }

    film::FilmState film_{{8, 8}, 1.0};
    PassMap pass_{film_.shape, 5.0};
    std::vector<BristlePose> poses_;
};

/// Quanta are 30 nm, and floats of these sizes as fine.
constexpr float kClose_mm = 1e-4F;

TEST_F(BearingTest, HairsSinkToTheDrySurface) {
    bear_once(0.0F, 0.0F);
    EXPECT_EQ(poses_[0].bearing_mm, kSupport_mm);
    EXPECT_EQ(poses_[1].bearing_mm, kSupport_mm);
}

TEST_F(BearingTest, AStiffEdgeLiesOnWhatIsHighestBelowIt) {
    bear_once(1.0F, 0.0F);
    EXPECT_NEAR(poses_[0].bearing_mm, kEdge_mm, kClose_mm);
    EXPECT_NEAR(poses_[1].bearing_mm, kEdge_mm, kClose_mm);
}

TEST_F(BearingTest, AStiffBladeThatRidesIsCarriedByTheMeanOfWhatItFinds) {
    bear_once(1.0F, 1.0F);
    EXPECT_NEAR(poses_[0].bearing_mm, kSupport_mm + 0.5F * kWet_mm, kClose_mm);
    EXPECT_NEAR(poses_[1].bearing_mm, poses_[0].bearing_mm, kClose_mm);
}

TEST_F(BearingTest, ASoftOneFollowsThePaintBelowEachElement) {
    bear_once(0.0F, 1.0F);
    EXPECT_NEAR(poses_[0].bearing_mm, kSupport_mm, kClose_mm);
    EXPECT_NEAR(poses_[1].bearing_mm, kSupport_mm + kWet_mm, kClose_mm);
}

TEST_F(BearingTest, HairsAreCarriedBesideEachOther) {
    bear_hairs(0.5F);
    EXPECT_EQ(poses_[0].bearing_mm, kSupport_mm);
    EXPECT_EQ(poses_[0].ride, 0.0F) << "nothing is wet there";
    EXPECT_NEAR(poses_[1].bearing_mm, kSupport_mm + 0.5F * kWet_mm, kClose_mm);
    EXPECT_EQ(poses_[1].ride, 0.5F);
}

TEST_F(BearingTest, ThinPaintCarriesHairsLess) {
    film_.thickness.set(6, 3, quanta(0.02F));
    bear_hairs(0.5F);
    EXPECT_NEAR(poses_[1].ride, 0.5F * 0.02F / 0.05F, 1e-3F);
    EXPECT_NEAR(poses_[1].bearing_mm, kSupport_mm + 0.2F * 0.02F, kClose_mm);
}

TEST_F(BearingTest, HairsLieOnTheHighestPaintBelowTheirTuft) {
    film_.thickness.set(7, 3, quanta(0.6F));
    bear_hairs(1.0F, 0.9);
    EXPECT_NEAR(poses_[1].bearing_mm, kSupport_mm + 0.6F, kClose_mm);
}

TEST_F(BearingTest, HalfARideIsHalfWayUpOnTheMeanAndInStripes) {
    constexpr int kElements = 3000;
    poses_.assign(kElements, poses_[1]);
    bear_once(0.0F, 0.5F);
    double sum_mm = 0.0, lowest_mm = 10.0, highest_mm = 0.0;
    for (const BristlePose& pose : poses_) {
        sum_mm += pose.bearing_mm;
        lowest_mm = std::min<double>(lowest_mm, pose.bearing_mm);
        highest_mm = std::max<double>(highest_mm, pose.bearing_mm);
    }
    // A thousand stripes, each off by 0.12 mm in the root mean square: four times that of their mean.
    EXPECT_NEAR(sum_mm / kElements, kSupport_mm + 0.5 * kWet_mm, 4.0 * 0.12 / std::sqrt(1000.0));
    EXPECT_LT(lowest_mm, kSupport_mm + 0.1 * kWet_mm);
    EXPECT_GT(highest_mm, kSupport_mm + 0.9 * kWet_mm);
    EXPECT_EQ(poses_[0].bearing_mm, poses_[2].bearing_mm);
}

TEST_F(BearingTest, ABladeDoesNotClimbOntoItsOwnPaint) {
    find_there();
    film_.thickness.set(6, 3, quanta(3.0F));
    bear_once(0.0F, 1.0F);
    EXPECT_NEAR(poses_[1].bearing_mm, kSupport_mm + kWet_mm, kClose_mm);
}

TEST_F(BearingTest, ABladeComesDownSlowlyAndGoesUpAtOnce) {
    poses_[1].bearing_mm = 2.0F;
    bear_once(0.0F, 1.0F, 0.25F);
    EXPECT_NEAR(poses_[1].bearing_mm, 1.75F, kClose_mm);
    poses_[1].bearing_mm = 0.0F;
    bear_once(0.0F, 1.0F, 0.25F);
    EXPECT_NEAR(poses_[1].bearing_mm, kSupport_mm + kWet_mm, kClose_mm);
}

TEST_F(BearingTest, PressureAndTiltTakeTheRideAway) {
    const Preset& knife = find_preset("Palette knife 17");
    const auto ride = [&](double pressure, double tilt_deg) {
        PathStep step;
        step.pen.pressure = pressure;
        step.pen.tilt_x_deg = tilt_deg;
        return ride_of(knife.flex, hand_pose(knife.dynamics, step));
    };
    EXPECT_EQ(ride(0.2, 0.0), 1.0F);
    EXPECT_EQ(ride(0.9, 0.0), 0.0F);
    EXPECT_EQ(ride(0.2, 60.0), 0.0F);
    EXPECT_GT(ride(0.5, 0.0), ride(0.6, 0.0));
    EXPECT_GT(ride(0.2, 20.0), ride(0.2, 35.0));
    EXPECT_EQ(ride_of(find_preset("Flat bristle 20").flex, HandPose{}), 0.0F);
}

}  // namespace
}  // namespace pastoso::brush::test
