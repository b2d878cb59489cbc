// The kernels give the same bits with every instruction set.
#include "shade/kernels.hpp"

#include "canvas.hpp"
#include "core/random.hpp"
#include "core/thread_pool.hpp"
#include "shade/cell_layers.hpp"
#include "shade/outline_layers.hpp"

#include <cstring>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::shade {
namespace {

class EveryIsa : public testing::TestWithParam<core::Isa> {
  protected:
    void SetUp() override {
        if (GetParam() > core::best_isa())
            GTEST_SKIP() << "This processor has no " << core::name_of(GetParam());
    }
};

template <class T>
void expect_same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(T)), 0);
}

TEST_P(EveryIsa, ColoursCellsAlike) {
    const film::FilmState film = test::random_canvas({64, 64}, 4);
    std::vector<film::PaintCell> lower(film.paint.read(0), film.paint.read(0) + grid::kTileCells);
    for (film::PaintCell& cell : lower)
        for (std::int32_t& channel : cell)
            channel /= 3;
    std::vector<film::PigmentCell> soluble(grid::kTileCells);
    std::vector<film::StrataOptics> strata(grid::kTileCells, film::kClearStrata);
    for (std::uint32_t i = 0; i < grid::kTileCells; ++i) {
        soluble[i].fill(static_cast<std::int32_t>(1e6F * core::uniform_noise(i, 8)));
        for (int band = 0; band < pigment::kBands; ++band) {
            const float reflected = core::uniform_noise(i, 9 + band);
            film::set_optics(band, {reflected, 0.5F * (1.0F - reflected), reflected}, strata[i]);
        }
    }
    const auto colours = [&](core::Isa isa) {
        std::vector<CellColour> result(grid::kTileCells - 3);
        core::kernels<Kernels>(isa).colour_cells(
            {film.paint.read(0), lower.data(), film.thickness.read(0), soluble.data(), strata.data()},
            grid::kTileCells - 3, test::kGround, pigment::kBandsToLinearSrgb, result.data());
        return result;
    };
    expect_same_bits(colours(GetParam()), colours(core::Isa::Baseline));
}

TEST_P(EveryIsa, FindsHorizonsAlike) {
    std::vector<float> heights(1000);
    for (std::size_t i = 0; i < heights.size(); ++i) {
        heights[i] = core::uniform_noise(static_cast<std::uint32_t>(i), 5);
    }
    const HorizonLook look{{1, 30, -60, 200}, {4.0F, 2.0F, 1.0F, 0.5F}};
    const auto shares = [&](core::Isa isa) {
        std::vector<float> result(701, 0.25F);
        core::kernels<Kernels>(isa).add_horizon(look, heights.data() + 60, 701, result.data());
        return result;
    };
    expect_same_bits(shares(GetParam()), shares(core::Isa::Baseline));
}

TEST_P(EveryIsa, RaisesShadowsAlike) {
    std::vector<float> heights(300);
    for (std::size_t i = 0; i < heights.size(); ++i) {
        heights[i] = core::uniform_noise(static_cast<std::uint32_t>(i), 6);
    }
    const auto shadows = [&](core::Isa isa) {
        std::vector<float> result(101, 0.3F);
        core::kernels<Kernels>(isa).raise_shadow(heights.data(), heights.data() + 150, 0.37F, 0.2F, 101,
                                                 result.data());
        return result;
    };
    expect_same_bits(shadows(GetParam()), shadows(core::Isa::Baseline));
}

TEST_P(EveryIsa, ShadesRowsAlike) {
    const film::FilmState film = test::random_canvas({40, 40}, 6);
    core::ThreadPool pool(1);
    const Lighting lighting;
    const CellLayers layers = cell_layers(film, test::kGround, film.shape.cells(), lighting, pool);
    const SampleColumns columns(sample_axis({4.0, 0.31, 0.5F}, 0, 99, 0));
    const SampleAxis lines = sample_axis({10.0, 0.77, 0.5F}, 0, 1, 0);
    const auto row = [&](core::Isa isa) {
        std::vector<float> rgb(3 * 99);
        core::kernels<Kernels>(isa).shade_row(layers.rows_from(lines.first_cell[0]), lines.weights[0],
                                              columns, 0.25F, shading_constants(lighting, 0.25),
                                              rgb.data());
        return rgb;
    };
    expect_same_bits(row(GetParam()), row(core::Isa::Baseline));
}

TEST_P(EveryIsa, DrawsOutlinesAlike) {
    const film::FilmState film = test::random_canvas({40, 40}, 16);
    core::ThreadPool pool(1);
    const Lighting lighting;
    const CellLayers layers = cell_layers(film, test::kGround, film.shape.cells(), lighting, pool);
    const OutlineLayers outline = outline_layers(film, test::kGround, layers, pool);
    const SampleColumns columns(sample_axis({4.0, 0.21, 0.5F}, 0, 150, 0));
    const SampleAxis lines = sample_axis({10.0, 0.77, 0.5F}, 0, 1, 0);
    const auto row = [&](core::Isa isa) {
        std::vector<float> rgb(3 * 150, 0.5F);
        core::kernels<Kernels>(isa).outline_row(layers.rows_from(lines.first_cell[0]),
                                                outline.rows_from(lines.first_cell[0]), lines.weights[0],
                                                columns, {0.25F, 0.21F, 0.7F},
                                                shading_constants(lighting, 0.25), rgb.data());
        return rgb;
    };
    expect_same_bits(row(GetParam()), row(core::Isa::Baseline));
}

INSTANTIATE_TEST_SUITE_P(Kernels, EveryIsa, testing::Values(core::Isa::Avx2, core::Isa::Avx512),
                         [](const auto& test) { return core::name_of(test.param); });

}  // namespace
}  // namespace pastoso::shade
