#include "trace/tracer.hpp"

#include "core/error.hpp"
#include "trace/approved_glass.hpp"
#include "trace/scenes.hpp"
#include "trace/tile_errors.hpp"

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::trace {
namespace {

Picture traced(const Scene& scene, const TraceSettings& settings, int samples) {
    core::ThreadPool pool(1);
    PathTracer tracer(scene, settings, pool);
    tracer.add_samples(samples);
    return tracer.radiance();
}

/// Mean and standard error of the green of all pixels, from pictures of independent seeds.
struct Estimate {
    double mean, error;
};
Estimate estimate(const Scene& scene, TraceSettings settings, int samples, int seeds) {
    double sum = 0.0, squares = 0.0;
    for (int seed = 1; seed <= seeds; ++seed) {
        settings.seed = static_cast<std::uint32_t>(seed);
        const double mean = tests::mean_of(traced(scene, settings, samples));
        sum += mean, squares += mean * mean;
    }
    const double mean = sum / seeds;
    return {mean, std::sqrt(std::max(0.0, squares / seeds - mean * mean) / (seeds - 1))};
}

/// The camera close to milk in air on a table, without glass that gathers light.
Scene milk_on_a_table() {
    Scene scene;
    scene.cup.reset();
    tests::add_ball(scene.milk, {0.0F, 0.0F, 0.02F}, 0.02F);
    scene.camera.eye_m = {0.0F, -0.2F, 0.1F};
    scene.camera.target_m = {0.0F, 0.0F, 0.01F};
    return scene;
}

TEST(PathTracer, InAFurnaceWithoutLossesEverythingIsAsBrightAsTheSky) {
    Scene scene = tests::busy_glass();
    tests::put_into_furnace(scene);
    TraceSettings settings = tests::small_picture(12);
    settings.most_events = 100000;
    EXPECT_NEAR(tests::mean_of(traced(scene, settings, 16)), 1.0, 0.01);  // photons are noisy
    settings.seeks_lamp = false;
    const Picture picture = traced(scene, settings, 4);
    // Every path has weight 1 until it reaches the sky; rounding of thousands of events alone. A
    // ray that enters glass or milk through a corner by rounding is allowed for by the mean.
    EXPECT_NEAR(tests::mean_of(picture), 1.0, 2e-3);
    for (const float value : picture.rgb)
        EXPECT_LT(value, 1.001F);
}

TEST(PathTracer, SeekingTheLampGivesTheSameMeanWhereNoGlassGathersLight) {
    Scene scene = milk_on_a_table();
    scene.milk_share = {};
    TraceSettings settings = tests::small_picture(16);
    settings.brightest = 1e6F;
    const Estimate seeking = estimate(scene, settings, 8, 6);
    settings.seeks_lamp = false;
    const Estimate reference = estimate(scene, settings, 96, 6);
    // Five standard errors of the difference; the errors are themselves known to about a third.
    EXPECT_NEAR(seeking.mean, reference.mean, 5.0 * std::hypot(seeking.error, reference.error));
    EXPECT_LT(reference.error, 0.02 * reference.mean);
}

void expect_bits_of_one_pass(const std::vector<int>& passes) {
    const int all = std::accumulate(passes.begin(), passes.end(), 0);
    const Scene scene = tests::busy_glass();
    core::ThreadPool pool(1);
    PathTracer at_once(scene, tests::small_picture(24), pool);
    PathTracer in_passes(scene, tests::small_picture(24), pool);
    at_once.add_samples(all);
    for (const int count : passes)
        in_passes.add_samples(count);
    EXPECT_EQ(at_once.radiance(), in_passes.radiance());
    EXPECT_EQ(at_once.denoised(), in_passes.denoised());
    EXPECT_EQ(at_once.rays(), in_passes.rays());
    EXPECT_EQ(in_passes.samples(), all);
}

TEST(PathTracer, PassesAddUpToTheBitsOfOnePass) {
    expect_bits_of_one_pass({1, 0, 4, 2});
}

TEST(PathTracer, LooksAtTilesDoNotDependOnPasses) {
    expect_bits_of_one_pass({15, 3, 9});
}

TEST(PathTracer, OutlinesGetSamplesBesidesAtALook) {
    core::ThreadPool pool(1);
    const auto rays = [&](const Scene& scene, int samples) {
        PathTracer tracer(scene, tests::small_picture(48), pool);
        tracer.add_samples(0);
        const std::uint64_t before = tracer.rays();
        tracer.add_samples(samples);
        return static_cast<double>(tracer.rays() - before) / samples;
    };
    // The first look comes after 16.
    EXPECT_GT(rays(tests::busy_glass(), 16), 1.1 * rays(tests::busy_glass(), 15));
    Scene bare;
    bare.cup.reset();
    EXPECT_NEAR(rays(bare, 16), rays(bare, 15), 0.02 * rays(bare, 15)) << "a table is even";
}

TEST(ErrorSums, AreTheRootMeanSquareOverTheMeanAndBlack) {
    ErrorSums sums;
    EXPECT_EQ(sums.error(), 0.0);
    sums.add(0.5, 0.3);
    sums.add(0.1, 0.5);
    // sqrt((0.04 + 0.16) / 2) / (0.7 + 0.05)
    EXPECT_NEAR(sums.error(), 0.4216, 1e-4);
    EXPECT_EQ(block_of(16 + 5, 32 + 11), 2 * kBlocksAcross + 1);
}

TEST(PathTracer, AStoppedPassIsMadeUpForByTheNext) {
    const Scene scene = tests::busy_glass();
    core::ThreadPool pool(1);
    PathTracer whole(scene, tests::small_picture(40), pool),
        stopped(scene, tests::small_picture(40), pool);
    EXPECT_TRUE(whole.add_samples(3));
    EXPECT_TRUE(stopped.add_samples(0));  // the photons are shot
    int tiles = 0;
    EXPECT_FALSE(stopped.add_samples(3, [&] { return ++tiles > 4; }));
    EXPECT_EQ(stopped.samples(), 0);
    EXPECT_GT(stopped.rays(), 0U);
    EXPECT_LT(stopped.rays(), whole.rays());
    // What is there is no darker than the finished picture.
    EXPECT_EQ(stopped.radiance().rgb[0], whole.radiance().rgb[0]);
    EXPECT_TRUE(stopped.add_samples(3));
    EXPECT_EQ(stopped.radiance(), whole.radiance());
    EXPECT_EQ(stopped.rays(), whole.rays());
}

TEST(PathTracer, AnotherSeedGivesOtherNoiseAboutTheSameMean) {
    const Scene scene = tests::busy_glass();
    TraceSettings settings = tests::small_picture(24);
    const Picture one = traced(scene, settings, 8);
    settings.seed = 2;
    const Picture other = traced(scene, settings, 8);
    EXPECT_NE(one, other);
    // Means over 24 x 24 pixels of some tens of percent noise each.
    EXPECT_NEAR(tests::mean_of(one), tests::mean_of(other), 0.02 * tests::mean_of(one));
}

TEST(PathTracer, AMirroredSceneGivesAMirroredPicture) {
    Scene scene = tests::busy_glass();
    scene.camera.eye_m.x = scene.camera.target_m.x = 0.05F;
    Scene mirrored = scene;
    mirrored.lamp->towards.x *= -1.0F;
    mirrored.sky.window_towards.x *= -1.0F;
    for (glm::vec3& position : mirrored.milk.positions_m)
        position.x = 0.1F - position.x;
    for (glm::vec3& normal : mirrored.milk.normals)
        normal.x *= -1.0F;
    for (auto& triangle : mirrored.milk.triangles)
        std::swap(triangle[1], triangle[2]);
    constexpr int kSide = 16, kBlock = 4;
    const Picture straight = traced(scene, tests::small_picture(kSide), 64);
    const Picture turned = traced(mirrored, tests::small_picture(kSide), 64);
    for (int y = 0; y < kSide; y += kBlock)
        for (int x = 0; x < kSide; x += kBlock) {
            double sum = 0.0, difference = 0.0;
            for (int b = 0; b < kBlock; ++b)
                for (int a = 0; a < kBlock; ++a) {
                    const float here = straight.at(x + a, y + b)[1];
                    const float there = turned.at(kSide - 1 - x - a, y + b)[1];
                    sum += here + there, difference += here - there;
                }
            // 16 pixels of 64 samples have noise of about 1 %.
            EXPECT_LT(std::abs(difference), 0.05 * sum) << x << " " << y;
        }
}

TEST(PathTracer, PlainTeaAndAnEmptyWorldAreTraced) {
    Scene plain;
    plain.milk_share = grid::BlockField(tests::even_milk(0.0F));
    EXPECT_GT(tests::mean_of(traced(plain, tests::small_picture(12), 2)), 0.1);
    Scene nothing;
    nothing.cup.reset();
    nothing.table.reset();
    nothing.lamp.reset();
    nothing.sky.below = nothing.sky.above = glm::vec3(0.25F);
    nothing.sky.window_radiance = glm::vec3(0.0F);
    for (const float value : traced(nothing, tests::small_picture(8), 3).rgb)
        EXPECT_NEAR(value, 0.25F, 1e-6F);
}

TEST(PathTracer, MoreMilkMakesTheTeaLighter) {
    Scene scene;
    scene.camera.field_of_view_deg = 4.0F;  // tea alone
    const double plain = tests::mean_of(traced(scene, tests::small_picture(8), 32));
    scene.milk_share = grid::BlockField(tests::even_milk(0.03F));
    const double cloudy = tests::mean_of(traced(scene, tests::small_picture(8), 32));
    EXPECT_GT(cloudy, 1.1 * plain);
}

void expect_refused(const Scene& scene, const TraceSettings& settings, const char* named) {
    core::ThreadPool pool(1);
    try {
        const PathTracer tracer(scene, settings, pool);
        ADD_FAILURE() << named << " was taken";
    } catch (const core::InputError& error) {
        EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
    }
}

TEST(PathTracer, NumbersOutOfRangeAreRefusedByName) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const TraceSettings settings = tests::small_picture(8);
    Scene scene;
    scene.camera.eye_m.y = nan;
    expect_refused(scene, settings, "camera eye is nan");
    scene = {};
    scene.camera.target_m = scene.camera.eye_m;
    expect_refused(scene, settings, "distance from eye to target");
    scene = {};
    scene.optics.glass_ior = 0.5F;
    expect_refused(scene, settings, "glass_ior");
    scene = {};
    grid::BoxField unknown = tests::even_milk(0.0F);
    unknown.at(3, 4, 5) = nan;
    scene.milk_share = grid::BlockField(unknown);
    expect_refused(scene, settings, "milk share");
    scene = {};
    tests::add_ball(scene.milk, glm::vec3(0.05F), 0.01F);
    scene.milk.triangles[5][1] = 100000;
    expect_refused(scene, settings, "milk's corner");
    scene = {};
    tests::add_ball(scene.milk, glm::vec3(0.05F), 0.01F);
    scene.milk.normals.pop_back();
    expect_refused(scene, settings, "number of normals");
    scene = {};
    scene.cup->level_m = 0.2F;
    expect_refused(scene, settings, "cup rim");
    scene = {};
    scene.lamp->towards = glm::vec3(0.0F);
    expect_refused(scene, settings, "lamp towards");
    expect_refused({}, tests::small_picture(0), "a side of the picture");
    TraceSettings dark = settings;
    dark.brightest = nan;
    expect_refused({}, dark, "brightest");
}

/// Means over 8 x 8 blocks of the tea picture's 64 x 64 pixels, 16 samples each, as they were when the
/// pictures were last looked at and approved. Same bits are not asked for, so that a better way to
/// sample may change the noise: a block's noise is below 2 %.
TEST(PathTracer, TheGlassLooksAsItDid) {
    const Picture picture = traced(tests::busy_glass(), tests::small_picture(64), 16);
    constexpr int kBlocks = 8;
    const auto& approved = tests::kApprovedGlass;
    for (int block = 0; block < kBlocks * kBlocks; ++block)
        for (int channel = 0; channel < 3; ++channel) {
            double sum = 0.0;
            for (int i = 0; i < 64; ++i)
                sum += picture.at(block % kBlocks * 8 + i % 8, block / kBlocks * 8 + i / 8)[channel];
            EXPECT_NEAR(sum / 64.0, approved[3 * block + channel],
                        0.01 + 0.05 * approved[3 * block + channel])
                << "block " << block << " channel " << channel;
        }
}

TEST(Toned, TheCurveKeepsBlackAndRisesToWhite) {
    Picture picture(3, 1);
    picture.rgb = {0.0F, -1.0F, 0.2F, 0.5F, 0.9F, 1.0F, 1.5F, 3.0F, 100.0F};
    const Picture shown = toned(picture);
    EXPECT_EQ(shown.rgb[0], 0.0F);
    EXPECT_EQ(shown.rgb[1], 0.0F);
    for (int i = 3; i < 9; ++i)
        EXPECT_GE(shown.rgb[i], shown.rgb[i - 1]);
    EXPECT_NEAR(shown.rgb[3], 1.25 * 0.475 * (1.0 + 0.12 * 0.475) / (1.0 + 0.55 * 0.475), 1e-6);
    EXPECT_EQ(shown.rgb[8], 1.0F);
}

}  // namespace
}  // namespace pastoso::trace
