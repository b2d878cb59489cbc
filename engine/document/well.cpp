#include "document/well.hpp"

#include "brush/cell_batch.hpp"
#include "brush/spill.hpp"
#include "core/elementary.hpp"
#include "core/random.hpp"
#include "core/units.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::document {
namespace {

/// Height over radius of a whole heap of paint.
constexpr double kSteepness = 0.4;

/// The coil is laid in so many touching beads, winds so often, and starts this far out; a bead is this
/// wide. Lengths in radii of the whole heap.
constexpr int kBeads = 60;
constexpr double kTurns = 2.25;
constexpr double kCoilRadius = 0.62, kBeadRadius = 0.34;

constexpr film::SolverOptions kRim = {.edge_x = film::Edge::Wall, .edge_y = film::Edge::Wall};

double heap_radius_mm(double volume_mm3) {
    return std::cbrt(2.0 * volume_mm3 / (core::kPi * kSteepness));
}

/// The nearest place to `at` where a heap of this radius lies between 0 and `side`.
double kept_within(double at_mm, double radius_mm, double side_mm) {
    return std::clamp(at_mm, radius_mm, side_mm - radius_mm);
}

brush::Contents amount_of(const film::PaintCoefficients& paint, double volume_mm3) {
    brush::Contents amount{.volume_mm3 = volume_mm3};
    for (int k = 0; k < film::kPaintChannels; ++k)
        amount.paint[k] = volume_mm3 * static_cast<double>(paint[k]);
    return amount;
}

}  // namespace

film::FilmState bare_well() {
    const grid::Shape shape{static_cast<int>(kWellWidth_mm * kWellPxPerMm),
                            static_cast<int>(kWellHeight_mm * kWellPxPerMm)};
    return film::FilmState(shape, 1.0 / kWellPxPerMm);
}

Well::Well(const film::Medium& medium, core::ThreadPool& pool)
    : film(bare_well()), solver(film, medium, kRim, pool) {
    solver.set_gravity(film::tilted_gravity(0.0));
}

brush::Contents squeeze_onto(Well& well, const film::PaintCoefficients& paint, double volume_mm3,
                             double x_mm, double y_mm) {
    const double radius_mm = heap_radius_mm(volume_mm3);
    x_mm = kept_within(x_mm, radius_mm, kWellWidth_mm);
    y_mm = kept_within(y_mm, radius_mm, kWellHeight_mm);
    // put_down() never empties what it takes from, so that the tube holds more than it gives.
    const brush::Contents before = amount_of(paint, 2.0 * volume_mm3);
    brush::Contents tube = before;
    brush::CellBatch scratch;
    for (int bead = 0; bead < kBeads; ++bead) {
        const double along = (bead + 0.5) / kBeads;
        const double out_mm = kCoilRadius * radius_mm * std::sqrt(1.0 - along);
        const double angle = 2.0 * core::kPi * kTurns * along;
        const grid::Rect cells =
            brush::put_down(tube, volume_mm3 / kBeads, x_mm + out_mm * std::cos(angle),
                            y_mm + out_mm * std::sin(angle), kBeadRadius * radius_mm,
                            core::scramble(static_cast<std::uint32_t>(bead)), well.film, scratch);
        well.solver.wake(cells);
    }
    brush::Contents squeezed = before;
    squeezed -= tube;
    return squeezed;
}

}  // namespace pastoso::document
