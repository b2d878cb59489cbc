// Nothing is lost or made: canvas and tools together keep their volume and every pigment sum.
#include "brush/brush.hpp"
#include "brush/studio.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

/// Sums of doubles over up to some 10^6 exchanges; the integers on the canvas are exact.
constexpr double kRounding = 1e-11;

void expect_sound(const film::FilmState& film) {
    for (int y = 0; y < film.shape.height; ++y) {
        for (int x = 0; x < film.shape.width; ++x) {
            const std::int32_t h = film.thickness.at(x, y);
            ASSERT_GE(h, 0);
            ASSERT_LE(h * film::kThicknessQuantum_mm, film::kMaxThickness_mm);
            for (const std::int32_t pigment : film.paint.at(x, y)) {
                ASSERT_GE(pigment, 0);
                if (h == 0) {
                    ASSERT_EQ(pigment, 0);
                }
            }
        }
    }
}

void expect_sound(const Brush& brush) {
    for (const Contents& held : brush.held) {
        ASSERT_GE(held.volume_mm3, 0.0);
        for (const double pigment : held.paint)
            ASSERT_GE(pigment, 0.0);
    }
}

TEST(Balance, HoldsOverThirtyOneTools) {
    film::FilmState film = studio::linen(100.0, 50.0);
    Brush loaded(studio::flat_preset(16.0));
    Contents taken =
        loaded.load(MixedLoad{studio::dark_paint(), studio::light_paint(), 0.4, 0.5, false}, 1.0);
    studio::paint(loaded, film, [](double t) {
        return PenSample{.x_mm = 15.0 + 70.0 * t,
                         .y_mm = 25.0 + 8.0 * std::sin(6.0 * t),
                         .pressure = 0.5 * studio::fade(t),
                         .tilt_x_deg = 5.7,
                         .tilt_y_deg = 2.9,
                         .rotation_deg = 74.5};
    });
    Contents sum = loaded.contents();
    for (int i = 0; i < 20; ++i) {
        Brush dirty(studio::flat_preset(16.0), 0.0, static_cast<std::uint32_t>(i));
        const double x = 20.0 + 3.0 * i;
        studio::paint(dirty, film, studio::line(x, 5.0, x, 45.0, 0.6, 0.0), 250.0, 0.5);
        expect_sound(dirty);
        sum += dirty.contents();
    }
    for (int i = 0; i < 10; ++i) {
        Brush knife(studio::linear(find_preset("knife")));
        const double y = 8.0 + 4.0 * i;
        studio::paint(knife, film, studio::line(15.0, y, 95.0, y, 0.6, 90.0), 250.0, 0.5);
        expect_sound(knife);
        sum += knife.contents();
    }
    expect_sound(film);
    sum += studio::contents(film);
    EXPECT_LT(studio::balance_error(sum, taken), kRounding);
}

class EveryPreset : public testing::TestWithParam<const char*> {};

TEST_P(EveryPreset, MarksTheCanvasAndBalances) {
    film::FilmState film = studio::linen(60.0, 40.0, 4.0);
    studio::cover(film, studio::cells_of(film, 0.0, 0.0, 30.0, 40.0), 0.4, studio::light_paint());
    Contents before = studio::contents(film);
    Brush brush(find_preset(GetParam()));
    before += brush.load(studio::dark_paint(), 1.2);
    studio::paint(brush, film, [](double t) {
        return PenSample{.x_mm = 5.0 + 65.0 * t,  // runs off the canvas at the end
                         .y_mm = 20.0 + 10.0 * std::sin(9.0 * t),
                         .pressure = 0.2 + 0.7 * t,
                         .tilt_x_deg = 30.0 * std::cos(5.0 * t),
                         .rotation_deg = 200.0 * t};
    });
    expect_sound(film);
    expect_sound(brush);
    const grid::Rect dry = studio::cells_of(film, 30.0, 0.0, 60.0, 40.0);
    EXPECT_GT(studio::coverage(film, dry), 0.15);
    Contents after = studio::contents(film);
    after += brush.contents();
    EXPECT_LT(studio::balance_error(after, before), kRounding);
}

INSTANTIATE_TEST_SUITE_P(Presets, EveryPreset,
                         testing::Values("Flat bristle 20", "Round sable 9", "Filbert 14", "Fan 26",
                                         "Soft glazing flat 16", "Impasto flat 18", "Palette knife 17"));

}  // namespace
}  // namespace pastoso::brush
