// The numbers of a glass of milk tea: its vessel, the pouring, what milk and tea do to one another.
// Metres, seconds, cubic metres; z up.
#pragma once

#include "liquid/flow/flow.hpp"
#include "liquid/vessel/cup.hpp"

#include <cstdint>
#include <span>

namespace pastoso::liquid {

/// Milk is poured cold, and cold milk sinks: its buoyancy is fat_m_s2 m - cold_m_s2 T - dissolved_m_s2
/// c, where m is the share of milk in a cell, T its coldness and c the share of dissolved milk. Heat
/// passes faster than milk, so that a ball that has warmed rises before it dissolves (double diffusion).
struct TeaSettings {
    Cup cup;              ///< its level as it is when the recipe's milk has been poured
    int cells = 64;       ///< along each side of the box
    int parcels = 400'000;  ///< of milk
    std::uint32_t seed = 7;
    VelocityAdvection advection = VelocityAdvection::Once;

    double box_m = 0.1;          ///< side of the cube that is simulated
    double step_s = 1.0 / 30.0;  ///< of time
    double tolerance = 1e-3;     ///< of the pressure: residual against the right-hand side

    double milk_m3 = 26e-6;
    double pour_s = 1.6;           ///< duration
    double pour_radius_m = 0.006;  ///< of the stream at the lip of the jug
    double pour_speed_m_s = 0.16;  ///< of the stream there, downwards
    double pour_height_m = 0.005;  ///< of the lip above the level

    double fat_m_s2 = 0.30;
    double cold_m_s2 = 0.62;
    double dissolved_m_s2 = 0.03;
    double viscosity_m2_s = 2e-6;
    double heat_diffusion_m2_s = 2e-6;
    double milk_diffusion_m2_s = 3e-5;
    double confinement = 0.0;  ///< of vorticity (Fedkiw, Stam and Jensen, SIGGRAPH 2001, epsilon)

    double slow_warming_s = 400.0;  ///< time constant of milk that lies still
    double fast_warming_s = 0.5;    ///< the same of a ball
    double chill_share = 0.25;      ///< of the cold that milk loses, this much is given to the tea

    double first_ball_s = 3.4;
    double ball_interval_s = 0.55;  ///< in the mean
    double ball_radius_m = 0.0066;  ///< in the mean
    double ball_radius_spread = 0.3;
    int ball_candidates = 40;  ///< parcels the highest of which becomes a ball's middle

    double dissolving_s = 14.0;           ///< time constant of warm balls, and of all milk later
    double dissolving_on_top_s = 5.0;     ///< of balls that spread under the surface
    double top_depth_m = 0.014;           ///< how far down that is
    double dissolving_at_rest_s = 240.0;  ///< of milk that is no ball yet
    double rest_ends_s = 22.0;            ///< when all milk begins to dissolve
    double warm_below = 0.3;              ///< coldness of a ball that dissolves

    double swirl_rad_s2 = 0.0;    ///< the painter's force: an acceleration around an upright axis, per
                                  ///< metre from it
    double push_m_s2 = 0.0;       ///< the same, downwards
    double force_reach_m = 0.02;  ///< both fade as exp(-r^2 / (2 reach^2)) with the distance r from it
    double swirl_x_m = 0.05, swirl_y_m = 0.05;  ///< where that axis stands

    friend bool operator==(const TeaSettings&, const TeaSettings&) = default;
};

/// A number of the settings: its name in files, unit, usual range and what it is.
struct TeaNumber {
    const char* key;
    const char* unit;  ///< "" of a plain number
    double TeaSettings::*value;
    double least, most;
    const char* meaning;
};

/// All of them that are not whole numbers, in the order of the struct.
std::span<const TeaNumber> tea_numbers();

inline constexpr int kMinTeaCells = 8, kMaxTeaCells = 256;
inline constexpr int kMaxParcels = 1'000'000;

/// Throws InputError "NAME is VALUE, not between LEAST and MOST" for a number that is none or outside
/// its range, and when cup, milk and box do not fit into one another.
void check_tea(const TeaSettings& settings);

}  // namespace pastoso::liquid
