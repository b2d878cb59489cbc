// Compiled once per instruction set, whose registers the compiler fills by itself; see
// pastoso_add_kernels.
#include "film/explicit/structure_transport.hpp"
#include "film/explicit/tile_kernels.hpp"
#include "film/face/lane_groups.hpp"

namespace pastoso::film::PASTOSO_ISA {
namespace {

using grid::kTileSize;

/// b / h.
[[gnu::always_inline]] inline float worked_share(std::int32_t worked, std::int32_t thickness) {
    const std::int32_t whole = thickness > 1 ? thickness : 1;
    return lanes::min(static_cast<float>(worked) / static_cast<float>(whole), 1.0F);
}

/// What the fluxes through the faces that look `along` further in the block carry of worked paint, each
/// of what the cell that gives has.
void carry_row(int along, int first_x, int y, const std::int32_t* flux, const BlockArray<float>& share,
               std::int32_t* part) {
    for (int x = first_x; x < kTileSize; ++x) {
        const int f = face_index(x, y), cell = block_index(x, y);
        const float forward = share[cell], back = share[cell + along];
        part[f] =
            static_cast<std::int32_t>(static_cast<float>(flux[f]) * (flux[f] > 0 ? forward : back));
    }
}

std::int32_t gained(const FaceArray<std::int32_t>& through_x, const FaceArray<std::int32_t>& through_y,
                    int f) {
    return (through_x[f - 1] - through_x[f]) + (through_y[f - kFaceStride] - through_y[f]);
}

/// The mean shear of the film's columns in this step, from its fluxes.
[[gnu::always_inline]] inline float strain(const TileScratch& scratch, int f, std::int32_t thickness,
                                           float strain_per_share) {
    const float along_x =
        static_cast<float>(scratch.flux_x[f - 1]) + static_cast<float>(scratch.flux_x[f]);
    const float along_y =
        static_cast<float>(scratch.flux_y[f - kFaceStride]) + static_cast<float>(scratch.flux_y[f]);
    const float whole = static_cast<float>(thickness > 1 ? thickness : 1);
    return 0.5F * lanes::sqrt(along_x * along_x + along_y * along_y) / whole *
           (strain_per_share / whole);
}

}  // namespace

void loosen(const std::int32_t* worked, const std::int32_t* thickness, int count,
            const float* structure_share, float* viscosity, float* yield) {
    for (int i = 0; i < count; ++i) {
        const float left = 1.0F - structure_share[i] * worked_share(worked[i], thickness[i]);
        viscosity[i] *= left;
        yield[i] *= left;
    }
}

void move_structure(const StructureStep& step, const TileScratch& scratch, StructureScratch& structure,
                    const std::int32_t* thickness_after, std::int32_t* worked_after) {
    for (int cell = 0; cell < kBlockCells; ++cell)
        structure.share[cell] = worked_share(structure.quanta[cell], scratch.block.quanta[cell]);
    for (int y = -1; y < kTileSize; ++y) {
        if (y >= 0) carry_row(1, -1, y, scratch.flux_x.data(), structure.share, structure.flux_x.data());
        carry_row(kBlockStride, 0, y, scratch.flux_y.data(), structure.share, structure.flux_y.data());
    }
    for (int y = 0; y < kTileSize; ++y)
        for (int x = 0; x < kTileSize; ++x) {
            const int cell = block_index(x, y), f = face_index(x, y), i = y * kTileSize + x;
            const std::int32_t whole = thickness_after[i];
            const std::int32_t carried =
                structure.quanta[cell] + gained(structure.flux_x, structure.flux_y, f);
            const std::int32_t worked = lanes::max(lanes::min(carried, whole), 0);
            const float k = strain(scratch, f, scratch.block.quanta[cell],
                                   step.shear_quanta / structure.breakdown_strain[cell]);
            const float intact = static_cast<float>(whole - worked) / (1.0F + k * (1.0F + 0.5F * k));
            const std::int32_t broken = whole - static_cast<std::int32_t>(intact);
            worked_after[i] = lanes::max(worked, broken);
        }
}

}  // namespace pastoso::film::PASTOSO_ISA
