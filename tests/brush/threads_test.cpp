// The same stroke on any number of threads: small, so that the thread sanitizer can run it.
#include "brush/stroke.hpp"
#include "brush/studio.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

struct Ground {
    const char* name;
    double wet_mm;  ///< thickness of the paint that lies there
    film::PaintCoefficients paint;
};

/// How a stroke ended.
struct Painted {
    film::FilmState film;
    std::vector<Contents> held;
    grid::Rect changed;
};

/// A wave, fast enough to plough and to drag, by a tip that stands across, aslant and along its way.
PenSample wave(double t) {
    return {.time_s = 0.25 * t,
            .x_mm = 10.0 + 30.0 * t,
            .y_mm = 16.0 + 6.0 * std::sin(7.0 * t),
            .pressure = 0.6 * studio::fade(t),
            .tilt_x_deg = 5.0,
            .rotation_deg = 90.0 * t};
}

/// Every third sample finds the tiles shared with a snapshot.
Painted painted(const Preset& preset, const Ground& ground, int threads) {
    constexpr int kSamples = 40;
    core::ThreadPool pool(threads);
    Painted result{studio::linen(50.0, 32.0, 4.0), {}, {}};
    if (ground.wet_mm > 0.0) {
        studio::cover(result.film, {60, 0, 130, 128}, ground.wet_mm, ground.paint);
        result.film.consistencies = film::Consistencies::several();
    }
    Brush brush(preset);
    brush.load(studio::dark_paint(), 0.8);
    Stroke stroke(brush, result.film, {}, {}, nullptr, &pool);
    film::FilmState snapshot = result.film;
    stroke.begin(wave(0.0));
    for (int i = 1; i <= kSamples; ++i) {
        stroke.add(wave(static_cast<double>(i) / kSamples));
        if (i % 3 == 0) snapshot = result.film;
    }
    stroke.end();
    result.held = brush.held;
    result.changed = stroke.take_changed_cells();
    return result;
}

class Threads : public testing::TestWithParam<Ground> {
  protected:
    static void expect_same_bits(const Preset& preset) {
        const Painted reference = painted(preset, GetParam(), 1);
        EXPECT_GT(studio::volume_mm3(reference.film), 0.0);
        for (const int threads : {2, 3, 5}) {
            const Painted other = painted(preset, GetParam(), threads);
            EXPECT_EQ(film::state_hash(other.film), film::state_hash(reference.film)) << threads;
            EXPECT_EQ(other.held, reference.held) << threads;
            EXPECT_EQ(other.changed, reference.changed) << threads;
        }
    }
};

TEST_P(Threads, AnyNumberPaintsTheSameBitsWithAFlat) {
    expect_same_bits(studio::flat_preset(16.0, 150));
}

TEST_P(Threads, AnyNumberPaintsTheSameBitsWithARound) {
    expect_same_bits(studio::round_preset(14.0));
}

TEST_P(Threads, AnyNumberPaintsTheSameBitsWithEveryOtherKindOfTip) {
    for (const char* name : {"Charcoal 8", "Oil pastel 10", "Calligraphy nib 3", "Ruling pen 1",
                             "Sponge 45", "Roller 50", "Squeegee 120"}) {
        SCOPED_TRACE(name);
        expect_same_bits(resized(find_preset(name), std::min(find_preset(name).tip.width_mm, 16.0)));
    }
}

INSTANTIATE_TEST_SUITE_P(On, Threads,
                         testing::Values(Ground{"DryLinen", 0.0, {}},
                                         Ground{"StiffPaint", 0.4, studio::dark_paint()},
                                         Ground{"RunnyPaint", 0.4, studio::light_paint()}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace pastoso::brush
