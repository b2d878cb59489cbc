// Compiled once per instruction set; see pastoso_add_kernels.
#include "film/explicit/strata_transport.hpp"
#include "film/explicit/tile_kernels.hpp"
#include "film/face/lane_groups.hpp"

namespace pastoso::film::PASTOSO_ISA {
namespace {

using grid::kTileSize;
using LaneInts = lanes::As<std::int32_t, Lanes>;

/// More than enough for whatever leaves a stratum.
constexpr float kAmpleSupply = 4.0F;

LaneInts load_ints(const std::int32_t* values) {
    return lanes::load<LaneInts>(values);
}
Lanes load_quanta(const std::int32_t* values) {
    return lanes::convert<float>(load_ints(values));
}

/// h_u / h.
Lanes upper_share(Lanes above, Lanes whole) {
    return above / lanes::max(whole, Lanes(1.0F));
}

/// phi(s).
Lanes carried(const FilmProfile& profile, Lanes share) {
    const Lanes below = 1.0F - share;
    return 1.0F - below * below * (share + profile.width) * (1.0F / profile.width);
}

Lanes ratio(Lanes held, Lanes leaving) {
    return lanes::select(leaving > Lanes(0.0F), held / lanes::max(leaving, Lanes(1e-30F)),
                         Lanes(kAmpleSupply));
}

/// The share of what leaves a cell that the upper stratum carries, and what each then holds over it.
void share_row(const FilmProfile& profile, int y, TileScratch& scratch, StrataScratch& upper) {
    const Lanes none(0.0F), one(1.0F);
    for_each_lane_group(-1, kTileSize + 1, [&](int x) {
        const int cell = block_index(x, y);
        const Lanes above = load_quanta(&upper.quanta[cell]);
        const Lanes share = upper_share(above, load_quanta(&scratch.block.quanta[cell]));
        Lanes part = carried(profile, share);
        if (scratch.large_fluxes) {
            const Lanes supply = load(&scratch.supply[cell]);
            part = lanes::max(part, one - (one - share) * supply);
            part = lanes::min(part, lanes::min(share * supply, one));
            store(&upper.supply[cell], ratio(share * supply, part));
        }
        store(&upper.share[cell], lanes::select(above > none, part, none));
    });
}

/// Apart from share_row(), whose groups overlap.
void lower_supply_row(int y, TileScratch& scratch, const StrataScratch& upper) {
    for (int x = -1; x <= kTileSize; ++x) {
        const int cell = block_index(x, y);
        if (upper.quanta[cell] == 0) continue;
        const float share = static_cast<float>(upper.quanta[cell]) /
                            static_cast<float>(lanes::max(scratch.block.quanta[cell], 1));
        const float leaving = 1.0F - upper.share[cell];
        scratch.supply[cell] =
            leaving > 0.0F ? (1.0F - share) * scratch.supply[cell] / leaving : kAmpleSupply;
    }
}

/// The upper strata's parts of the fluxes through the faces that look `along` further in the block.
void split_row(int along, int first_x, int y, const TileScratch& scratch, const StrataScratch& upper,
               const std::int32_t* flux, std::int32_t* part_out) {
    const LaneInts none(0);
    for_each_lane_group(first_x, kTileSize, [&](int x) {
        const int f = face_index(x, y), cell = block_index(x, y);
        const LaneInts through = load_ints(flux + f);
        const auto forward = through > none;
        const LaneInts amount = lanes::select(forward, through, -through);
        const auto donor = [&](const auto* values, auto load_from) {
            return lanes::select(forward, load_from(values + cell), load_from(values + cell + along));
        };
        const LaneInts above = donor(upper.quanta.data(), load_ints);
        const Lanes share = lanes::select(forward, load(&upper.share[cell]), load(&upper.share[cell + along]));
        LaneInts part = lanes::convert<std::int32_t>(share * lanes::convert<float>(amount));
        if (!scratch.large_fluxes) {
            const LaneInts below = donor(scratch.block.quanta.data(), load_ints) - above;
            part = lanes::min(lanes::max(part, LaneInts(amount - (below >> 2))), LaneInts(above >> 2));
        }
        part = lanes::select(above > none, lanes::max(lanes::min(part, amount), none), none);
        lanes::store(part_out + f, lanes::select(forward, part, -part));
    });
}

void take_off(const std::int32_t* part, int count, std::int32_t* whole) {
    for (int i = 0; i < count; ++i)
        whole[i] -= part[i];
}

/// gamma / (gamma + kMixingStrain), from the fluxes of the whole.
void mixing_row(const FilmProfile& profile, float cell_quanta, int y, const TileScratch& scratch,
                StrataScratch& upper) {
    const Lanes none(0.0F);
    for_each_lane_group(0, kTileSize, [&](int x) {
        const int f = face_index(x, y), cell = block_index(x, y);
        const Lanes above = load_quanta(&upper.quanta[cell]);
        const Lanes whole = lanes::max(load_quanta(&scratch.block.quanta[cell]), Lanes(1.0F));
        const Lanes along_x =
            (load_quanta(&scratch.flux_x[f - 1]) + load_quanta(&scratch.flux_x[f])) * 0.5F;
        const Lanes along_y =
            (load_quanta(&scratch.flux_y[f - kFaceStride]) + load_quanta(&scratch.flux_y[f])) * 0.5F;
        const Lanes cells_passed = lanes::sqrt(along_x * along_x + along_y * along_y) / whole;
        const Lanes shear =
            (upper_share(above, whole) + (profile.alpha - 1.0F)) * (6.0F / profile.width);
        const Lanes strain = cells_passed * cell_quanta / whole * lanes::max(shear, none);
        store(&upper.mixing[y * kTileSize + x],
              lanes::select(above > none, strain / (strain + kMixingStrain), none));
    });
}

std::int32_t upper_after(const StrataScratch& upper, int x, int y) {
    const int f = face_index(x, y);
    return upper.quanta[block_index(x, y)] + (upper.flux_x[f - 1] - upper.flux_x[f]) +
           (upper.flux_y[f - kFaceStride] - upper.flux_y[f]);
}

/// Lets the strata of a cell mix by the share m of what can.
void mix(float m, std::int32_t above, std::int32_t below, const PaintCell& whole, PaintCell& lower) {
    const float h = static_cast<float>(above) + static_cast<float>(below);
    const Lanes sinks(m * static_cast<float>(below) / h), rises(m * static_cast<float>(above) / h);
    for (int k = 0; k < kPaintChannels; k += kLanes) {
        const LaneInts held = load_ints(lower.data() + k), high = load_ints(whole.data() + k) - held;
        const LaneInts gain = lanes::convert<std::int32_t>(lanes::convert<float>(high) * sinks -
                                                           lanes::convert<float>(held) * rises);
        lanes::store(lower.data() + k, held + lanes::max(lanes::min(gain, high), -held));
    }
}

void add(const PaintCell& more, PaintCell& sum) {
    for (int k = 0; k < kPaintChannels; k += kLanes)
        lanes::store(sum.data() + k, load_ints(sum.data() + k) + load_ints(more.data() + k));
}

void add_change(const PaintCell& before, const PaintCell& after, PaintCell& whole) {
    for (int k = 0; k < kPaintChannels; k += kLanes)
        lanes::store(whole.data() + k, load_ints(whole.data() + k) + (load_ints(after.data() + k) -
                                                                      load_ints(before.data() + k)));
}

}  // namespace

void split_strata(const FilmProfile& profile, float cell_quanta, TileScratch& scratch,
                  StrataScratch& upper) {
    for (int y = -1; y <= kTileSize; ++y)
        share_row(profile, y, scratch, upper);
    for (int y = -1; y < kTileSize; ++y) {
        if (y >= 0) mixing_row(profile, cell_quanta, y, scratch, upper);
        if (y >= 0)
            split_row(1, -1, y, scratch, upper, scratch.flux_x.data(), upper.flux_x.data());
        split_row(kBlockStride, 0, y, scratch, upper, scratch.flux_y.data(), upper.flux_y.data());
    }
    if (scratch.large_fluxes)
        for (int y = -1; y <= kTileSize; ++y)
            lower_supply_row(y, scratch, upper);
    take_off(upper.flux_x.data(), kFaceCount, scratch.flux_x.data());
    take_off(upper.flux_y.data(), kFaceCount, scratch.flux_y.data());
    take_off(upper.quanta.data(), kBlockCells, scratch.block.quanta.data());
}

void join_strata(const StrataScratch& upper, int columns, int rows, const StrataMoved& moved) {
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const int cell = y * kTileSize + x;
            const std::int32_t above = upper_after(upper, x, y), below = moved.thickness[cell] - above;
            add_change(moved.lower_before[cell], moved.lower[cell], moved.whole[cell]);
            if (lanes::min(above, below) < kLostStratum_quanta) {
                moved.lower[cell] = {};
                moved.lower_thickness[cell] = 0;
                continue;
            }
            const bool was_one = upper.quanta[block_index(x, y)] == 0;
            if (was_one) add(moved.whole_before[cell], moved.lower[cell]);
            moved.lower_thickness[cell] = below;
            const float m = upper.mixing[cell];
            if (m > 0.0F) mix(m, above, below, moved.whole[cell], moved.lower[cell]);
        }
}

}  // namespace pastoso::film::PASTOSO_ISA
