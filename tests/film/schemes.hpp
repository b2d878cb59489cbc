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
};

/// In place of its bytes, where a test fails.
inline void PrintTo(const Scheme& scheme, std::ostream* stream) {
    *stream << scheme.name;
}

inline std::vector<Scheme> all_schemes() {
    return {{.name = "Explicit", .options = {}}};
}

}  // namespace pastoso::film::test
