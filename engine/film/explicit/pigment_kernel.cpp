// Compiled once per instruction set; see pastoso_add_kernels.
#include "core/lane_memory.hpp"
#include "film/explicit/tile_kernels.hpp"

namespace pastoso::film::PASTOSO_ISA {
namespace {

namespace lanes = core::lanes;
using grid::kTileSize;

/// A cell fills whole registers of every instruction set: four, two or one.
using Channels = lanes::Widest<float>;
using IntChannels = lanes::As<std::int32_t, Channels>;
constexpr int kWidth = Channels::kLanes;
constexpr int kRegisters = kPaintChannels / kWidth;
static_assert(kRegisters * kWidth == kPaintChannels);

struct ChannelInts {
    std::array<IntChannels, kRegisters> registers;

    [[gnu::always_inline]] static ChannelInts load(const PaintCell& cell) {
        ChannelInts result;
        for (int q = 0; q < kRegisters; ++q)
            result.registers[q] = lanes::load<IntChannels>(cell.data() + kWidth * q);
        return result;
    }
    [[gnu::always_inline]] void store(PaintCell& cell) const {
        for (int q = 0; q < kRegisters; ++q)
            lanes::store(cell.data() + kWidth * q, registers[q]);
    }
    [[gnu::always_inline]] ChannelInts operator-() const {
        ChannelInts result;
        for (int q = 0; q < kRegisters; ++q)
            result.registers[q] = -registers[q];
        return result;
    }
};

[[gnu::always_inline]] inline Channels load_channels(const float* values) {
    return lanes::load<Channels>(values);
}

/// The slope of the concentration at the donor cell: the smaller of both sides' where they agree in
/// sign.
[[gnu::always_inline]] inline Channels minmod(Channels a, Channels b) {
    const Channels zero(0.0F);
    return lanes::max(lanes::min(a, b), zero) + lanes::min(lanes::max(a, b), zero);
}

/// Thinner than this (0.03 um), a concentration says nothing.
constexpr std::int32_t kNegligible_quanta = 1 << 10;

/// Reads the fluxes and concentrations of a tile and says what pigment passes a face.
template <bool kLargeFluxes, bool kIsCrowded>
struct PigmentFluxes {
    const TileScratch& scratch;
    const float* concentrations;
    const PaintCell* held;
    int& held_back_faces;

    /// The signed pigment that `flux` thickness quanta take with them from the cell before the face to
    /// the one behind it. `block_step` and `concentration_step` lead from one to the other. With the
    /// flux at most a quarter of its cell and |slope| <= concentration, the four outflows f/4 (1 + (1 -
    /// f)/2), f = 4 flux / cell, never exceed what the cell holds. A large step may take more: then the
    /// slope counts only where half the cell stays, and a cell that gives more than it holds gives its
    /// own pigment in equal parts to all of it.
    [[gnu::always_inline]] ChannelInts through(std::int32_t flux, int cell, int concentration,
                                               int block_step, int concentration_step) const {
        if (flux == 0) return {};
        const bool forward = flux > 0;
        const int downwind_step = forward ? block_step : -block_step;
        const int to_downwind = forward ? concentration_step : -concentration_step;
        const std::int32_t* quanta = &scratch.block.quanta[forward ? cell : cell + block_step];
        const float* donor =
            concentrations + (forward ? concentration : concentration + concentration_step);
        const float amount = static_cast<float>(forward ? flux : -flux);
        const bool smooth =
            quanta[downwind_step] > kNegligible_quanta && quanta[-downwind_step] > kNegligible_quanta;
        float reach = 0.5F - 2.0F * amount / static_cast<float>(*quanta);
        float own = amount;
        if constexpr (kLargeFluxes) {
            const float supply = scratch.supply[quanta - scratch.block.quanta.data()];
            reach = supply >= 2.0F ? 0.5F - 0.5F * amount / static_cast<float>(*quanta) : 0.0F;
            own = amount * lanes::min(supply, 1.0F);
        }
        if (!smooth) reach = 0.0F;
        ChannelInts carried;
        for (int q = 0; q < kRegisters; ++q) {
            const Channels here = load_channels(donor + kWidth * q);
            const Channels slope = minmod(here - load_channels(donor + kWidth * q - to_downwind),
                                          load_channels(donor + kWidth * q + to_downwind) - here);
            const Channels exact = Channels(own) * (here + Channels(reach) * slope) + Channels(0.5F);
            const IntChannels rounded = lanes::convert<std::int32_t>(exact);
            carried.registers[q] = forward ? rounded : -rounded;
        }
        return carried;
    }
    [[gnu::always_inline]] ChannelInts through_x(int x, int y) const {
        const ChannelInts wanted = through(scratch.flux_x[face_index(x, y)], block_index(x, y),
                                           concentration_index(x, y), 1, kPaintChannels);
        return kIsCrowded ? fitting(wanted, held[held_index(x, y)], held[held_index(x + 1, y)]) : wanted;
    }
    [[gnu::always_inline]] ChannelInts through_y(int x, int y) const {
        const ChannelInts wanted =
            through(scratch.flux_y[face_index(x, y)], block_index(x, y), concentration_index(x, y),
                    kBlockStride, kPaintChannels * kConcentrationSide);
        return kIsCrowded ? fitting(wanted, held[held_index(x, y)], held[held_index(x, y + 1)]) : wanted;
    }

    /// At most a quarter of what the cell that it enters can still count.
    ChannelInts fitting(const ChannelInts& wanted, const PaintCell& before,
                        const PaintCell& behind) const {
        const IntChannels most(std::numeric_limits<std::int32_t>::max());
        const ChannelInts low = ChannelInts::load(before), high = ChannelInts::load(behind);
        ChannelInts result;
        bool all_pass = true;
        for (int q = 0; q < kRegisters; ++q) {
            const IntChannels forwards = IntChannels(most - high.registers[q]) >> 2;
            const IntChannels backwards = -IntChannels(IntChannels(most - low.registers[q]) >> 2);
            result.registers[q] = lanes::max(lanes::min(wanted.registers[q], forwards), backwards);
            all_pass = all_pass && lanes::all(result.registers[q] == wanted.registers[q]);
        }
        held_back_faces += all_pass ? 0 : 1;
        return result;
    }
};

/// Whether anything passes one of a cell's faces.
[[gnu::always_inline]] inline bool is_passed(const TileScratch& scratch, int x, int y) {
    const int f = face_index(x, y);
    return (scratch.flux_x[f - 1] | scratch.flux_x[f] | scratch.flux_y[f - kFaceStride] |
            scratch.flux_y[f]) != 0;
}

void add_runoff(const ChannelInts& outward, PigmentMoved& moved) {
    for (int k = 0; k < kPaintChannels; ++k)
        moved.runoff[k] += outward.registers[k / kWidth][k % kWidth];
}

template <bool kLargeFluxes, bool kIsCrowded>
PigmentMoved transport(const TileScratch& scratch, const float* concentrations, const PaintCell* held,
                       int columns, int rows, const OpenEdges& runoff_edges, const PaintCell* before,
                       PaintCell* after) {
    PigmentMoved moved;
    const PigmentFluxes<kLargeFluxes, kIsCrowded> fluxes{scratch, concentrations, held,
                                                         moved.held_back_faces};
    std::array<PaintCell, kTileSize> from_above;
    for (int x = 0; x < columns; ++x) {
        const ChannelInts top = fluxes.through_y(x, -1);
        if (runoff_edges.top) add_runoff(-top, moved);
        top.store(from_above[x]);
    }
    for (int y = 0; y < rows; ++y) {
        ChannelInts left = fluxes.through_x(-1, y);
        if (runoff_edges.left) add_runoff(-left, moved);
        for (int x = 0; x < columns; ++x) {
            const int cell = y * kTileSize + x;
            if (!is_passed(scratch, x, y)) {
                after[cell] = before[cell];
                from_above[x] = {};
                left = {};
                continue;
            }
            const ChannelInts right = fluxes.through_x(x, y);
            const ChannelInts below = fluxes.through_y(x, y);
            const ChannelInts above = ChannelInts::load(from_above[x]);
            ChannelInts now = ChannelInts::load(before[cell]);
            for (int q = 0; q < kRegisters; ++q)
                now.registers[q] +=
                    (left.registers[q] - right.registers[q]) + (above.registers[q] - below.registers[q]);
            now.store(after[cell]);
            below.store(from_above[x]);
            left = right;
            if (runoff_edges.bottom && y == rows - 1) add_runoff(below, moved);
        }
        if (runoff_edges.right) add_runoff(left, moved);
    }
    return moved;
}

}  // namespace

PigmentMoved transport_pigment(const TileScratch& scratch, const float* concentrations,
                               const PaintCell* held, int columns, int rows,
                               const OpenEdges& runoff_edges, const PaintCell* before,
                               PaintCell* after) {
    const auto move = [&](auto transport_as) {
        return transport_as(scratch, concentrations, held, columns, rows, runoff_edges, before, after);
    };
    if (held != nullptr)
        return scratch.large_fluxes ? move(transport<true, true>) : move(transport<false, true>);
    return scratch.large_fluxes ? move(transport<true, false>) : move(transport<false, false>);
}

namespace {

/// Two quanta and one part in a million stay behind: the four roundings of a cell's outflows and the
/// rounding of the product then never take more than it holds.
[[gnu::always_inline]] inline void concentrate_cell(const ChannelInts& held, std::int32_t thickness,
                                                    float* out, IntChannels& largest) {
    constexpr float kShare = 1.0F - 0x1p-20F;
    const float inverse = thickness > 0 ? kShare / static_cast<float>(thickness) : 0.0F;
    for (int q = 0; q < kRegisters; ++q) {
        const IntChannels movable =
            lanes::max(IntChannels(held.registers[q] - IntChannels(2)), IntChannels(0));
        largest = lanes::max(largest, held.registers[q]);
        const Channels concentration = lanes::convert<float>(movable) * Channels(inverse);
        lanes::store(out + kWidth * q, concentration);
    }
}

}  // namespace

std::int32_t concentrate(const PaintCell* pigment, const std::int32_t* thickness, int count,
                         float* out) {
    IntChannels largest(0);
    for (int cell = 0; cell < count; ++cell)
        concentrate_cell(ChannelInts::load(pigment[cell]), thickness[cell], out + cell * kPaintChannels,
                         largest);
    return lanes::largest(largest);
}

std::int32_t concentrate_strata(const WetStrataCells& cells, int count, float* lower, float* upper) {
    constexpr std::int32_t kSpare_quanta = 4;
    IntChannels largest(0);
    for (int cell = 0; cell < count; ++cell) {
        float *to_lower = lower + cell * kPaintChannels, *to_upper = upper + cell * kPaintChannels;
        const std::int32_t below = cells.lower_thickness[cell], whole = cells.thickness[cell];
        const ChannelInts all = ChannelInts::load(cells.paint[cell]);
        if (below == 0) {
            concentrate_cell(all, whole, to_lower, largest);
            concentrate_cell({}, 0, to_upper, largest);
            continue;
        }
        const ChannelInts bottom = ChannelInts::load(cells.lower_paint[cell]);
        ChannelInts top = all;
        for (int q = 0; q < kRegisters; ++q)
            top.registers[q] -= bottom.registers[q];
        concentrate_cell(bottom, below + kSpare_quanta, to_lower, largest);
        concentrate_cell(top, whole - below + kSpare_quanta, to_upper, largest);
    }
    return lanes::largest(largest);
}

}  // namespace pastoso::film::PASTOSO_ISA
