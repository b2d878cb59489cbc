#include "trace/numbers.hpp"

#include "trace/optics.hpp"
#include "trace/sampler.hpp"

#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

namespace pastoso::trace {
namespace {

// The tolerances here are those that the headers state: a few roundings of single precision.
TEST(Numbers, TheExponentialIsThatOfTheLibrary) {
    for (int i = -8600; i <= 8800; ++i) {
        const float x = static_cast<float>(i) * 0.01F;
        const double exact = std::exp(static_cast<double>(x));
        EXPECT_NEAR(fast_exp(x), exact, 3e-7 * exact) << x;
    }
    EXPECT_EQ(fast_exp(-1000.0F), 0.0F);
    EXPECT_EQ(fast_exp(0.0F), 1.0F);
}

TEST(Numbers, TheLogarithmIsThatOfTheLibrary) {
    for (double x = 1e-30; x < 1e30; x *= 1.07) {
        const auto value = static_cast<float>(x);
        const double exact = std::log(static_cast<double>(value));
        EXPECT_NEAR(fast_log(value), exact, 2e-7 * (1.0 + std::abs(exact))) << x;
    }
    EXPECT_EQ(fast_log(1.0F), 0.0F);
}

TEST(Numbers, CosineAndSineAreThoseOfTheLibrary) {
    for (int i = 0; i <= 4096; ++i) {
        const float turns = static_cast<float>(i) / 4096.0F;
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(turns);
        EXPECT_NEAR(cos_sin_of_turns(turns).x, std::cos(angle), 4e-7) << turns;
        EXPECT_NEAR(cos_sin_of_turns(turns).y, std::sin(angle), 4e-7) << turns;
    }
}

TEST(Numbers, AFrameIsRightHanded) {
    for (const glm::vec3 way : {glm::vec3(0, 0, 1), glm::vec3(0, 0, -1), glm::vec3(0.3F, -0.5F, 0.1F)}) {
        const glm::vec3 n = glm::normalize(way);
        const Frame frame(n);
        EXPECT_NEAR(glm::distance(glm::cross(frame.u, frame.v), n), 0.0F, 1e-6F);
        EXPECT_NEAR(glm::length(frame.u), 1.0F, 1e-6F);
    }
}

TEST(Optics, FresnelsEquationsAtKnownAngles) {
    EXPECT_NEAR(fresnel_reflectance(1.0F, 1.0F, 1.5F), 0.04F, 1e-6F);
    EXPECT_NEAR(fresnel_reflectance(1.0F, 1.5F, 1.0F), 0.04F, 1e-6F);
    EXPECT_NEAR(fresnel_reflectance(0.0F, 1.0F, 1.5F), 1.0F, 1e-6F);
    // At Brewster's angle only light across the plane of incidence is reflected: half of R_s, where
    // R_s = ((1 - n^2) / (1 + n^2))^2.
    const float n = 1.335F, cosine = 1.0F / std::sqrt(1.0F + n * n);
    const float across = (1.0F - n * n) / (1.0F + n * n);
    EXPECT_NEAR(fresnel_reflectance(cosine, 1.0F, n), 0.5F * across * across, 1e-6F);
}

TEST(Optics, LightIsTotallyReflectedBeyondTheCriticalAngle) {
    const float critical_sine = 1.0F / 1.5F;
    const auto cosine_at = [&](float sine) { return std::sqrt(1.0F - sine * sine); };
    EXPECT_EQ(fresnel_reflectance(cosine_at(critical_sine * 1.001F), 1.5F, 1.0F), 1.0F);
    EXPECT_LT(fresnel_reflectance(cosine_at(critical_sine * 0.999F), 1.5F, 1.0F), 0.9F);
}

TEST(Optics, RefractionKeepsSnellsLawAndComesBack) {
    const glm::vec3 normal(0.0F, 0.0F, 1.0F);
    const glm::vec3 down = glm::normalize(glm::vec3(0.7F, 0.0F, -0.6F));
    const glm::vec3 inside = refracted(down, normal, 1.0F / 1.5F);
    EXPECT_NEAR(inside.x * 1.5F, down.x, 1e-6F);
    EXPECT_NEAR(glm::distance(refracted(inside, normal, 1.5F), down), 0.0F, 1e-6F);
    EXPECT_NEAR(glm::distance(reflected(down, normal), glm::vec3(down.x, 0.0F, -down.z)), 0.0F, 1e-6F);
}

TEST(Sampler, TheFirstPairsAreSpreadEvenlyOverPowersOfTwo) {
    // Sixteen points of a (0, 2) sequence: one in each of sixteen equal boxes of every shape.
    for (const int columns : {1, 2, 4, 8, 16}) {
        std::set<int> boxes;
        for (std::uint32_t sample = 0; sample < 16; ++sample) {
            Sampler sampler(7, 12345, sample);
            const glm::vec2 pair = sampler.pair();
            boxes.insert(static_cast<int>(pair.x * static_cast<float>(columns)) * 16 +
                         static_cast<int>(pair.y * static_cast<float>(16 / columns)));
        }
        EXPECT_EQ(boxes.size(), 16U) << columns;
    }
}

TEST(Sampler, NumbersFollowFromSeedPixelAndSampleAlone) {
    Sampler first(1, 2, 3), again(1, 2, 3), other(1, 2, 4);
    bool differs = false;
    for (int i = 0; i < 20; ++i) {
        const glm::vec2 pair = first.pair();
        EXPECT_EQ(pair, again.pair());
        differs = differs || pair != other.pair();
    }
    EXPECT_TRUE(differs);
}

TEST(Sampler, TheStreamHasTheMomentsOfEvenNumbers) {
    double sum = 0.0, squares = 0.0;
    constexpr int kCount = 100000;
    for (std::uint32_t pixel = 0; pixel < kCount / 100; ++pixel) {
        Sampler sampler(5, pixel, 0);
        for (int i = 0; i < 100; ++i) {
            const double value = sampler.next();
            sum += value, squares += value * value;
        }
    }
    // Five standard errors: sqrt(1/12 / N) and sqrt(4/45 / N).
    EXPECT_NEAR(sum / kCount, 0.5, 5.0 * std::sqrt(1.0 / 12.0 / kCount));
    EXPECT_NEAR(squares / kCount, 1.0 / 3.0, 5.0 * std::sqrt(4.0 / 45.0 / kCount));
}

}  // namespace
}  // namespace pastoso::trace
