#include "film/support/support.hpp"

#include "core/error.hpp"
#include "core/hash.hpp"
#include "film/support/gesso_kernel.hpp"
#include "film/support/smooth_noise.hpp"
#include "film/support/weave_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace pastoso::film;  // NOLINT(google-build-using-namespace)
using pastoso::grid::Shape;

struct NamedSupport {
    const char* name;
    double relief_mm;
    double least_roughness_mm;  ///< standard deviation that the cells must show at 0.1 mm
    std::uint64_t heights = 0;  ///< their hash, over cells of many sizes
    double fine_mm = 0.05;      ///< a cell of which even five side by side show the finest thread
};

pastoso::core::ThreadPool pool(2);  // NOLINT(cert-err58-cpp)

class EverySupport : public testing::TestWithParam<NamedSupport> {};

struct Statistics {
    double least = 1e9, most = -1e9, mean = 0.0, deviation = 0.0;
};
Statistics statistics(const SupportHeights& field) {
    Statistics result;
    double sum_of_squares = 0.0;
    for (int y = 0; y < field.shape().height; ++y) {
        for (int x = 0; x < field.shape().width; ++x) {
            const double height = field.at(x, y);
            result.least = std::min(result.least, height);
            result.most = std::max(result.most, height);
            result.mean += height;
            sum_of_squares += height * height;
        }
    }
    const double count = static_cast<double>(field.shape().width) * field.shape().height;
    result.mean /= count;
    result.deviation = std::sqrt(sum_of_squares / count - result.mean * result.mean);
    return result;
}

/// Mean over a block of cells.
double block_mean(const SupportHeights& field, int x0, int y0, int size) {
    double sum = 0.0;
    for (int y = y0; y < y0 + size; ++y) {
        for (int x = x0; x < x0 + size; ++x)
            sum += field.at(x, y);
    }
    return sum / (size * size);
}

TEST_P(EverySupport, StaysWithinItsReliefAndUsesMostOfIt) {
    const SupportHeights field = named_support(GetParam().name, {300, 200}, 0.1, 0.0, pool);
    const Statistics heights = statistics(field);
    EXPECT_GE(heights.least, 0.0);
    EXPECT_LE(heights.most, GetParam().relief_mm);
    EXPECT_GT(heights.most - heights.least, 0.6 * GetParam().relief_mm);
    EXPECT_GT(heights.deviation, GetParam().least_roughness_mm);
}

TEST_P(EverySupport, HeightsAreWholeQuanta) {
    const SupportHeights field = named_support(GetParam().name, {90, 80}, 0.25, 0.0, pool);
    for (int y = 0; y < 80; ++y) {
        for (int x = 0; x < 90; ++x) {
            const double quanta = field.at(x, y) / kSupportQuantum_mm;
            ASSERT_EQ(quanta, std::floor(quanta)) << x << ", " << y;
        }
    }
}

TEST_P(EverySupport, CoarseCellsAreTheMeansOfFineOnes) {
    constexpr int kRatio = 5;
    const double fine_mm = GetParam().fine_mm;
    const SupportHeights fine =
        named_support(GetParam().name, {40 * kRatio, 30 * kRatio}, fine_mm, 0.0, pool);
    const SupportHeights coarse = named_support(GetParam().name, {40, 30}, fine_mm * kRatio, 0.0, pool);
    double largest = 0.0;
    double sum_of_squares = 0.0;
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
            const double error = coarse.at(x, y) - block_mean(fine, kRatio * x, kRatio * y, kRatio);
            largest = std::max(largest, std::abs(error));
            sum_of_squares += error * error;
        }
    }
    // Each cell is sampled a few times along each side: threads have edges, so single cells come out
    // within a tenth of the relief, the average cell within a fiftieth.
    EXPECT_LT(largest, 0.1 * GetParam().relief_mm);
    EXPECT_LT(std::sqrt(sum_of_squares / (40 * 30)), 0.02 * GetParam().relief_mm);
}

TEST_P(EverySupport, ALargerCanvasHoldsTheSameCloth) {
    const SupportHeights small = named_support(GetParam().name, {60, 50}, 0.25, 0.0, pool);
    const SupportHeights large = named_support(GetParam().name, {130, 90}, 0.25, 0.0, pool);
    for (int y = 0; y < 50; ++y) {
        for (int x = 0; x < 60; ++x)
            ASSERT_EQ(small.at(x, y), large.at(x, y)) << x << ", " << y;
    }
}

TEST_P(EverySupport, TheReliefCanBeChosen) {
    const Statistics own = statistics(named_support(GetParam().name, {120, 120}, 0.1, 0.0, pool));
    const Statistics doubled =
        statistics(named_support(GetParam().name, {120, 120}, 0.1, 2.0 * GetParam().relief_mm, pool));
    // Both are rounded down to levels.
    const double level_mm = finest_level_mm(2.0 * GetParam().relief_mm);
    EXPECT_NEAR(doubled.mean, 2.0 * own.mean, 2.0 * level_mm);
    EXPECT_NEAR(doubled.most, 2.0 * own.most, 2.0 * level_mm);
}

TEST_P(EverySupport, IsTheSameOnAnyNumberOfThreads) {
    pastoso::core::ThreadPool alone(1);
    // Five bands of rows, the last of them cut off.
    const SupportHeights field = named_support(GetParam().name, {70, 1100}, 0.1, 0.0, pool);
    const SupportHeights other = named_support(GetParam().name, {70, 1100}, 0.1, 0.0, alone);
    for (int y = 0; y < 1100; ++y)
        for (int x = 0; x < 70; ++x)
            ASSERT_EQ(field.at(x, y), other.at(x, y)) << x << ", " << y;
}

/// Paintings lie on what was made before; the files hold its name alone.
TEST_P(EverySupport, IsWhatItAlwaysWas) {
    pastoso::core::Hash64 hash;
    for (const double cell_mm : {0.4, 0.25, 0.125, 1.0 / 16, 1.0 / 40}) {
        for (const ClothPlace place : {ClothPlace{0, 0}, ClothPlace{-1370, 20911}}) {
            const SupportHeights field = named_support(GetParam().name, {333, 270}, cell_mm, 0.0, pool,
                                                       SupportForm::Levels, place);
            for (int y = 0; y < field.shape().height; ++y)
                for (int x = 0; x < field.shape().width; ++x)
                    hash.add_value(field.at(x, y));
        }
    }
    EXPECT_EQ(hash.value(), GetParam().heights);
}

TEST_P(EverySupport, TakesTwoBytesACell) {
    const SupportHeights field = named_support(GetParam().name, {128, 128}, 0.1, 0.0, pool);
    EXPECT_EQ(field.allocated_bytes(), 2U * 128U * 128U);
}

TEST_P(EverySupport, IsTheSameInTheFineFormUpToALevel) {
    const SupportHeights levels = named_support(GetParam().name, {70, 90}, 0.1, 0.0, pool);
    const SupportHeights fine =
        named_support(GetParam().name, {70, 90}, 0.1, 0.0, pool, SupportForm::Fine);
    EXPECT_FALSE(fine.block(0).in_levels());
    const double level_mm = finest_level_mm(GetParam().relief_mm);
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 70; ++x)
            ASSERT_EQ(std::floor(fine.at(x, y) / level_mm) * level_mm, levels.at(x, y))
                << x << ", " << y;
}

INSTANTIATE_TEST_SUITE_P(
    Supports, EverySupport,
    testing::Values(NamedSupport{"linen", 0.11, 0.01, 0x74afa3f762c3894dU},
                    NamedSupport{"cotton duck", 0.08, 0.007, 0xea322cb7c22f0cb1U},
                    NamedSupport{"panel", 0.02, 0.002, 0xfdd470874490e74dU},
                    NamedSupport{"fine portrait linen", 0.06, 0.005, 0x9f1a18f7fad7e595U, 0.02},
                    NamedSupport{"medium linen", 0.11, 0.01, 0x3f59b3e32b7d93c0U, 0.02},
                    NamedSupport{"rough jute", 0.34, 0.03, 0x2d201f30eb678deU},
                    NamedSupport{"gesso panel", 0.06, 0.005, 0x1d4f95e6287d7fU}),
    [](const auto& support) {
        std::string name = support.param.name;
        std::replace(name.begin(), name.end(), ' ', '_');
        return name;
    });

TEST(WovenSupport, ARegularWeaveRepeatsAfterTwoThreads) {
    const Weave weave{.thread_pitch_mm = 0.8, .relief_mm = 0.1, .irregularity = 0.0};
    const SupportHeights field = woven_support({96, 96}, 0.1, weave, pool);  // 8 cells a thread
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            // The places are sums of floats, rounded to 1e-6 of a thread, which moves heights by quanta.
            ASSERT_NEAR(field.at(x, y), field.at(x + 16, y), 4 * kSupportQuantum_mm) << x << ", " << y;
            ASSERT_NEAR(field.at(x, y), field.at(x, y + 16), 4 * kSupportQuantum_mm) << x << ", " << y;
            ASSERT_NEAR(field.at(x, y), field.at(x + 8, y + 8), 4 * kSupportQuantum_mm)
                << x << ", " << y;
        }
    }
}

TEST(WovenSupport, ThreadsPassOverAndUnderInTurn) {
    const Weave weave{.thread_pitch_mm = 1.6, .relief_mm = 0.1, .irregularity = 0.0};
    const SupportHeights field = woven_support({64, 64}, 0.1, weave, pool);  // crossings at 8 + 16 k
    // On the centre line of a warp thread, half way to the edge of a crossing: a warp thread on top is
    // level along y and round along x; below, the other way round.
    const auto falls_along_x = [&](int x, int y) {
        return field.at(x, y) - field.at(x + 5, y) > field.at(x, y) - field.at(x, y + 5);
    };
    EXPECT_NE(falls_along_x(24, 24), falls_along_x(40, 24));
    EXPECT_NE(falls_along_x(24, 24), falls_along_x(24, 40));
    EXPECT_EQ(falls_along_x(24, 24), falls_along_x(40, 40));
}

TEST(WovenSupport, IrregularThreadsDoNotRepeat) {
    const Weave weave{.thread_pitch_mm = 0.8, .relief_mm = 0.1};
    const SupportHeights field = woven_support({96, 96}, 0.1, weave, pool);
    double sum_of_squares = 0.0;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const double change = field.at(x, y) - field.at(x + 16, y + 16);
            sum_of_squares += change * change;
        }
    }
    EXPECT_GT(std::sqrt(sum_of_squares / (64 * 64)), 0.05 * weave.relief_mm);
}

TEST(ImageSupport, BlackIsZeroAndWhiteIsTheRelief) {
    const SupportHeights black = image_support({20, 10}, std::vector<float>(6, 0.0F), 3, 2, 0.5, pool);
    const SupportHeights white = image_support({20, 10}, std::vector<float>(6, 1.0F), 3, 2, 0.5, pool);
    EXPECT_EQ(statistics(black).most, 0.0);
    // The spline's weights add to 1 within a float's rounding.
    EXPECT_NEAR(statistics(white).least, 0.5, 2 * finest_level_mm(0.5));
    EXPECT_LE(statistics(white).most, 0.5);
}

TEST(ImageSupport, ARampStaysARamp) {
    std::vector<float> grey(16 * 4);
    for (int i = 0; i < 64; ++i)
        grey[i] = static_cast<float>(i % 16) / 15.0F;
    const SupportHeights field = image_support({64, 16}, grey, 16, 4, 1.5, pool);
    // Away from the ends: a pixel's grey is the ramp's height at its centre, 4 cells a pixel, 0.1 a
    // pixel.
    for (int x = 16; x < 48; ++x)
        EXPECT_NEAR(field.at(x, 8), 0.1 * ((x + 0.5) / 4.0 - 0.5), finest_level_mm(1.5)) << x;
}

TEST(ImageSupport, SmallerCanvasesHoldThePixelsMeans) {
    // A checkerboard of single pixels, ten to a cell, is a mean grey.
    std::vector<float> grey(400 * 400);
    for (int i = 0; i < 400 * 400; ++i)
        grey[i] = static_cast<float>((i % 400 + i / 400) % 2);
    const SupportHeights field = image_support({40, 40}, grey, 400, 400, 1.0, pool);
    for (int i = 2; i < 38; ++i)
        EXPECT_NEAR(field.at(i, 20), 0.5, 1e-3);
}

TEST(ImageSupport, IsMirroredWithItsImage) {
    const std::vector<float> grey = {0.0F, 0.2F, 0.9F, 0.4F, 0.1F, 0.7F};
    std::vector<float> mirrored = grey;
    std::reverse(mirrored.begin(), mirrored.end());
    const SupportHeights field = image_support({30, 20}, grey, 3, 2, 1.0, pool);
    const SupportHeights other = image_support({30, 20}, mirrored, 3, 2, 1.0, pool);
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 30; ++x)
            EXPECT_NEAR(field.at(x, y), other.at(29 - x, 19 - y), finest_level_mm(1.0));
    }
}

TEST(WeaveKernels, GiveTheSameBitsInEveryInstructionSet) {
    constexpr int kCount = 200, kBeyond = 16;
    std::vector<std::vector<float>> columns;
    const auto column = [&](float least, float most) {
        columns.emplace_back(kCount + kBeyond);
        const auto stream = static_cast<std::uint32_t>(columns.size());
        for (std::uint32_t k = 0; k < kCount + kBeyond; ++k)
            columns.back()[k] = least + (most - least) * pastoso::core::uniform_noise(k, stream);
        return columns.back().data();
    };
    const auto sections = [&](float place) {
        return SectionColumns{column(place - 0.2F, place + 0.2F), column(0.3F, 0.6F),
                              column(0.6F, 1.0F)};
    };
    ClothLine line{.count = kCount, .u = column(4.4F, 5.6F), .v = 7.3F};
    line.warp_before = sections(4.5F);
    line.warp_after = sections(5.5F);
    const std::vector<float> parity(kCount + kBeyond, -1.0F);
    line.warp_parity = parity.data();
    for (int i = 0; i < kWeftsNear; ++i)
        line.weft[i] = sections(5.5F + static_cast<float>(i));
    line.fibres_above = column(0.0F, 1.0F);
    line.fibres_below = column(0.0F, 1.0F);
    line.fibres_share = 0.3F;
    using pastoso::core::Isa;
    for (const float fine : {0.0F, 0.15F}) {
        line.twist = line.nap = fine;
        line.shown = 1.0F - fine;
        std::vector<float> expected(kCount + kBeyond);
        WeaveKernels::baseline.cloth_heights(line, expected.data());
        for (const Isa isa : {Isa::Avx2, Isa::Avx512}) {
            if (isa > pastoso::core::best_isa()) continue;
            std::vector<float> found(kCount + kBeyond);
            pastoso::core::kernels<WeaveKernels>(isa).cloth_heights(line, found.data());
            for (int k = 0; k < kCount; ++k)
                ASSERT_EQ(found[k], expected[k]) << pastoso::core::name_of(isa) << ", column " << k;
        }
    }
}

/// Where lines cross the marks, and where they go along them.
struct GessoPlaces {
    static constexpr int kCount = 1000, kBeyond = 16;
    std::vector<double> columns_mm;
    std::vector<std::uint32_t> before[4];
    std::vector<float> share[4];

    explicit GessoPlaces(std::vector<double> at_mm) : columns_mm(std::move(at_mm)) {}

    NoiseColumns of(int which, double width_mm) {
        for (const double at_mm : columns_mm) {
            const NoisePlace place = noise_place(at_mm / width_mm);
            before[which].push_back(place.before);
            share[which].push_back(place.share);
        }
        return {before[which].data(), share[which].data()};
    }
};

/// The relief of gesso as its equation has it.
float gesso_height(double along_mm, double across_mm) {
    const auto noise = [&](const GessoNoise& of, double at_mm) {
        return smooth_noise(along_mm / of.along_mm, at_mm / of.across_mm, of.stream);
    };
    const double drifted_mm = across_mm + kGessoDrift_mm * noise(kGessoDrift, across_mm);
    return 0.4F * noise(kBroadMarks, drifted_mm) + 0.4F * noise(kFineMarks, drifted_mm) +
           0.2F * noise(kGessoGrain, across_mm);
}

TEST(GessoKernels, GiveTheReliefToTheBitInEveryInstructionSet) {
    // On both sides of 0, near and far.
    const auto column_mm = [](int k) {
        return (k % 7 == 0 ? 700.0 : 9.0) *
               (pastoso::core::uniform_noise(static_cast<std::uint32_t>(k), 1) - 0.5);
    };
    std::vector<double> columns_mm;
    for (int k = 0; k < GessoPlaces::kCount + GessoPlaces::kBeyond; ++k)
        columns_mm.push_back(column_mm(k));
    using pastoso::core::Isa;
    for (const double line_mm : {-313.3, -0.01, 0.0, 77.7}) {
        for (const bool along_marks : {true, false}) {
            GessoPlaces along(along_marks ? columns_mm : std::vector<double>{line_mm}),
                across(along_marks ? std::vector<double>{line_mm} : columns_mm);
            const GessoLine line{.count = GessoPlaces::kCount,
                                 .drift_along = along.of(0, kGessoDrift.along_mm),
                                 .broad_along = along.of(1, kBroadMarks.along_mm),
                                 .fine_along = along.of(2, kFineMarks.along_mm),
                                 .grain_along = along.of(3, kGessoGrain.along_mm),
                                 .drift_across = across.of(0, kGessoDrift.across_mm),
                                 .grain_across = across.of(1, kGessoGrain.across_mm),
                                 .across_mm = across.columns_mm.data()};
            for (const Isa isa : {Isa::Baseline, Isa::Avx2, Isa::Avx512}) {
                if (isa > pastoso::core::best_isa()) continue;
                std::vector<float> found(columns_mm.size());
                const auto& kernels = pastoso::core::kernels<GessoKernels>(isa);
                (along_marks ? kernels.along_marks : kernels.across_marks)(line, found.data());
                for (int k = 0; k < GessoPlaces::kCount; ++k)
                    ASSERT_EQ(found[k], along_marks ? gesso_height(columns_mm[k], line_mm)
                                                    : gesso_height(line_mm, columns_mm[k]))
                        << pastoso::core::name_of(isa) << ", column " << k << ", along marks "
                        << along_marks << ", line at " << line_mm << " mm";
            }
        }
    }
}

/// Crowns that a line through a cloth goes over, in a millimetre.
double crowns_per_mm(const SupportHeights& field, int step_x, int step_y, double cell_mm) {
    const int length = 900, lines = 40;
    int crowns = 0;
    for (int line = 1; line <= lines; ++line) {
        const auto height = [&](int i) {
            return field.at(step_x > 0 ? i : 23 * line, step_y > 0 ? i : 23 * line);
        };
        for (int i = 4; i + 4 < length; ++i) {
            bool highest = true;
            for (int k = 1; k <= 4; ++k)
                highest = highest && height(i) > height(i - k) && height(i) >= height(i + k);
            crowns += highest ? 1 : 0;
        }
    }
    return crowns / (lines * length * cell_mm);
}

TEST(Linen, HasAnotherCountOfWarpThanOfWeft) {
    const double cell_mm = 1.0 / 16.0;
    const SupportHeights field = named_support("medium linen", {1000, 1000}, cell_mm, 0.0, pool);
    const double across_warp = crowns_per_mm(field, 1, 0, cell_mm),
                 across_weft = crowns_per_mm(field, 0, 1, cell_mm);
    EXPECT_GT(across_warp / across_weft, 1.05);
    EXPECT_LT(across_warp / across_weft, 1.25);
}

TEST(Linen, FinerThanTwoCellsIsItsMean) {
    const SupportHeights fine = named_support("fine portrait linen", {800, 800}, 1.0 / 16, 0.0, pool),
                         coarse = named_support("fine portrait linen", {200, 200}, 0.25, 0.0, pool);
    const Statistics shown = statistics(fine), averaged = statistics(coarse);
    EXPECT_LT(averaged.deviation, 0.15 * shown.deviation) << "no lattice, but drift and slubs: 12 %";
    EXPECT_GT(averaged.deviation, 0.05 * shown.deviation);
    EXPECT_NEAR(averaged.mean, shown.mean, 0.1 * shown.mean);
}

TEST(Linen, HasSlubsOfSomeMillimetresThatAreFew) {
    Weave smooth{.thread_pitch_mm = 1.0, .relief_mm = 1.0, .irregularity = 0.0};
    Weave slubbed = smooth;
    slubbed.slubs_per_m = 0.5;
    const Shape shape{1600, 1600};  // a dm2
    const SupportHeights cloth = woven_support(shape, 1.0 / 16, slubbed, pool),
                         plain = woven_support(shape, 1.0 / 16, smooth, pool);
    int raised = 0;
    for (int y = 0; y < shape.height; ++y)
        for (int x = 0; x < shape.width; ++x)
            // Threads of middle width are lower where there are slubs to stand out.
            raised += cloth.at(x, y) > 0.76 / 0.86 * plain.at(x, y) + 0.05 ? 1 : 0;
    const double share = raised / 2.56e6;
    EXPECT_GT(share, 0.001);
    EXPECT_LT(share, 0.03) << "20 m of thread have 10 slubs of 22 mm";
}

TEST(NamedSupport, IgnoresCaseAndListsTheNames) {
    EXPECT_EQ(named_support("Cotton Duck", {8, 8}, 0.25, 0.0, pool).at(3, 3),
              named_support("cotton duck", {8, 8}, 0.25, 0.0, pool).at(3, 3));
    try {
        named_support("velvet", {8, 8}, 0.25, 0.0, pool);
        FAIL() << "no error";
    } catch (const pastoso::core::InputError& error) {
        EXPECT_STREQ(error.what(),
                     "There is no support \"velvet\"; the supports are: fine portrait linen, medium "
                     "linen, rough jute, linen, cotton duck, gesso panel, panel.");
    }
}

}  // namespace
