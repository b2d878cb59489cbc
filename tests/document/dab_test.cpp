// A loaded brush that is set down and lifted leaves a heavy dab, which runs if its paint does.

#include "core/thread_pool.hpp"
#include "document/painting.hpp"
#include "document/painting_state.hpp"
#include "document/scenes.hpp"

#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

constexpr double kPlace_mm = 15.0, kPainted_mm = 0.02;

CanvasSettings linen() {
    CanvasSettings canvas;
    canvas.width_mm = canvas.height_mm = 50.0;
    canvas.px_per_mm = 4.0;
    canvas.support = "linen";
    return canvas;
}

void dab(Painting& painting, const char* brush, double start_s) {
    painting.apply(TakeBrush{brush, 0.0, 1});
    painting.apply(load_of("PR108", 1.2));
    const auto at = [&](int i, double pressure) {
        return brush::PenSample{start_s + 0.02 * i, 25.0, kPlace_mm, pressure};
    };
    painting.apply(PenDown{at(0, 0.1)});
    for (const int i : {1, 2, 3, 4, 5, 6, 7})
        painting.apply(PenMove{at(i, i < 5 ? 0.2 * i : 0.8 - 0.2 * (i - 4))});
    painting.apply(PenUp{});
}

/// The lowest place that is painted, mm.
double front_mm(const film::FilmState& film) {
    for (int y = film.shape.height - 1; y >= 0; --y)
        for (int x = 0; x < film.shape.width; ++x)
            if (film::thickness_mm(film.thickness.at(x, y)) > kPainted_mm) return y * film.cell_mm;
    return 0.0;
}

class DabTest : public ::testing::TestWithParam<const char*> {};

TEST_P(DabTest, TwoOfHousePaintRunWithinTwoSeconds) {
    core::ThreadPool pool(2);
    Painting painting(linen(), pool);
    painting.apply(UseMedium{"house paint"});
    painting.apply(TiltCanvas{60, 90});
    dab(painting, GetParam(), 0.0);
    dab(painting, GetParam(), 1.0);
    const double before_mm = front_mm(painting.film());
    for (int tick = 0; tick < 120; ++tick)
        painting.advance_tick();
    EXPECT_GT(front_mm(painting.film()), before_mm + 0.4);
    EXPECT_LT(painting.account().volume_error_rel(), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Brushes, DabTest,
                         ::testing::Values("Flat bristle 20", "Large flat 40", "Palette knife 17"));

TEST(Dab, OfOilStandsWhereItIsSet) {
    core::ThreadPool pool(2);
    Painting painting(linen(), pool);
    painting.apply(TiltCanvas{60, 90});
    dab(painting, "Flat bristle 20", 0.0);
    const double before_mm = front_mm(painting.film());
    for (int tick = 0; tick < 120; ++tick)
        painting.advance_tick();
    EXPECT_LT(front_mm(painting.film()), before_mm + 0.3);
}

}  // namespace
}  // namespace pastoso::document
