#include "document/well.hpp"

#include "brush/cell_batch.hpp"
#include "brush/spill.hpp"
#include "core/random.hpp"
#include "core/units.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pastoso::document {
namespace {

/// A dollop is a short bent strand that thins out, of beads that melt into one. Lengths are in radii a
/// of its size, V = pi / 2 s a^3 with the steepness s: low enough that oil stands so at once.
constexpr double kSteepness = 0.1;
constexpr double kLength = 1.2, kBend_rad = 1.1;
constexpr double kFirstBead = 0.56, kLastBead = 0.36;
constexpr int kBeads = 48;

double size_mm_of(double volume_mm3) {
    return std::cbrt(2.0 * volume_mm3 / (core::kPi * kSteepness));
}

struct Bead {
    double x, y, radius;
};

/// `along` the strand from 0 to 1, about its middle and downwards.
Bead bead_at(double along) {
    const double angle = kBend_rad * (along - 0.5), bend_radius = kLength / kBend_rad;
    const double depth = bend_radius * (1.0 - std::cos(0.5 * kBend_rad));
    return {bend_radius * (std::cos(angle) - 1.0) + 0.5 * depth,
            bend_radius * std::sin(angle) + 0.5 * (kFirstBead - kLastBead),
            kFirstBead + (kLastBead - kFirstBead) * along};
}

/// The nearest place to `at` where a dollop of this size lies between 0 and `side`.
double kept_within(double at_mm, double size_mm, double side_mm) {
    return std::clamp(at_mm, size_mm, side_mm - size_mm);
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

brush::Contents squeeze_onto(film::FilmState& well, film::Solver& solver, const film::Medium& medium,
                             const film::PaintCoefficients& paint, double volume_mm3, double x_mm,
                             double y_mm) {
    const double size_mm = size_mm_of(volume_mm3);
    x_mm = kept_within(x_mm, size_mm, kWellWidth_mm);
    y_mm = kept_within(y_mm, size_mm, kWellHeight_mm);
    // put_down() never empties what it takes from, so that the tube holds more than it gives.
    const brush::Contents before = amount_of(paint, 2.0 * volume_mm3);
    brush::Contents tube = before;
    well.consistencies.add(film::consistency_of(paint));
    brush::MediaExchange media;
    media.given[film::add_medium(well, film::film_numbers_of(medium))] = 1.0F;
    const bool several = well.media.are_several();
    brush::CellBatch scratch;
    for (int i = 0; i < kBeads; ++i) {
        const double along = (i + 0.5) / kBeads;
        const Bead bead = bead_at(along);
        const grid::Rect cells =
            brush::put_down(tube, volume_mm3 / kBeads, x_mm + bead.x * size_mm, y_mm + bead.y * size_mm,
                            bead.radius * size_mm, core::scramble(static_cast<std::uint32_t>(i)), well,
                            scratch, several ? &media : nullptr);
        solver.wake(cells);
    }
    brush::Contents squeezed = before;
    squeezed -= tube;
    return squeezed;
}

}  // namespace pastoso::document
