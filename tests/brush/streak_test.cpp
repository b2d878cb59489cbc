// A brush of half-mixed paint draws streaks of colour, and does not blur them by taking up what it has
// just laid down.
#include "brush/brush.hpp"
#include "brush/studio.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::brush {
namespace {

constexpr double kStart_mm = 15.0, kLength_mm = 150.0, kMiddle_mm = 15.0;

/// A preset whose load lasts, with or without anything coming back from the canvas.
Preset streaky(bool takes_up) {
    Preset preset = studio::flat_preset(14.0, 200);
    preset.paint.run_mm = 600.0;
    if (!takes_up) preset.exchange.pickup = preset.exchange.mix = 0.0;
    return preset;
}

/// Half-mixed paint dragged over 150 mm.
film::FilmState dragged(film::FilmState film, const Preset& preset) {
    Brush brush(preset);
    brush.load(MixedLoad{studio::dark_paint(), studio::light_paint(), 0.5, 1.0, false}, 1.0);
    studio::paint(brush, film,
                  studio::line(kStart_mm, kMiddle_mm, kStart_mm + kLength_mm, kMiddle_mm, 0.4, 90.0));
    return film;
}

/// Standard deviation over the width of the share that channel 6 has of the paint, in a cross-section
/// 2 mm long.
double contrast(const film::FilmState& film, double along_mm) {
    double sum = 0.0, squares = 0.0, rows = 0.0;
    const grid::Rect cells = studio::cells_of(film, kStart_mm + along_mm, kMiddle_mm - 5.0,
                                              kStart_mm + along_mm + 2.0, kMiddle_mm + 5.0);
    for (int y = cells.y0; y < cells.y1; ++y) {
        double volume_mm = 0.0, light = 0.0;
        for (int x = cells.x0; x < cells.x1; ++x) {
            volume_mm += studio::thickness_mm(film, x, y);
            light += film::optical_thickness(film.paint.at(x, y)[6]);
        }
        if (volume_mm <= 0.0) continue;
        const double share = light / volume_mm / studio::light_paint()[6];
        sum += share, squares += share * share, rows += 1.0;
    }
    return std::sqrt(squares / rows - sum / rows * sum / rows);
}

/// Wicking between bristles softens the streaks on the way, with and without taking up. What the brush
/// reads of its own paint may cost a thirtieth more; measured are 2.1, 1.0 and 0 %, from paint that
/// stands in the way and is taken up. Swapping costs nothing.
constexpr double kKept = 0.97;

TEST(Streaks, AreNotBlurredByWhatTheBrushHasJustLaidDown) {
    const film::FilmState dry = studio::linen(180.0, 30.0);
    const film::FilmState reading = dragged(dry, streaky(true)), blind = dragged(dry, streaky(false));
    for (const double along_mm : {20.0, 75.0, 140.0})
        EXPECT_GT(contrast(reading, along_mm), kKept * contrast(blind, along_mm)) << along_mm;
}

TEST(Streaks, AreNotSwappedAwayOnDryCanvas) {
    Preset swapping = streaky(true), blind = streaky(false);
    swapping.exchange.pickup = 0.0;
    const film::FilmState dry = studio::linen(180.0, 30.0);
    // The paint that is swapped is only that which the brush found.
    EXPECT_EQ(film::state_hash(dragged(dry, swapping)), film::state_hash(dragged(dry, blind)));
}

TEST(Streaks, AreReadWhenTheBrushComesAgain) {
    // The second stroke takes what the first one laid down for what it is: paint on the canvas.
    Preset swapping = streaky(true), blind = streaky(false);
    swapping.exchange.pickup = 0.0;
    const film::FilmState once = dragged(studio::linen(180.0, 30.0), blind);
    EXPECT_NE(film::state_hash(dragged(once, swapping)), film::state_hash(dragged(once, blind)));
}

TEST(Streaks, StandOutOnWetPaintToo) {
    film::FilmState wet = studio::linen(180.0, 30.0);
    studio::cover(wet, 0.2, studio::dark_paint());
    // Whoever takes up nothing only covers: most of the dark paint stays in the cells. To take paint up
    // must bring more colour into them than it carries away.
    const film::FilmState reading = dragged(wet, streaky(true)), blind = dragged(wet, streaky(false));
    for (const double along_mm : {20.0, 75.0, 140.0})
        EXPECT_GT(contrast(reading, along_mm), 2.0 * contrast(blind, along_mm)) << along_mm;
}

}  // namespace
}  // namespace pastoso::brush
