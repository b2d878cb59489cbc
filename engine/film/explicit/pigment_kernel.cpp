// Compiled once per instruction set; see pastoso_add_kernels.
#include "film/explicit/pigment_stream.hpp"

namespace pastoso::film::PASTOSO_ISA {
namespace {

template <bool kLargeFluxes, bool kIsCrowded>
PigmentMoved transport(const TileScratch& scratch, const float* concentrations, const PaintCell* held,
                       int columns, int rows, const OpenEdges& runoff_edges, const PaintCell* before,
                       PaintCell* after) {
    PigmentMoved moved;
    const MovingPaint paint{scratch.block.quanta, scratch.supply, scratch.flux_x, scratch.flux_y,
                            concentrations};
    PaintStream<kLargeFluxes, kIsCrowded> stream{
        {paint, held, moved.held_back_faces}, runoff_edges, moved};
    stream.enter_tile(columns);
    for (int y = 0; y < rows; ++y) {
        ChannelInts left = stream.enter_row(y);
        for (int x = 0; x < columns; ++x) {
            const int cell = y * kTileSize + x;
            if (!paint.passes(x, y)) {
                after[cell] = before[cell];
                left = {};
                continue;
            }
            ChannelInts now = ChannelInts::load(before[cell]);
            now += stream.gain(x, y, y == rows - 1, left);
            now.store(after[cell]);
        }
        stream.leave_row(left);
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

std::int32_t concentrate_strata(const WetStrataCells& cells, const std::uint8_t* read, int count,
                                float* lower, float* upper) {
    constexpr std::int32_t kSpare_quanta = 4;
    IntChannels largest(0);
    for (int cell = 0; cell < count; ++cell) {
        if (read[cell] == 0) continue;
        float *to_lower = lower + cell * kPaintChannels, *to_upper = upper + cell * kPaintChannels;
        const std::int32_t below = cells.lower_thickness[cell], whole = cells.thickness[cell];
        const ChannelInts all = ChannelInts::load(cells.paint[cell]);
        if (below == 0) {
            concentrate_cell(all, whole, to_lower, largest);
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
