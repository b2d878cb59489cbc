#include "session/far_level.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::session {
namespace {

/// A step along an axis is at least this much of the way to any point beyond.
constexpr float kStep = 0.577F;
constexpr float kKnown_cells = 0.3F;

/// Each sample takes from the one before it on each axis what a step from there would give it.
void carry(liquid::SampledField& far_m, bool forwards) {
    const liquid::Lattice& lattice = far_m.lattice();
    const float step_m = kStep * lattice.spacing_m;
    const int by = forwards ? -1 : 1;
    const auto at = [forwards](int n, int count) { return forwards ? n : count - 1 - n; };
    const auto inside = [](int n, int count) { return n >= 0 && n < count; };
    for (int c = 0; c < lattice.nz; ++c)
        for (int b = 0; b < lattice.ny; ++b) {
            const int k = at(c, lattice.nz), j = at(b, lattice.ny);
            float* row = far_m.row(j, k);
            const float* left = inside(j + by, lattice.ny) ? far_m.row(j + by, k) : row;
            const float* under = inside(k + by, lattice.nz) ? far_m.row(j, k + by) : row;
            for (int i = 0; i < lattice.nx; ++i)
                row[i] = std::min({row[i], left[i] + step_m, under[i] + step_m});
            for (int a = 1; a < lattice.nx; ++a) {
                const int i = at(a, lattice.nx);
                row[i] = std::min(row[i], row[i + by] + step_m);
            }
        }
}

}  // namespace

liquid::SampledField far_level(const liquid::SampledField& level_m) {
    const liquid::Lattice& lattice = level_m.lattice();
    const float farthest_m =
        lattice.spacing_m * static_cast<float>(std::max({lattice.nx, lattice.ny, lattice.nz}));
    const float known_m = kKnown_cells * lattice.spacing_m;
    liquid::SampledField far_m(lattice, farthest_m);
    const auto crosses = [&](int i, int j, int k) {
        const bool in = level_m.at(i, j, k) < 0.0F;
        return (i > 0 && (level_m.at(i - 1, j, k) < 0.0F) != in) ||
               (j > 0 && (level_m.at(i, j - 1, k) < 0.0F) != in) ||
               (k > 0 && (level_m.at(i, j, k - 1) < 0.0F) != in) ||
               (i + 1 < lattice.nx && (level_m.at(i + 1, j, k) < 0.0F) != in) ||
               (j + 1 < lattice.ny && (level_m.at(i, j + 1, k) < 0.0F) != in) ||
               (k + 1 < lattice.nz && (level_m.at(i, j, k + 1) < 0.0F) != in);
    };
    for (int k = 0; k < lattice.nz; ++k)
        for (int j = 0; j < lattice.ny; ++j)
            for (int i = 0; i < lattice.nx; ++i) {
                const float size_m = std::abs(level_m.at(i, j, k));
                if (size_m < known_m || crosses(i, j, k)) far_m.at(i, j, k) = size_m;
            }
    carry(far_m, true);
    carry(far_m, false);
    for (int k = 0; k < lattice.nz; ++k)
        for (int j = 0; j < lattice.ny; ++j)
            for (int i = 0; i < lattice.nx; ++i)
                if (level_m.at(i, j, k) < 0.0F) far_m.at(i, j, k) = -far_m.at(i, j, k);
    return far_m;
}

}  // namespace pastoso::session
