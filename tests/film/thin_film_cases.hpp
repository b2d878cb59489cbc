// The set-ups of the recorded results, each run until the times that the tables name.
#pragma once

#include "film/film_bench.hpp"

#include <vector>

namespace pastoso::film::test {

/// A ripple of 5 % on a film of thickness 1, nu = 10; runs for one decay time and returns the rate.
double ripple_decay_rate(double gravity, double tension, int cells_per_wave);

struct SlopeCurrent {
    double front = 0;     ///< where the profile falls to half its peak
    double l1_error = 0;  ///< against Huppert's profile, relative to its area
};
/// Huppert's current of area 20 under F = nu = 30, from its similarity profile at t = 5.
std::vector<SlopeCurrent> slope_current(double cell, const std::vector<double>& times);

struct SpreadDrop {
    double seconds = 0;  ///< when it was looked at
    double radius = 0;   ///< of the disc as large as what is thicker than 2 % of the middle
    double height = 0;
};
/// Huppert's axisymmetric current of volume 1500 under g = 10, from its similarity profile at t = 1.
std::vector<SpreadDrop> axisymmetric_current(double cell, const std::vector<double>& times);

struct Drip {
    double tip = -1e9, half_width = 0, centroid = 0;  ///< along and across the way down
};
/// A paraboloid drop, 4 high and 14 in radius, after 80 s of F = 0.6 in a direction.
Drip drip(double angle_deg, double alpha_min, double alpha_max, const SolverOptions& options = {});

struct Cap {
    double radius = 0, height = 0;
};
/// A drop without gravity that has come to rest with the contact slope at its edge, from one of the same
/// volume and radius 7; its exact radius is 10.
Cap sessile_cap(double cell, double slope, bool full_curvature, double exact_height, double seconds);

/// Mean velocity that a film ends with.
double terminal_velocity(const Scene& scene, double thickness, double dt_s, double seconds);

/// Middle height of a yield-stress slump on a flat plane.
double arrested_height(double cell);

/// Mean thickness over 30 < x < 60 of what a yield-stress current leaves on a slope after 1500 s.
double slope_deposit(double cell);

/// Levelling waves under gravity, tension and tilt after 12 s, in `n` cells over a length of 64.
std::vector<double> levelled_waves(int n);

}  // namespace pastoso::film::test
