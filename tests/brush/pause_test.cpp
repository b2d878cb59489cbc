// A hand that rests, hurries or leaves: no jump, no blob, no line where the pen was not.
#include "brush/stroke.hpp"
#include "brush/studio.hpp"
#include "core/random.hpp"
#include "core/units.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

constexpr double kRate_Hz = 125.0;

/// A wave of 60 mm in a second.
PenSample wave(double time_s) {
    return {.time_s = time_s,
            .x_mm = 20.0 + 60.0 * time_s,
            .y_mm = 25.0 + 8.0 * std::sin(6.0 * time_s),
            .pressure = 0.5 * studio::fade(time_s),
            .rotation_deg = 74.5};
}

std::vector<PenSample> wave_samples(double rate_Hz) {
    std::vector<PenSample> samples;
    for (int i = 0; i <= static_cast<int>(rate_Hz); ++i)
        samples.push_back(wave(i / rate_Hz));
    return samples;
}

film::FilmState painted(const std::vector<PenSample>& samples, const Stabiliser& stabiliser = {}) {
    film::FilmState film = studio::linen(100.0, 50.0, 4.0);
    Brush brush(studio::flat_preset(14.0));
    brush.load(studio::dark_paint(), 1.0);
    Stroke stroke(brush, film, {.stabiliser = stabiliser});
    stroke.begin(samples.front());
    for (std::size_t i = 1; i < samples.size(); ++i)
        stroke.add(samples[i]);
    stroke.end();
    return film;
}

/// The same rules as for two event rates.
void expect_same_stroke(const film::FilmState& a, const film::FilmState& b) {
    EXPECT_NEAR(studio::volume_mm3(a) / studio::volume_mm3(b), 1.0, 1e-3);
    EXPECT_LT(studio::relative_difference(a, b, a.cell_mm), 0.01);
}

/// The wave with a rest of `pause_s` in the middle, told by so many samples or by none.
std::vector<PenSample> rested(double pause_s, int samples_of_rest) {
    std::vector<PenSample> samples = wave_samples(kRate_Hz);
    const std::size_t middle = samples.size() / 2;
    for (std::size_t i = middle + 1; i < samples.size(); ++i)
        samples[i].time_s += pause_s;
    std::vector<PenSample> rest(static_cast<std::size_t>(samples_of_rest), samples[middle]);
    for (int i = 0; i < samples_of_rest; ++i)
        rest[i].time_s += pause_s * (i + 1) / (samples_of_rest + 1);
    samples.insert(samples.begin() + static_cast<std::ptrdiff_t>(middle) + 1, rest.begin(), rest.end());
    return samples;
}

TEST(Pause, AGapInTimeChangesNothing) {
    const film::FilmState plain = painted(wave_samples(kRate_Hz));
    expect_same_stroke(plain, painted(rested(0.3, 0)));
    expect_same_stroke(plain, painted(rested(600.0, 0)));
}

TEST(Pause, APenHeldStillForMinutesChangesNothing) {
    const film::FilmState plain = painted(wave_samples(kRate_Hz));
    expect_same_stroke(plain, painted(rested(180.0, 22500)));
}

TEST(Pause, StampsThatComeInLumpsChangeLittle) {
    // A driver that hands over 8 events of 1000 Hz at a time, all with one stamp.
    std::vector<PenSample> lumps = wave_samples(1000.0);
    for (std::size_t i = 0; i < lumps.size(); ++i)
        lumps[i].time_s = 0.008 * std::ceil(static_cast<double>(i) / 8.0);
    expect_same_stroke(painted(wave_samples(1000.0)), painted(lumps));
}

TEST(Pause, AClockThatStandsStillMakesAStrokeAllTheSame) {
    std::vector<PenSample> stopped = wave_samples(1000.0);
    for (PenSample& sample : stopped)
        sample.time_s = 3.0;
    const film::FilmState film = painted(stopped), right = painted(wave_samples(1000.0));
    // Taken as 0.1 ms apart, the filter cuts the wave's bends by some mm: another way of like length.
    EXPECT_NEAR(studio::volume_mm3(film) / studio::volume_mm3(right), 1.0, 0.01);
    EXPECT_GT(studio::coverage(film, studio::cells_of(film, 74.0, 20.0, 78.0, 26.0)), 0.2);
}

class SteadiedRate : public testing::TestWithParam<Stabiliser> {};

TEST_P(SteadiedRate, AStormOfEventsChangesNothing) {
    const film::FilmState storm = painted(wave_samples(1000.0), GetParam());
    const film::FilmState slow = painted(wave_samples(125.0), GetParam());
    // A string goes taut between two events, which shifts the brush's steps by a part of one.
    const bool pulled = GetParam().string_mm > 0.0;
    EXPECT_NEAR(studio::volume_mm3(slow) / studio::volume_mm3(storm), 1.0, pulled ? 2e-3 : 1e-3);
    EXPECT_LT(studio::relative_difference(storm, slow, storm.cell_mm), pulled ? 0.03 : 0.01);
}

INSTANTIATE_TEST_SUITE_P(Stabilisers, SteadiedRate,
                         testing::Values(Stabiliser{80.0, 0.0}, Stabiliser{0.0, 4.0},
                                         Stabiliser{40.0, 3.0}));

double volume_of_rest(int samples, double tremor_mm) {
    film::FilmState film = studio::linen(40.0, 40.0, 4.0);
    Brush brush(find_preset("flat"));
    brush.load(studio::dark_paint(), 1.0);
    Stroke stroke(brush, film);
    stroke.begin({.x_mm = 20.0, .y_mm = 20.0, .pressure = 0.5});
    for (int i = 1; i <= samples; ++i) {
        const auto shake = [&](std::uint32_t stream) {
            return tremor_mm * (core::uniform_noise(static_cast<std::uint32_t>(i), stream) - 0.5);
        };
        stroke.add(
            {.time_s = 0.001 * i, .x_mm = 20.0 + shake(1), .y_mm = 20.0 + shake(2), .pressure = 0.5});
    }
    stroke.end();
    return studio::volume_mm3(film);
}

TEST(Pause, ATremblingRestMakesNoBlob) {
    const double tap_mm3 = volume_of_rest(0, 0.0);
    EXPECT_EQ(volume_of_rest(5000, 0.0), tap_mm3);
    // A pixel of noise at 1000 Hz settles the paint under the bristles, and then nothing more comes.
    const double trembled_mm3 = volume_of_rest(10000, 0.25);
    EXPECT_LT(trembled_mm3, 2.0 * tap_mm3);
    EXPECT_NEAR(volume_of_rest(20000, 0.25) / trembled_mm3, 1.0, 0.02);
}

TEST(Pause, ALiftAndATouchElsewhereAreNotJoined) {
    film::FilmState film = studio::linen(100.0, 50.0, 4.0);
    Brush brush(studio::flat_preset(8.0));
    brush.load(studio::dark_paint(), 1.0);
    const HandAids aids{.stabiliser = {300.0, 5.0}};
    for (const double x_mm : {15.0, 85.0}) {
        Stroke stroke(brush, film, aids);
        for (int i = 0; i <= 40; ++i) {
            const PenSample sample{
                .time_s = 0.01 * i, .x_mm = x_mm, .y_mm = 10.0 + 0.7 * i, .pressure = 0.5};
            if (i == 0)
                stroke.begin(sample);
            else
                stroke.add(sample);
        }
        stroke.end();
    }
    EXPECT_GT(studio::coverage(film, studio::cells_of(film, 13.0, 15.0, 17.0, 35.0)), 0.5);
    EXPECT_GT(studio::coverage(film, studio::cells_of(film, 83.0, 15.0, 87.0, 35.0)), 0.5);
    EXPECT_EQ(studio::coverage(film, studio::cells_of(film, 30.0, 0.0, 70.0, 50.0)), 0.0);
}

TEST(Pause, APenThatLeavesTheCanvasComesBackWhereItComesBack) {
    film::FilmState film = studio::linen(60.0, 60.0, 4.0);
    Brush brush(studio::flat_preset(6.0));
    brush.load(studio::dark_paint(), 1.0);
    studio::paint(brush, film, [](double t) {  // a half circle about the edge's middle, most of it off
        const double angle = core::kPi * (1.75 * t - 0.875) * 0.95;
        return PenSample{.x_mm = 62.0 + 22.0 * std::cos(angle),
                         .y_mm = 30.0 + 22.0 * std::sin(angle),
                         .pressure = 0.5,
                         .rotation_deg = core::degrees(angle)};
    });
    EXPECT_GT(studio::coverage(film, studio::cells_of(film, 42.0, 8.0, 58.0, 22.0)), 0.2);
    EXPECT_GT(studio::coverage(film, studio::cells_of(film, 42.0, 38.0, 58.0, 52.0)), 0.2);
    // Nothing on the chord along the edge, where the pen was not.
    EXPECT_EQ(studio::coverage(film, studio::cells_of(film, 52.0, 20.0, 60.0, 40.0)), 0.0);
}

}  // namespace
}  // namespace pastoso::brush
