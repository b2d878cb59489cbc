#include "liquid/tea/tea_settings.hpp"

#include "core/value_range.hpp"

#include <algorithm>

namespace pastoso::liquid {
namespace {

using core::check_range;
using S = TeaSettings;

constexpr TeaNumber kNumbers[] = {
    {"box_m", "m", &S::box_m, 0.01, 10.0, "Side of the cube that is simulated"},
    {"step_s", "s", &S::step_s, 1e-4, 0.2, "Length of a time step"},
    {"tolerance", "", &S::tolerance, 1e-6, 0.1, "How exact the pressure is solved"},
    {"milk_m3", "m3", &S::milk_m3, 0.0, 1.0, "How much milk is poured"},
    {"pour_s", "s", &S::pour_s, 1e-3, 3600.0, "How long it is poured"},
    {"pour_radius_m", "m", &S::pour_radius_m, 1e-4, 1.0, "Radius of the stream at the jug's lip"},
    {"pour_speed_m_s", "m/s", &S::pour_speed_m_s, 0.0, 10.0, "Speed of the stream there, downwards"},
    {"pour_height_m", "m", &S::pour_height_m, 0.0, 1.0, "How high above the level the lip is"},
    {"fat_m_s2", "m/s2", &S::fat_m_s2, 0.0, 20.0, "How fast fat lets milk rise"},
    {"cold_m_s2", "m/s2", &S::cold_m_s2, 0.0, 20.0, "How fast cold lets milk sink"},
    {"dissolved_m_s2", "m/s2", &S::dissolved_m_s2, 0.0, 20.0, "How fast tea with milk in it sinks"},
    {"viscosity_m2_s", "m2/s", &S::viscosity_m2_s, 0.0, 1.0, "Kinematic viscosity"},
    {"heat_diffusion_m2_s", "m2/s", &S::heat_diffusion_m2_s, 0.0, 1.0, "How heat spreads"},
    {"milk_diffusion_m2_s", "m2/s", &S::milk_diffusion_m2_s, 0.0, 1.0, "How dissolved milk spreads"},
    {"confinement", "", &S::confinement, 0.0, 0.3, "Force that keeps small whirls alive"},
    {"slow_warming_s", "s", &S::slow_warming_s, 1e-2, 1e6, "Time in which milk at rest warms"},
    {"fast_warming_s", "s", &S::fast_warming_s, 1e-2, 1e6, "Time in which a ball warms"},
    {"chill_share", "", &S::chill_share, 0.0, 1.0, "Share of the milk's cold that the tea gets"},
    {"first_ball_s", "s", &S::first_ball_s, 0.0, 1e6, "When the first ball forms"},
    {"ball_interval_s", "s", &S::ball_interval_s, 1e-2, 1e6, "Time between two balls, in the mean"},
    {"ball_radius_m", "m", &S::ball_radius_m, 1e-4, 1.0, "Radius of a ball, in the mean"},
    {"ball_radius_spread", "", &S::ball_radius_spread, 0.0, 0.9, "How much balls differ in size"},
    {"dissolving_s", "s", &S::dissolving_s, 1e-2, 1e9, "Time in which a warm ball dissolves"},
    {"dissolving_on_top_s", "s", &S::dissolving_on_top_s, 1e-2, 1e9, "The same under the surface"},
    {"top_depth_m", "m", &S::top_depth_m, 0.0, 1.0, "How far down that is"},
    {"dissolving_at_rest_s", "s", &S::dissolving_at_rest_s, 1e-2, 1e9, "The same of milk at rest"},
    {"rest_ends_s", "s", &S::rest_ends_s, 0.0, 1e9, "When all milk begins to dissolve"},
    {"warm_below", "", &S::warm_below, 0.0, 1.0, "Coldness below which a ball dissolves"},
    {"swirl_rad_s2", "rad/s2", &S::swirl_rad_s2, -1e3, 1e3, "Force around an upright axis"},
    {"push_m_s2", "m/s2", &S::push_m_s2, -1e3, 1e3, "Force downwards"},
    {"force_reach_m", "m", &S::force_reach_m, 1e-3, 10.0, "How far the force reaches from its axis"},
    {"swirl_x_m", "m", &S::swirl_x_m, -10.0, 10.0, "Where that axis stands"},
    {"swirl_y_m", "m", &S::swirl_y_m, -10.0, 10.0, "Where that axis stands"},
};

void check_cup(const Cup& cup, double box_m) {
    const double box = box_m;
    check_range("cup.floor_m", static_cast<double>(cup.floor_m), 0.0, box);
    check_range("cup.level_m", static_cast<double>(cup.level_m), static_cast<double>(cup.floor_m) + 1e-4,
                box);
    check_range("cup.rim_m", static_cast<double>(cup.rim_m), static_cast<double>(cup.level_m), 10.0);
    check_range("cup.slope", static_cast<double>(cup.slope), -1.0, 1.0);
    check_range("cup.wall_m", static_cast<double>(cup.wall_m), 1e-5, 1.0);
    check_range("cup.foot_m", static_cast<double>(cup.foot_m), -1.0,
                static_cast<double>(cup.floor_m) - 1e-5);
    for (const int axis : {0, 1}) {
        const auto middle = static_cast<double>(cup.axis_m[axis]);
        const double to_wall = std::min(middle, box - middle);
        check_range("cup.floor_radius_m", static_cast<double>(cup.floor_radius_m), 1e-4, to_wall);
        core::check_range_of("The cup's radius at its level",
                             static_cast<double>(cup.inner_radius_m(cup.level_m)), 1e-4, to_wall);
    }
}

}  // namespace

std::span<const TeaNumber> tea_numbers() {
    return kNumbers;
}

void check_tea(const TeaSettings& settings) {
    check_range("cells", settings.cells, kMinTeaCells, kMaxTeaCells);
    check_range("parcels", settings.parcels, 1, kMaxParcels);
    check_range("ball_candidates", settings.ball_candidates, 1, 100000);
    for (const TeaNumber& number : tea_numbers())
        check_range(number.key, settings.*number.value, number.least, number.most);
    check_cup(settings.cup, settings.box_m);
    check_range("milk_m3", settings.milk_m3, 0.0, 0.5 * tea_volume_m3(settings.cup));
}

}  // namespace pastoso::liquid
