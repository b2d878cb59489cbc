// The ways to step in time that every law is tested with. A further scheme is one more entry here.
#pragma once

#include "film/solver.hpp"

#include <ostream>
#include <string>
#include <vector>

namespace pastoso::film::test {

/// Which surface heights the energy of a scheme pairs (film_energy.hpp).
enum class EnergyLevels {
    Same,       ///< both of the new time: for schemes that damp every wave by themselves
    Staggered,  ///< the new and the old one: velocities lie half a step between heights
};

struct Scheme {
    std::string name;  ///< letters only: it becomes part of test names
    SolverOptions options;
    double step_in_limits = 0.7;  ///< length of a step, in explicit stability limits
    EnergyLevels energy_levels = EnergyLevels::Staggered;
    /// What a step may gain of the first energy in films thinner than this, mm2/s.
    double thin_energy_gain = 0.0, thin_viscosity_mm2_s = 0.0;
    int random_paints = 60, random_steps = 150;  ///< of the default run, for each kind of edge
    /// Mean difference between a turned film and the film of the turned canvas, over the mean thickness.
    double turning_error = 0.0;
    int turning_steps = 80;
};

/// In place of its bytes, where a test fails.
inline void PrintTo(const Scheme& scheme, std::ostream* stream) {
    *stream << scheme.name;
}

inline std::vector<Scheme> all_schemes() {
    SolverOptions explicit_steps, large_steps;
    explicit_steps.scheme = film::Scheme::Explicit;
    large_steps.scheme = film::Scheme::LargeStep;
    return {{.name = "Explicit", .options = explicit_steps},
            {.name = "LargeStep",
             .options = large_steps,
             .step_in_limits = 50.0,
             .energy_levels = EnergyLevels::Same,
             // Its equations are met to half a thousandth of a cell's thickness and the drag of a yield
             // stress to half a percent: 5.5e-9 is what a film that runs on by inertia has been seen to
             // gain.
             .thin_energy_gain = 2e-8,
             .thin_viscosity_mm2_s = 3.0,
             .random_steps = 30,
             // Its equations are met to a hundredth of a cell's thickness, in checkerboard order, and
             // the alpha range makes much of little (0.2 % without it).
             .turning_error = 2e-2,
             .turning_steps = 12}};
}

}  // namespace pastoso::film::test
