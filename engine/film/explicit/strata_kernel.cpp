// Compiled once per instruction set; see pastoso_add_kernels.
#include "film/explicit/pigment_stream.hpp"
#include "film/explicit/strata_transport.hpp"
#include "film/face/lane_groups.hpp"

namespace pastoso::film::PASTOSO_ISA {
namespace {

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
        if (!lanes::any(above > none)) return store(&upper.share[cell], none);
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
        if (!lanes::any(through != none)) return lanes::store(part_out + f, none);
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
        const Lanes along_x =
            (load_quanta(&scratch.flux_x[f - 1]) + load_quanta(&scratch.flux_x[f])) * 0.5F;
        const Lanes along_y =
            (load_quanta(&scratch.flux_y[f - kFaceStride]) + load_quanta(&scratch.flux_y[f])) * 0.5F;
        const auto moves = along_x != none || along_y != none;
        if (!lanes::any(moves && above > none)) return store(&upper.mixing[y * kTileSize + x], none);
        const Lanes whole = lanes::max(load_quanta(&scratch.block.quanta[cell]), Lanes(1.0F));
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
void mix(float m, std::int32_t above, std::int32_t below, const ChannelInts& whole, ChannelInts& lower) {
    const float h = static_cast<float>(above) + static_cast<float>(below);
    const Channels sinks(m * static_cast<float>(below) / h), rises(m * static_cast<float>(above) / h);
    for (int q = 0; q < kRegisters; ++q) {
        const IntChannels held = lower.registers[q], high = whole.registers[q] - held;
        const IntChannels gain = lanes::convert<std::int32_t>(lanes::convert<float>(high) * sinks -
                                                              lanes::convert<float>(held) * rises);
        lower.registers[q] = held + lanes::max(lanes::min(gain, high), -held);
    }
}

/// Notes the lower stratum of a cell that paint passes, if it has or had one; `gained` is what that, or
/// paint that was one, gained.
[[gnu::always_inline]] inline void note_lower(const StrataScratch& upper, const StrataPaint& paint,
                                              int x, int y, const ChannelInts& gained,
                                              const ChannelInts& whole, StrataMoved& moved) {
    const int cell = y * kTileSize + x;
    const std::int32_t above = upper_after(upper, x, y), below = paint.thickness[cell] - above;
    const bool was_two = upper.quanta[block_index(x, y)] != 0;
    const bool is_two = lanes::min(above, below) >= kLostStratum_quanta;
    if (!was_two && !is_two) return;
    LowerChange& change = paint.changes[moved.changes++];
    change = {cell, {}};
    if (!is_two) return;
    ChannelInts lower = ChannelInts::load(was_two ? paint.lower_before[cell] : paint.whole_before[cell]);
    lower += gained;
    const float m = upper.mixing[cell];
    if (m > 0.0F) mix(m, above, below, whole, lower);
    change.lower.thickness = below;
    lower.store(change.lower.paint);
}

template <bool kLargeFluxes, bool kIsCrowded>
StrataMoved transport(const TileScratch& scratch, const StrataScratch& upper, int columns, int rows,
                      const OpenEdges& runoff_edges, const StrataPaint& paint) {
    StrataMoved moved;
    const MovingPaint below{scratch.block.quanta, scratch.supply, scratch.flux_x, scratch.flux_y,
                            paint.lower_concentrations};
    const MovingPaint above{upper.quanta, upper.supply, upper.flux_x, upper.flux_y,
                            upper.concentrations.data()};
    using Stream = PaintStream<kLargeFluxes, kIsCrowded>;
    Stream lower{{below, paint.held, moved.pigment.held_back_faces}, runoff_edges, moved.pigment};
    Stream higher{{above, paint.held, moved.pigment.held_back_faces}, runoff_edges, moved.pigment};
    lower.enter_tile(columns);
    higher.enter_tile(columns);
    for (int y = 0; y < rows; ++y) {
        const bool last_row = y == rows - 1;
        ChannelInts lower_left = lower.enter_row(y), higher_left = higher.enter_row(y);
        for (int x = 0; x < columns; ++x) {
            const int cell = y * kTileSize + x;
            if (upper.passed[block_index(x, y)] == 0) {
                paint.whole[cell] = paint.whole_before[cell];
                lower_left = higher_left = {};
                continue;
            }
            const ChannelInts gained = lower.gain(x, y, last_row, lower_left);
            ChannelInts whole = ChannelInts::load(paint.whole_before[cell]);
            whole += gained;
            whole += higher.gain(x, y, last_row, higher_left);
            whole.store(paint.whole[cell]);
            note_lower(upper, paint, x, y, gained, whole, moved);
        }
        lower.leave_row(lower_left);
        higher.leave_row(higher_left);
    }
    return moved;
}

void mark_passed(const TileScratch& scratch, int columns, int rows, BlockArray<std::uint8_t>& passed) {
    passed.fill(0);
    for (int y = 0; y < rows; ++y) {
        const std::int32_t* flux = &scratch.flux_x[face_index(0, y)];
        for (int x = -1; x < columns; ++x) {
            const std::uint8_t through = flux[x] != 0 ? 1 : 0;
            passed[block_index(x, y)] |= through;
            passed[block_index(x + 1, y)] |= through;
        }
    }
    for (int y = -1; y < rows; ++y) {
        const std::int32_t* flux = &scratch.flux_y[face_index(0, y)];
        for (int x = 0; x < columns; ++x) {
            const std::uint8_t through = flux[x] != 0 ? 1 : 0;
            passed[block_index(x, y)] |= through;
            passed[block_index(x, y + 1)] |= through;
        }
    }
}

}  // namespace

void find_read_cells(const TileScratch& scratch, int columns, int rows, StrataScratch& strata) {
    mark_passed(scratch, columns, rows, strata.passed);
    for (int y = -kConcentrationHalo; y < rows + kConcentrationHalo; ++y) {
        const std::uint8_t* from = &strata.passed[block_index(0, y)];
        std::uint8_t* to = &strata.read[concentration_place(0, y)];
        for (int x = -kConcentrationHalo; x < columns + kConcentrationHalo; ++x)
            to[x] =
                from[x] | from[x - 1] | from[x + 1] | from[x - kBlockStride] | from[x + kBlockStride];
    }
}

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

StrataMoved transport_strata(const TileScratch& scratch, const StrataScratch& upper, int columns,
                             int rows, const OpenEdges& runoff_edges, const StrataPaint& paint) {
    const auto move = [&](auto transport_as) {
        return transport_as(scratch, upper, columns, rows, runoff_edges, paint);
    };
    if (paint.held != nullptr)
        return scratch.large_fluxes ? move(transport<true, true>) : move(transport<false, true>);
    return scratch.large_fluxes ? move(transport<true, false>) : move(transport<false, false>);
}

}  // namespace pastoso::film::PASTOSO_ISA
