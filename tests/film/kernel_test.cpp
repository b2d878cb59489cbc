// The vectorised kernels against the same formulas on single floats, and every instruction set against
// the others.
#include "core/isa.hpp"
#include "film/explicit/face_step.hpp"
#include "film/explicit/tile_step.hpp"
#include "film/large/large_tile_kernels.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::film::test {
namespace {

using grid::kTileSize;

StepConstants oily_constants() {
    StepConstants step;
    step.cell_mm = 0.25F;
    step.inverse_cell = 4.0F;
    step.dt_s = 2e-4F;
    step.gravity_mm_s2 = 5000.0F;
    step.force_y_mm_s2 = 8000.0F;
    step.tension = 2.3e4F;
    step.viscosity_mm2_s = 3000.0F;
    step.yield = 400.0F;
    step.drag_against = 12.0F;
    step.drag_along = 2.3F;
    step.slip_mm = 0.05F;
    step.tan_advancing = 0.5F;
    step.tan_receding = 0.2F;
    step.wet_mm = 2.5e-5F;
    return step;
}

/// Rough paint with dry patches on a rough support.
void fill_randomly(std::uint32_t seed, HaloBlock& block, float largest_mm = 0.8F) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(0.0F, 1.0F);
    for (int i = 0; i < kBlockCells; ++i) {
        const float thickness = uniform(random) < 0.3F ? 0.0F : uniform(random) * largest_mm;
        block.quanta[i] =
            static_cast<std::int32_t>(thickness / static_cast<float>(kThicknessQuantum_mm));
        block.thickness[i] = thickness_mm(block.quanta[i]);
        block.support[i] = 0.1F * uniform(random);
        block.eta[i] = block.thickness[i] + block.support[i];
        block.velocity_x[i] = uniform(random) - 0.5F;
        block.velocity_y[i] = uniform(random) - 0.5F;
        block.viscosity[i] = 1000.0F + 4000.0F * uniform(random);
        block.yield[i] = lanes::max(0.0F, 800.0F * uniform(random) - 300.0F);
    }
    CellNumbers<BlockArray<float>>& numbers = block.numbers;
    for (int i = 0; i < kBlockCells; ++i) {
        numbers.density_kg_m3[i] = 900.0F + 400.0F * uniform(random);
        numbers.tension[i] = 1.5e4F + 1e4F * uniform(random);
        numbers.flow_index[i] = 0.4F + 0.6F * uniform(random);
        numbers.drag_along[i] = 2.0F + uniform(random);
        numbers.drag_against[i] = 4.0F + 8.0F * uniform(random);
        numbers.slip_mm[i] = 0.1F * uniform(random);
        numbers.tan_receding[i] = 0.3F * uniform(random);
        numbers.tan_advancing[i] = numbers.tan_receding[i] + 0.3F * uniform(random);
    }
    block.first_wet_row = -kHalo;
    block.last_wet_row = kTileSize + kHalo - 1;
}

CellEnd<float> scalar_end(const FilmEnds& ends, int i, int along) {
    const bool along_x = along == 1;
    return {.contact_slope = ends.contact_slope[i],
            .slope = ends.slope[i],
            .reach_mm = ends.reach_mm[i],
            .depth_mm = along_x ? ends.depth_x_mm[i] : ends.depth_y_mm[i],
            .over_mm = along_x ? ends.over_x_mm[i] : ends.over_y_mm[i],
            .normal_along = along_x ? ends.normal_x[i] : ends.normal_y[i]};
}

FaceNeighbourhood<float> scalar_neighbourhood(const TileScratch& s, const StepConstants& step, int i,
                                              int along, int across, const float* u, const float* v) {
    const HaloBlock& b = s.block;
    FaceNeighbourhood<float> face{};
    face.h_left = b.thickness[i];
    face.h_right = b.thickness[i + along];
    face.support_left = b.support[i];
    face.support_right = b.support[i + along];
    face.rise_left = s.rise_mm[i];
    face.rise_right = s.rise_mm[i + along];
    face.eta_left2 = b.eta[i - along];
    face.eta_left = b.eta[i];
    face.eta_right = b.eta[i + along];
    face.eta_right2 = b.eta[i + 2 * along];
    face.eta_slope_across = 0.25F * step.inverse_cell *
                            ((b.eta[i + across] - b.eta[i - across]) +
                             (b.eta[i + along + across] - b.eta[i + along - across]));
    face.pressure_left = s.pressure[i];
    face.pressure_right = s.pressure[i + along];
    face.pressure_rise_across = difference_across<float>(
        [&](std::ptrdiff_t n) { return s.pressure[i + n]; },
        [&](std::ptrdiff_t n) { return b.thickness[i + n] > step.wet_mm; }, along, across);
    face.curvature = 0.5F * (s.curvature[i] + s.curvature[i + along]);
    face.end_left = scalar_end(s.ends, i, along);
    face.end_right = scalar_end(s.ends, i + along, along);
    face.u = u[i];
    face.u_back = u[i - along];
    face.u_front = u[i + along];
    face.u_before = u[i - across];
    face.u_after = u[i + across];
    face.v = 0.25F * ((v[i] + v[i + along]) + (v[i - across] + v[i + along - across]));
    return face;
}

// The same formula on single floats must give the same bits as on registers: both follow IEEE 754, and
// no fused multiply-add is allowed.
TEST(TileKernel, EqualsTheScalarFormulaToTheBit) {
    const StepConstants step = oily_constants();
    const auto scratch = std::make_unique<TileScratch>();
    fill_randomly(7, scratch->block);
    core::kernels<TileKernels>().flow(step, kTileSize, kTileSize, {}, *scratch);
    int flowing = 0;
    for (int y = 0; y < kTileSize; ++y)
        for (int x = 0; x < kTileSize; ++x) {
            const HaloBlock& b = scratch->block;
            const FaceFlow<float> flow = face_flow<FaceModel{.yield = true, .alpha_range = true}>(
                scalar_neighbourhood(*scratch, step, block_index(x, y), kBlockStride, 1,
                                     b.velocity_y.data(), b.velocity_x.data()),
                step, step.force_y_mm_s2, step.force_x_mm_s2);
            ASSERT_EQ(flow.velocity, scratch->velocity_y[face_index(x, y)]) << x << ' ' << y;
            flowing += flow.velocity != 0.0F ? 1 : 0;
        }
    EXPECT_GT(flowing, 500);
}

enum class PaintKind { Uniform, Varied, SeveralMedia };
class TileKernelOfPaint : public testing::TestWithParam<PaintKind> {};

TEST_P(TileKernelOfPaint, GivesTheSameBitsOnEveryInstructionSet) {
    StepConstants step = oily_constants();
    step.varied = GetParam() != PaintKind::Uniform;
    step.media = GetParam() == PaintKind::SeveralMedia;
    const auto reference = std::make_unique<TileScratch>();
    const auto scratch = std::make_unique<TileScratch>();
    for (const std::uint32_t seed : {1U, 2U, 3U}) {
        fill_randomly(seed, reference->block);
        fill_randomly(seed, scratch->block);
        const FlowExtremes expected = core::kernels<TileKernels>(core::Isa::Baseline)
                                          .flow(step, kTileSize, kTileSize, {}, *reference);
        for (const core::Isa isa : {core::Isa::Avx2, core::Isa::Avx512}) {
            if (isa > core::best_isa()) continue;
            const FlowExtremes found =
                core::kernels<TileKernels>(isa).flow(step, kTileSize, kTileSize, {}, *scratch);
            EXPECT_EQ(scratch->velocity_x, reference->velocity_x) << core::name_of(isa);
            EXPECT_EQ(scratch->velocity_y, reference->velocity_y) << core::name_of(isa);
            EXPECT_EQ(scratch->flux_x, reference->flux_x) << core::name_of(isa);
            EXPECT_EQ(scratch->flux_y, reference->flux_y) << core::name_of(isa);
            EXPECT_EQ(found.mobility, expected.mobility) << core::name_of(isa);
            EXPECT_EQ(found.speed_mm_s, expected.speed_mm_s) << core::name_of(isa);
        }
    }
}

TEST(TileKernel, GivesTheSameBitsOfFullCellsOnEveryInstructionSet) {
    const auto reference = std::make_unique<TileScratch>();
    const auto scratch = std::make_unique<TileScratch>();
    fill_randomly(5, reference->block, static_cast<float>(kMaxThickness_mm));
    fill_randomly(5, scratch->block, static_cast<float>(kMaxThickness_mm));
    StepConstants step = oily_constants();
    step.dt_s = 0.01F;
    const FlowExtremes expected =
        core::kernels<TileKernels>(core::Isa::Baseline).flow(step, kTileSize, kTileSize, {}, *reference);
    EXPECT_GT(expected.clamped_faces, 100);
    for (const core::Isa isa : {core::Isa::Avx2, core::Isa::Avx512}) {
        if (isa > core::best_isa()) continue;
        const FlowExtremes found =
            core::kernels<TileKernels>(isa).flow(step, kTileSize, kTileSize, {}, *scratch);
        EXPECT_EQ(scratch->flux_x, reference->flux_x) << core::name_of(isa);
        EXPECT_EQ(scratch->flux_y, reference->flux_y) << core::name_of(isa);
        EXPECT_EQ(scratch->velocity_x, reference->velocity_x) << core::name_of(isa);
        EXPECT_EQ(found.clamped_faces, expected.clamped_faces) << core::name_of(isa);
    }
}

/// The fluxes of a large step whose faces are slow but for some in the last columns, which many groups
/// of lanes come over.
FlowExtremes extremes_of_fast_faces(int count, core::Isa isa) {
    StepConstants step = oily_constants();
    step.cell_mm = 0.125F;
    step.inverse_cell = 8.0F;
    const auto tile = std::make_unique<LargeTile>();
    const auto large = std::make_unique<LargeScratch>();
    const auto scratch = std::make_unique<TileScratch>();
    large->share.fill(1.0F);
    for (LargeFaces* faces : {&tile->x, &tile->y}) {
        faces->velocity.fill(0.1F);
        faces->depth.fill(0.2F);
        faces->drag.fill(1.0F);
    }
    for (int k = 0; k < count; ++k)
        tile->x.velocity[face_index(kTileSize - 1 - k % 3, k / 3)] = 5.0F;
    return core::kernels<LargeKernels>(isa).fluxes(step, *large, *tile, *scratch);
}

TEST(LargeKernel, SpeedOfATenthOfASquareMillimetreIsNotSeenOnAnyInstructionSet) {
    constexpr int kUnseenFaces = 12;  // 0.1 mm2 are 6.4 cells of 0.125 mm, and a cell has two faces
    for (const core::Isa isa : {core::Isa::Baseline, core::Isa::Avx2, core::Isa::Avx512}) {
        if (isa > core::best_isa()) continue;
        EXPECT_EQ(extremes_of_fast_faces(0, isa).seen_speed_mm_s, 0.1F) << core::name_of(isa);
        const FlowExtremes unseen = extremes_of_fast_faces(kUnseenFaces, isa);
        EXPECT_EQ(unseen.speed_mm_s, 5.0F) << core::name_of(isa);
        EXPECT_EQ(unseen.seen_speed_mm_s, 0.125F) << core::name_of(isa) << ": the next half octave";
        EXPECT_EQ(extremes_of_fast_faces(kUnseenFaces + 1, isa).seen_speed_mm_s, 5.0F)
            << core::name_of(isa);
    }
}

/// Fluxes and paint so strong that many channels run full.
void crowd(std::uint32_t seed, bool large_fluxes, TileScratch& scratch, std::vector<PaintCell>& held,
           std::vector<float>& concentrations) {
    fill_randomly(seed, scratch.block, static_cast<float>(kMaxThickness_mm));
    std::mt19937 random(seed);
    std::uniform_int_distribution<std::int32_t> amount(0, std::numeric_limits<std::int32_t>::max());
    std::uniform_real_distribution<float> share(-1.0F, 1.0F);
    scratch.large_fluxes = large_fluxes;
    scratch.supply.fill(1.5F);
    for (PaintCell& cell : held)
        for (std::int32_t& channel : cell)
            channel = amount(random);
    for (int y = -1; y <= kTileSize; ++y)
        for (int x = -1; x <= kTileSize; ++x)
            core::kernels<TileKernels>(core::Isa::Baseline)
                .concentrate(&held[held_index(x, y)], &scratch.block.quanta[block_index(x, y)], 1,
                             &concentrations[concentration_index(x, y)]);
    for (int y = 0; y < kTileSize; ++y)
        for (int x = 0; x + 1 < kTileSize; ++x) {
            const float part = 0.25F * share(random);
            const int donor = block_index(part > 0.0F ? x : x + 1, y);
            scratch.flux_x[face_index(x, y)] =
                static_cast<std::int32_t>(part * static_cast<float>(scratch.block.quanta[donor]));
        }
}

std::int64_t sum(const std::vector<PaintCell>& cells) {
    std::int64_t total = 0;
    for (const PaintCell& cell : cells)
        total = std::accumulate(cell.begin(), cell.end(), total);
    return total;
}

class CrowdedPaint : public testing::TestWithParam<bool> {};

TEST_P(CrowdedPaint, NeverOverflowsAndIsTheSameOnEveryInstructionSet) {
    const auto scratch = std::make_unique<TileScratch>();
    std::vector<PaintCell> held(kHeldSide * kHeldSide), before(grid::kTileCells), expected;
    std::vector<float> concentrations(kConcentrationCount);
    crowd(3, GetParam(), *scratch, held, concentrations);
    for (int y = 0; y < kTileSize; ++y)
        for (int x = 0; x < kTileSize; ++x)
            before[y * kTileSize + x] = held[held_index(x, y)];
    for (const core::Isa isa : {core::Isa::Baseline, core::Isa::Avx2, core::Isa::Avx512}) {
        if (isa > core::best_isa()) continue;
        std::vector<PaintCell> after(grid::kTileCells);
        const PigmentMoved moved = core::kernels<TileKernels>(isa).transport(
            *scratch, concentrations.data(), held.data(), kTileSize, kTileSize, {}, before.data(),
            after.data());
        EXPECT_GT(moved.held_back_faces, 100);
        EXPECT_EQ(sum(after), sum(before));
        for (const PaintCell& cell : after)
            for (const std::int32_t channel : cell)
                ASSERT_GE(channel, 0) << core::name_of(isa);
        if (isa == core::Isa::Baseline) expected = after;
        EXPECT_EQ(after, expected) << core::name_of(isa);
    }
}
INSTANTIATE_TEST_SUITE_P(ExplicitAndLargeFluxes, CrowdedPaint, testing::Bool());

/// Paint in one stratum here and in two there, with fluxes through some faces of some rows.
struct StrataOnTheMove {
    explicit StrataOnTheMove(bool large_fluxes) {
        std::vector<float> unused(kConcentrationCount);
        crowd(5, large_fluxes, *scratch, held, unused);
        std::mt19937 random(5);
        std::uniform_int_distribution<int> sixteenth(0, 15);
        upper->quanta.fill(0);
        for (int y = -1; y <= kTileSize; ++y)
            for (int x = -1; x <= kTileSize; ++x) {
                const int place = held_index(x, y), cell = block_index(x, y);
                for (std::int32_t& channel : held[place])
                    channel >>= 4;
                const int part = sixteenth(random) - 8;
                if (part <= 0) continue;
                thickness[place] = scratch->block.quanta[cell] / 16 * part;
                upper->quanta[cell] = scratch->block.quanta[cell] - thickness[place];
                for (int k = 0; k < kPaintChannels; ++k)
                    lower[place][k] = held[place][k] / 16 * sixteenth(random);
            }
        for (int y = 0; y < kTileSize; ++y)
            for (int x = 0; x < kTileSize; ++x)
                if (y % 3 == 0 || sixteenth(random) < 8) scratch->flux_x[face_index(x, y)] = 0;
    }
    /// A margin of one cell around a tile away.
    static std::vector<PaintCell> inside(const std::vector<PaintCell>& cells) {
        std::vector<PaintCell> tile(grid::kTileCells);
        for (int y = 0; y < kTileSize; ++y)
            std::copy_n(&cells[held_index(0, y)], kTileSize, &tile[y * kTileSize]);
        return tile;
    }

    std::unique_ptr<TileScratch> scratch = std::make_unique<TileScratch>();
    std::unique_ptr<StrataScratch> upper = std::make_unique<StrataScratch>();
    std::vector<PaintCell> held = std::vector<PaintCell>(kHeldSide * kHeldSide), lower = held;
    std::vector<std::int32_t> thickness = std::vector<std::int32_t>(kHeldSide * kHeldSide);
};

struct MovedStrata {
    std::vector<PaintCell> whole = std::vector<PaintCell>(grid::kTileCells);
    std::vector<LowerChange> changes = std::vector<LowerChange>(grid::kTileCells);
};

/// What the kernels of an instruction set make of it. Concentrations that are not read are `unread`.
MovedStrata moved_by(core::Isa isa, bool large_fluxes, float unread) {
    StrataOnTheMove paint(large_fluxes);
    StrataScratch& upper = *paint.upper;
    const auto& kernels = core::kernels<TileKernels>(isa);
    std::vector<float> lower(kConcentrationCount, unread);
    upper.concentrations.assign(kConcentrationCount, unread);
    kernels.find_read_cells(*paint.scratch, kTileSize, kTileSize, upper);
    for (int y = -1; y <= kTileSize; ++y)
        for (int x = -1; x <= kTileSize; ++x) {
            const int place = held_index(x, y), to = concentration_index(x, y);
            kernels.concentrate_strata(
                {&paint.held[place], &paint.scratch->block.quanta[block_index(x, y)],
                 &paint.lower[place], &paint.thickness[place]},
                &upper.read[concentration_place(x, y)], 1, &lower[to], &upper.concentrations[to]);
        }
    std::vector<std::int32_t> thickness(grid::kTileCells);
    kernels.apply_fluxes(*paint.scratch, thickness.data());
    kernels.split_strata({}, 1e6F, *paint.scratch, upper);
    const auto whole_before = paint.inside(paint.held), lower_before = paint.inside(paint.lower);
    MovedStrata moved;
    const StrataMoved done =
        kernels.transport_strata(*paint.scratch, upper, kTileSize, kTileSize, {},
                                 {lower.data(), nullptr, whole_before.data(), lower_before.data(),
                                  thickness.data(), moved.whole.data(), moved.changes.data()});
    moved.changes.resize(done.changes);
    EXPECT_EQ(sum(moved.whole), sum(whole_before));
    for (const LowerChange& change : moved.changes)
        EXPECT_TRUE(is_part_of(change.lower, thickness[change.cell], moved.whole[change.cell]));
    return moved;
}

class StrataKernels : public testing::TestWithParam<bool> {};

TEST_P(StrataKernels, AreTheSameOnEveryInstructionSet) {
    const MovedStrata expected = moved_by(core::Isa::Baseline, GetParam(), 0.0F);
    EXPECT_GT(expected.changes.size(), 500U);
    for (const core::Isa isa : {core::Isa::Baseline, core::Isa::Avx2, core::Isa::Avx512}) {
        if (isa > core::best_isa()) continue;
        const MovedStrata moved = moved_by(isa, GetParam(), 7.0F);
        EXPECT_EQ(moved.whole, expected.whole) << core::name_of(isa);
        ASSERT_EQ(moved.changes.size(), expected.changes.size()) << core::name_of(isa);
        for (std::size_t i = 0; i < moved.changes.size(); ++i) {
            ASSERT_EQ(moved.changes[i].cell, expected.changes[i].cell);
            ASSERT_EQ(moved.changes[i].lower.thickness, expected.changes[i].lower.thickness);
            ASSERT_EQ(moved.changes[i].lower.paint, expected.changes[i].lower.paint);
        }
    }
}
INSTANTIATE_TEST_SUITE_P(ExplicitAndLargeFluxes, StrataKernels, testing::Bool());

INSTANTIATE_TEST_SUITE_P(Kinds, TileKernelOfPaint,
                         testing::Values(PaintKind::Uniform, PaintKind::Varied,
                                         PaintKind::SeveralMedia));

// x = 1 is the yield point: (1 + d) x - 3/2 + 1/(2 x^2) = d |w| / y.
TEST(BinghamDrag, SolvesItsEquation) {
    for (const float drag : {1e-3F, 1.0F, 50.0F, 1e4F}) {
        for (const double x : {1.001, 1.1, 1.5, 2.0, 30.0}) {
            const double exact_stress = (1.0 + drag) * x - 1.5 + 0.5 / (x * x);
            const auto stress = static_cast<float>(exact_stress);
            const BinghamDrag<float> solved = bingham_drag(drag, stress);
            const double exact = (x - 1) * (x - 1) * (x + 0.5) / (exact_stress * x * x);
            // Near yield the stress that single precision can give counts, 6e-8 of it against x - 1.
            EXPECT_NEAR(solved.factor / exact, 1.0, x < 1.01 ? 2e-3 : 1e-5) << drag << ' ' << x;
            EXPECT_NEAR(solved.tangent_share, 1.0 - 1.0 / (x * x * x), 1e-6) << drag << ' ' << x;
        }
        EXPECT_EQ(bingham_drag(drag, 0.999F * drag).factor, 0.0F);
        EXPECT_EQ(bingham_drag(drag, 0.0F).factor, 0.0F);
    }
}

// Thick slow paint on a thin film meets every magnitude; none may overflow.
TEST(BinghamDrag, StaysFinite) {
    for (const float drag : {1e-12F, 1.0F, 1e15F})
        for (const float stress : {0.0F, 1e-30F, 1e-12F, 1.0F, 1e16F, 1e30F}) {
            const BinghamDrag<float> solved = bingham_drag(drag, stress);
            EXPECT_TRUE(solved.factor >= 0.0F && solved.factor <= 1.0F + 1e-6F) << drag << ' ' << stress;
        }
}

TEST(FaceFlow, NothingMovesBetweenDryCells) {
    FaceNeighbourhood<float> face{};
    face.eta_left = 3.0F;
    face.support_left = 3.0F;
    face.pressure_left = 100.0F;
    const FaceFlow<float> flow = face_flow<FaceModel{}>(face, oily_constants(), 1000.0F, 0.0F);
    EXPECT_EQ(flow.velocity, 0.0F);
    EXPECT_EQ(flow.thickness, 0.0F);
}

}  // namespace
}  // namespace pastoso::film::test
