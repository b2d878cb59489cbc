// What happens to the paint in bristles: the same bits on every instruction set as number by number.
#include "brush/contents_kernels.hpp"

#include "core/random.hpp"
#include "film/state.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

constexpr double kCellArea_mm2 = 1.0 / 64.0;

float noise(std::uint32_t seed, int i) {
    return core::uniform_noise(static_cast<std::uint32_t>(i), seed);
}

/// Some channels hold next to nothing, one more than paint can.
Contents random_contents(std::uint32_t seed) {
    Contents contents;
    contents.volume_mm3 = 0.1 + noise(seed, 100);
    for (int k = 0; k < film::kPaintChannels; ++k)
        contents.paint[k] =
            noise(seed, k) < 0.3F ? 1e-8 * noise(seed, 32 + k) : 30.0 * noise(seed, 64 + k);
    contents.paint[3] = 2000.0 * contents.volume_mm3;
    return contents;
}

/// brush/wick.hpp, number by number.
void wick_by_numbers(Contents& a, Contents& b, double wick) {
    const double both = 0.5 * wick * std::min(a.volume_mm3, b.volume_mm3);
    const double one = 0.25 * wick * (a.volume_mm3 - b.volume_mm3);
    const double of_a =
        a.volume_mm3 > 0.0 ? std::min(1.0, (both + std::max(one, 0.0)) / a.volume_mm3) : 0.0;
    const double of_b =
        b.volume_mm3 > 0.0 ? std::min(1.0, (both + std::max(-one, 0.0)) / b.volume_mm3) : 0.0;
    const auto swap = [&](double& x, double& y) {
        const double amount = x * of_a - y * of_b;
        x -= amount;
        y += amount;
    };
    swap(a.volume_mm3, b.volume_mm3);
    for (int k = 0; k < film::kPaintChannels; ++k)
        swap(a.paint[k], b.paint[k]);
}

class ContentsOnEveryInstructionSet : public testing::TestWithParam<core::Isa> {
  protected:
    void SetUp() override {
        if (GetParam() > core::best_isa())
            GTEST_SKIP() << "this processor has no " << core::name_of(GetParam());
    }
    const ContentsKernels& kernels() const { return core::kernels<ContentsKernels>(GetParam()); }
};

TEST_P(ContentsOnEveryInstructionSet, WickAsTheNumbersDo) {
    std::vector<Contents> held;
    for (std::uint32_t seed = 0; seed < 9; ++seed)
        held.push_back(random_contents(seed));
    held[4] = {};
    std::vector<Contents> expected = held;
    std::vector<std::pair<int, int>> pairs;
    for (int i = 0; i + 1 < 9; ++i)
        pairs.emplace_back(i, (i * 5 + 3) % 9 == i ? i + 1 : (i * 5 + 3) % 9);
    for (const auto& [a, b] : pairs)
        wick_by_numbers(expected[a], expected[b], 0.37);
    kernels().wick(held.data(), pairs.data(), static_cast<int>(pairs.size()), 0.37);
    EXPECT_EQ(held, expected);
}

TEST_P(ContentsOnEveryInstructionSet, GiveWhatIsNotNegligible) {
    const GivingLimits limits = {.kept_share = 0.25, .negligible = 1e-6, .strongest_per_mm = 1090.0};
    for (std::uint32_t seed = 0; seed < 9; ++seed) {
        const Contents held = random_contents(seed);
        film::PaintCoefficients given;
        kernels().give(held, limits, given);
        for (int k = 0; k < film::kPaintChannels; ++k) {
            const double per_mm = std::min(held.paint[k] * (1.0 / held.volume_mm3), 1090.0);
            const double quanta = per_mm * (film::kThicknessQuantum_mm / film::kPaintQuantum);
            const bool some = 0.25 * held.paint[k] > 1e-6;
            EXPECT_EQ(given[k], some ? static_cast<float>(quanta) : 0.0F) << "channel " << k;
        }
    }
}

TEST_P(ContentsOnEveryInstructionSet, LoseWhatTheFilmGained) {
    for (std::uint32_t seed = 0; seed < 9; ++seed) {
        Contents held = random_contents(seed);
        Contents expected = held;
        ChangeSums gained;
        gained.thickness = static_cast<std::int64_t>(1e7 * (noise(seed, 1) - 0.5F));
        for (int k = 0; k < film::kPaintChannels; ++k)
            gained.paint[k] = static_cast<std::int64_t>(1e12 * (noise(seed, 40 + k) - 0.5F));
        expected.volume_mm3 -=
            static_cast<double>(gained.thickness) * (film::kThicknessQuantum_mm * kCellArea_mm2);
        for (int k = 0; k < film::kPaintChannels; ++k)
            expected.paint[k] -=
                static_cast<double>(gained.paint[k]) * (film::kPaintQuantum * kCellArea_mm2);
        kernels().take(gained, kCellArea_mm2, held);
        EXPECT_EQ(held, expected);
    }
}

INSTANTIATE_TEST_SUITE_P(Kernels, ContentsOnEveryInstructionSet,
                         testing::Values(core::Isa::Baseline, core::Isa::Avx2, core::Isa::Avx512),
                         [](const auto& isa) { return core::name_of(isa.param); });

}  // namespace
}  // namespace pastoso::brush
