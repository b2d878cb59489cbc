// A tea that goes on from a state is the one that was not interrupted, bit for bit.
#include "core/error.hpp"
#include "liquid/tea/milk_tea.hpp"

#include <functional>
#include <limits>

#include <gtest/gtest.h>

namespace pastoso::liquid {
namespace {

TeaSettings small_tea() {
    TeaSettings settings;
    settings.cells = 16;
    settings.parcels = 500;
    settings.pour_s = 0.5;
    settings.first_ball_s = 0.3;
    settings.ball_interval_s = 0.1;
    return settings;
}

void run(MilkTea& tea, int steps, core::ThreadPool& pool) {
    for (int i = 0; i < steps; ++i)
        tea.step(pool);
}

/// Stops after so many steps; both are the same after thirty more.
void expect_goes_on(
    const TeaSettings& settings, int stopped_after,
    const std::function<void(MilkTea&)>& before = [](MilkTea&) {}) {
    core::ThreadPool pool(2);
    MilkTea whole(settings);
    before(whole);
    run(whole, stopped_after, pool);
    MilkTea resumed(settings);
    resumed.set_state(whole.state());
    EXPECT_EQ(resumed.state(), whole.state());
    run(whole, 30, pool);
    run(resumed, 30, pool);
    EXPECT_EQ(resumed.time_s(), whole.time_s());
    EXPECT_EQ(resumed.parcels(), whole.parcels());
    EXPECT_EQ(resumed.state(), whole.state());
}

TEST(MilkTeaState, GoesOnWhileMilkIsPouredAndAfter) {
    for (const int stopped_after : {0, 1, 2, 10, 25})
        expect_goes_on(small_tea(), stopped_after);
}

TEST(MilkTeaState, GoesOnWithSwirlAndConfinement) {
    TeaSettings settings = small_tea();
    settings.swirl_rad_s2 = 3.0;
    settings.push_m_s2 = 0.1;
    settings.confinement = 0.2;
    for (const int stopped_after : {1, 12})
        expect_goes_on(settings, stopped_after);
}

TEST(MilkTeaState, GoesOnReflected) {
    TeaSettings settings = small_tea();
    settings.advection = VelocityAdvection::Reflected;
    settings.confinement = 0.2;
    for (const int stopped_after : {1, 12})
        expect_goes_on(settings, stopped_after);
}

TEST(MilkTeaState, GoesOnWithLongStepsOfViscosity) {
    TeaSettings settings = small_tea();
    for (const double viscosity_m2_s : {1e-3, 0.1}) {
        settings.viscosity_m2_s = viscosity_m2_s;
        expect_goes_on(settings, 12);
    }
}

TEST(MilkTeaState, GoesOnWhileAHandPours) {
    expect_goes_on(small_tea(), 12, [](MilkTea& tea) { tea.pour_by_hand(glm::vec2(0.04F, 0.05F)); });
}

TEST(MilkTeaState, TakesTheStateOfTheSameGlassAlone) {
    core::ThreadPool pool(1);
    MilkTea tea(small_tea());
    run(tea, 12, pool);
    const TeaState sound = tea.state();
    ASSERT_FALSE(sound.parcels.empty());
    const auto refuses = [&](const std::function<void(TeaState&)>& spoil) {
        TeaState state = sound;
        spoil(state);
        MilkTea other(small_tea());
        EXPECT_THROW(other.set_state(state), core::InputError);
        // And is what it was.
        EXPECT_EQ(other.steps(), 0);
        EXPECT_TRUE(other.parcels().empty());
        EXPECT_NO_THROW(other.step(pool));
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    refuses([&](TeaState& state) { state.parcels[0].position_m.y = nan; });
    refuses([](TeaState& state) { state.parcels[0].position_m.x = 0.2F; });
    refuses([](TeaState& state) { state.parcels[0].ball = state.balls.count; });
    refuses([](TeaState& state) { state.parcels[0].volume_m3 = -1.0F; });
    refuses([](TeaState& state) { state.step = -1; });
    refuses([](TeaState& state) { state.balls.count = 1 << 29; });
    refuses([](TeaState& state) { state.jug.recipe.parcels = -1; });
    refuses([](TeaState& state) { state.jug.poured_m3 = std::numeric_limits<double>::infinity(); });
    refuses([](TeaState& state) { state.jug.recipe.until_s = -1.0; });
    refuses([&](TeaState& state) { state.jug.hand.at_m.x = nan; });
    const grid::BoxField smaller(grid::BoxShape{8, 8, 8, 0.0125F});
    refuses([&](TeaState& state) { state.coldness = smaller; });
    refuses([&](TeaState& state) { state.flow.velocity.y = smaller; });
    refuses([&](TeaState& state) { state.flow.pressure = smaller; });
    refuses([&](TeaState& state) { state.flow.spare_cells[1] = smaller; });
    refuses([&](TeaState& state) { state.flow.spare_cells.resize(9, state.dissolved); });
}

}  // namespace
}  // namespace pastoso::liquid
