#include "trace/denoise.hpp"

#include "core/isa.hpp"
#include "core/random.hpp"
#include "trace/denoise_kernel.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::trace {
namespace {

constexpr int kSide = 64;

/// About normal, with variance 1: the sum of twelve even numbers.
float noise_at(std::uint32_t place, std::uint32_t stream) {
    float sum = -6.0F;
    for (std::uint32_t i = 0; i < 12; ++i)
        sum += core::uniform_noise(place, stream * 12 + i);
    return sum;
}

/// `truth`(x, y) with independent noise in both halves, such that their mean has this deviation.
template <class Truth>
NoisyPicture noisy_picture(const Truth& truth, float deviation) {
    NoisyPicture noisy{Picture(kSide, kSide), Picture(kSide, kSide), {}, {}};
    for (std::uint32_t i = 0; i < kSide * kSide; ++i)
        for (std::uint32_t k = 0; k < 3; ++k) {
            const float value = truth(static_cast<int>(i) % kSide, static_cast<int>(i) / kSide);
            const float half = deviation * std::sqrt(2.0F);
            noisy.even.rgb[3 * i + k] = value + half * noise_at(i, 2 * k);
            noisy.odd.rgb[3 * i + k] = value + half * noise_at(i, 2 * k + 1);
        }
    return noisy;
}

template <class Truth>
double rms_error(const Picture& picture, const Truth& truth) {
    double sum = 0.0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const double error = picture.at(x, y)[1] - truth(x, y);
            sum += error * error;
        }
    return std::sqrt(sum / (kSide * kSide));
}

TEST(Denoise, AConstantPictureStays) {
    core::ThreadPool pool(1);
    const auto truth = [](int, int) { return 0.4F; };
    for (const float value : denoise(noisy_picture(truth, 0.0F), pool).rgb)
        EXPECT_NEAR(value, 0.4F, 4e-6F);  // sums of 225 weights, twice, and a square
}

TEST(Denoise, NoiseOfASmoothPictureFallsToAThirdOrLess) {
    core::ThreadPool pool(1);
    const auto truth = [](int x, int y) {
        return 0.5F + 0.002F * static_cast<float>(x) - 0.001F * static_cast<float>(y);
    };
    const double before = 0.04;
    const Picture picture = denoise(noisy_picture(truth, 0.04F), pool);
    // A mean over a window of 15 x 15 could reach a fifteenth.
    EXPECT_LT(rms_error(picture, truth), before / 3.0);
    double sum = 0.0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            sum += static_cast<double>(picture.at(x, y)[1]) - static_cast<double>(truth(x, y));
    EXPECT_NEAR(sum / (kSide * kSide), 0.0, 0.002);  // the brightness stays, but for the roots' curve
}

TEST(Denoise, AHardEdgeStaysHard) {
    core::ThreadPool pool(1);
    const auto truth = [](int x, int) { return x < kSide / 2 ? 0.2F : 0.8F; };
    const Picture picture = denoise(noisy_picture(truth, 0.03F), pool);
    for (int y = 0; y < kSide; ++y) {
        // Ten deviations of the noise: a smeared edge would be off by 0.3.
        EXPECT_NEAR(picture.at(kSide / 2 - 1, y)[1], 0.2F, 0.1F);
        EXPECT_NEAR(picture.at(kSide / 2, y)[1], 0.8F, 0.1F);
    }
    EXPECT_LT(rms_error(picture, truth), 0.03 / 2.0);
}

TEST(Denoise, WhatFeaturesTellApartIsNotMixed) {
    core::ThreadPool pool(1);
    const auto truth = [](int x, int) { return x < kSide / 2 ? 0.50F : 0.53F; };
    NoisyPicture noisy = noisy_picture(truth, 0.05F);
    const double without = rms_error(denoise(noisy, pool), truth);
    noisy.even_features.assign(kSide * kSide * kFeatures, 0.0F);
    for (int i = 0; i < kSide * kSide; ++i)
        noisy.even_features[static_cast<std::size_t>(i * kFeatures)] =
            i % kSide < kSide / 2 ? 0.0F : 1.0F;
    noisy.odd_features = noisy.even_features;
    EXPECT_LT(rms_error(denoise(noisy, pool), truth), without);
}

TEST(Denoise, SmallAndEmptyPicturesWork) {
    core::ThreadPool pool(1);
    EXPECT_TRUE(denoise({}, pool).rgb.empty());
    for (const int width : {1, 3}) {
        NoisyPicture noisy{Picture(width, 2), Picture(width, 2), {}, {}};
        noisy.even.rgb.assign(noisy.even.rgb.size(), 0.25F);
        noisy.odd.rgb = noisy.even.rgb;
        EXPECT_EQ(denoise(noisy, pool).rgb, noisy.even.rgb);
    }
}

TEST(Denoise, EveryInstructionSetGivesTheSameBits) {
    constexpr int kStride = kSide + 2 * kMargin;
    std::vector<float> guide(kStride * kStride), noise(guide.size(), 0.002F);
    for (std::uint32_t i = 0; i < guide.size(); ++i)
        guide[i] = 0.5F + 0.05F * noise_at(i, 1);
    const std::size_t start = kMargin * kStride + kMargin;
    const auto averaged = [&](core::Isa isa) {
        std::vector<float> out(guide.size());
        AverageJob job{};
        job.width = job.height = kSide;
        job.stride = kStride;
        job.first_row = 8, job.last_row = 8 + kBandRows;
        job.guide.fill(guide.data() + start);
        job.guide_noise = noise.data() + start;
        job.features[0] = guide.data() + start;
        job.feature_noise[0] = noise.data() + start;
        job.feature_count = 1;
        job.colour_scale = 1.0F, job.feature_scale = 2.0F, job.guide_floor = 1e-6F;
        job.averaged = 1;
        job.in[0] = guide.data() + start;
        job.out[0] = out.data() + start;
        std::vector<float> scratch(average_scratch(kSide));
        core::kernels<DenoiseKernels>(isa).average_rows(job, scratch.data());
        return out;
    };
    const std::vector<float> baseline = averaged(core::Isa::Baseline);
    for (const core::Isa isa : {core::Isa::Avx2, core::Isa::Avx512}) {
        if (isa > core::best_isa()) continue;
        EXPECT_EQ(averaged(isa), baseline);
    }
}

}  // namespace
}  // namespace pastoso::trace
