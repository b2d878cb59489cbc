// What carries paint from cell to cell: shared by the kernels of one instruction set.
#pragma once

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
    std::array<IntChannels, kRegisters> registers{};

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
    [[gnu::always_inline]] ChannelInts& operator+=(const ChannelInts& more) {
        for (int q = 0; q < kRegisters; ++q)
            registers[q] += more.registers[q];
        return *this;
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

/// Paint on the move in a tile: all of it, or one stratum (tile_step.hpp).
struct MovingPaint {
    const BlockArray<std::int32_t>& quanta;
    const BlockArray<float>& supply;
    const FaceArray<std::int32_t>& flux_x;
    const FaceArray<std::int32_t>& flux_y;
    const float* concentrations;

    /// Whether any passes one of a cell's faces.
    [[gnu::always_inline]] bool passes(int x, int y) const {
        const int f = face_index(x, y);
        return (flux_x[f - 1] | flux_x[f] | flux_y[f - kFaceStride] | flux_y[f]) != 0;
    }
};

/// Says what passes a face.
template <bool kLargeFluxes, bool kIsCrowded>
struct PigmentFluxes {
    MovingPaint paint;
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
        const std::int32_t* quanta = &paint.quanta[forward ? cell : cell + block_step];
        const float* donor =
            paint.concentrations + (forward ? concentration : concentration + concentration_step);
        const float amount = static_cast<float>(forward ? flux : -flux);
        const bool smooth =
            quanta[downwind_step] > kNegligible_quanta && quanta[-downwind_step] > kNegligible_quanta;
        float reach = 0.5F - 2.0F * amount / static_cast<float>(*quanta);
        float own = amount;
        if constexpr (kLargeFluxes) {
            const float supply = paint.supply[quanta - paint.quanta.data()];
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
        const ChannelInts wanted = through(paint.flux_x[face_index(x, y)], block_index(x, y),
                                           concentration_index(x, y), 1, kPaintChannels);
        return kIsCrowded ? fitting(wanted, held[held_index(x, y)], held[held_index(x + 1, y)]) : wanted;
    }
    [[gnu::always_inline]] ChannelInts through_y(int x, int y) const {
        const ChannelInts wanted =
            through(paint.flux_y[face_index(x, y)], block_index(x, y), concentration_index(x, y),
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

/// Paint that flows through a tile, whose cells are visited row by row.
template <bool kLargeFluxes, bool kIsCrowded>
struct PaintStream {
    PigmentFluxes<kLargeFluxes, kIsCrowded> fluxes;
    const OpenEdges& runoff_edges;
    PigmentMoved& moved;
    std::array<PaintCell, kTileSize> from_above{};

    [[gnu::always_inline]] void enter_tile(int columns) {
        for (int x = 0; x < columns; ++x) {
            const ChannelInts top = fluxes.through_y(x, -1);
            if (runoff_edges.top) add_runoff(-top);
            top.store(from_above[x]);
        }
    }
    /// Returns what comes into the first cell of a row from the left.
    [[gnu::always_inline]] ChannelInts enter_row(int y) {
        const ChannelInts left = fluxes.through_x(-1, y);
        if (runoff_edges.left) add_runoff(-left);
        return left;
    }
    /// What a cell gains; `left` is what comes into it, then into the next one.
    [[gnu::always_inline]] ChannelInts gain(int x, int y, bool last_row, ChannelInts& left) {
        const ChannelInts right = fluxes.through_x(x, y);
        const ChannelInts below = fluxes.through_y(x, y);
        ChannelInts gained;
        for (int q = 0; q < kRegisters; ++q)
            gained.registers[q] = left.registers[q] - right.registers[q] - below.registers[q];
        if (fluxes.paint.flux_y[face_index(x, y - 1)] != 0) gained += ChannelInts::load(from_above[x]);
        below.store(from_above[x]);
        left = right;
        if (runoff_edges.bottom && last_row) add_runoff(below);
        return gained;
    }
    [[gnu::always_inline]] void leave_row(const ChannelInts& left) {
        if (runoff_edges.right) add_runoff(left);
    }

  private:
    void add_runoff(const ChannelInts& outward) {
        for (int k = 0; k < kPaintChannels; ++k)
            moved.runoff[k] += outward.registers[k / kWidth][k % kWidth];
    }
};

}  // namespace
}  // namespace pastoso::film::PASTOSO_ISA
