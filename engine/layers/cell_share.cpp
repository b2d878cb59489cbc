#include "layers/cell_share.hpp"

#include "film/cell/cell_drying.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::layers {
namespace {

using film::FilmState;
using film::kQuantaPerSupport;

/// How amounts are divided: `part` of `whole`, rounded down, is the share.
struct Division {
    std::int32_t part, whole;
    bool rest;

    std::int32_t part_of(std::int32_t amount) const {
        return static_cast<std::int32_t>(std::int64_t{amount} * part / std::max(whole, 1));
    }
    std::int32_t of(std::int32_t amount) const {
        return rest ? amount - part_of(amount) : part_of(amount);
    }
    /// Rounded down in the rest, too: together they are less by a quantum at most.
    std::int32_t at_most(std::int32_t amount) const {
        return rest ? Division{whole - part, whole, false}.part_of(amount) : part_of(amount);
    }
};

template <class Amounts>
void divide(const Division& division, Amounts& amounts) {
    for (auto& amount : amounts)
        amount = division.of(amount);
}

/// A share of a lower stratum may come to nothing or to all of the cell.
void keep_lower(const Division& division, int tile, int cell, FilmState& layer) {
    if (!layer.lower.is_in(tile)) return;
    film::LowerCell lower{division.of(layer.lower.thickness.read(tile)[cell]),
                          layer.lower.paint.read(tile)[cell]};
    divide(division, lower.paint);
    const bool is_one =
        lower.thickness == 0 ||
        !film::is_part_of(lower, layer.thickness.read(tile)[cell], layer.paint.read(tile)[cell]);
    if (is_one) lower = {};
    layer.lower.thickness.write(tile)[cell] = lower.thickness;
    layer.lower.paint.write(tile)[cell] = lower.paint;
}

void keep_wet(int tile, int cell, const CellShare& kept, FilmState& layer) {
    const std::int32_t whole = layer.thickness.read(tile)[cell];
    if (whole == 0) return;
    const Division division{grid::share_of(whole, kept.share), whole, kept.rest};
    layer.thickness.write(tile)[cell] = division.of(whole);
    divide(division, layer.paint.write(tile)[cell]);
    keep_lower(division, tile, cell, layer);
    if (!layer.worked.thickness.is_background(tile)) {
        std::int32_t& worked = layer.worked.thickness.write(tile)[cell];
        worked = division.of(worked);
    }
    if (!layer.media.is_mixed(tile)) return;
    for (std::int32_t& amount : layer.media.foreign.write(tile)[cell])
        amount = division.at_most(amount);
}

/// Returns the steps of the support that are kept of it.
std::int64_t keep_soluble(int tile, int cell, const CellShare& kept, film::Strata& strata) {
    if (strata.soluble_thickness.is_background(tile)) return 0;
    std::int32_t& thickness = strata.soluble_thickness.write(tile)[cell];
    const std::int32_t steps = grid::share_of(thickness, kept.share) / kQuantaPerSupport;
    const Division division{steps * kQuantaPerSupport, thickness, kept.rest};
    divide(division, strata.soluble_pigment.write(tile)[cell]);
    thickness = division.of(thickness);
    return steps;
}

void keep_relief(int tile, int cell, const CellShare& kept, FilmState& layer) {
    const auto relief = std::llround(layer.support_mm.read(tile)[cell] / film::kSupportQuantum_mm);
    const std::int64_t fixed = std::max<std::int64_t>(
        0, relief * kQuantaPerSupport - layer.strata.soluble_thickness.read(tile)[cell]);
    const std::int64_t share = fixed * kept.share / grid::kWhole / kQuantaPerSupport +
                               keep_soluble(tile, cell, kept, layer.strata);
    if (relief == 0) return;
    layer.support_mm.write(tile)[cell] = static_cast<float>(
        static_cast<double>(kept.rest ? relief - share : share) * film::kSupportQuantum_mm);
}

void keep_optics(int tile, int cell, const CellShare& kept, film::Strata& strata) {
    if (strata.optics.is_background(tile)) return;
    film::StrataOptics& optics = strata.optics.write(tile)[cell];
    if (optics == film::kClearStrata) return;
    const auto share = static_cast<std::uint8_t>(kept.rest ? grid::kWhole - kept.share : kept.share);
    optics = film::faded(optics, grid::fraction_of(share));
    if (optics == film::kClearStrata) strata.uppermost.write(tile)[cell] = {};
}

}  // namespace

void keep_share(int tile, int cell, const CellShare& kept, FilmState& layer) {
    keep_wet(tile, cell, kept, layer);
    keep_relief(tile, cell, kept, layer);
    keep_optics(tile, cell, kept, layer.strata);
}

}  // namespace pastoso::layers
