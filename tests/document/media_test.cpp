// Several media on one canvas.
#include "core/error.hpp"
#include "document/painting.hpp"
#include "document/painting_state.hpp"
#include "document/scenes.hpp"
#include "film/laboratory/measures.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

class MediaTest : public testing::Test {
  protected:
    core::ThreadPool pool{1};
    Painting painting{small_canvas(), pool};

    void SetUp() override { painting.apply(TakeBrush{"flat", 8, 1}); }

    void paint_stroke(const char* medium, const LoadPaint& load, double start_s, double y_mm) {
        painting.apply(CleanBrush{});
        painting.apply(UseMedium{medium});
        painting.apply(load);
        paint_wave(painting, start_s, y_mm);
    }
    /// ln(nu / kThinnest_m2_s) of a cell with paint.
    double log_viscosity(int x, int y) const {
        return painting.film().paint.at(x, y)[film::kViscosityChannel] * film::kPaintQuantum /
               film::thickness_mm(painting.film().thickness.at(x, y));
    }
    void expect_balance() const {
        EXPECT_LT(painting.account().volume_error_rel(), 1e-9);
        EXPECT_LT(painting.account().pigment_error_rel(), 1e-9);
    }
};

TEST_F(MediaTest, OneMediumLeavesTheFilmUniform) {
    paint_stroke("house paint", load_of("PB29"), 0.0, 10.0);
    EXPECT_FALSE(painting.film().consistencies.are_several());
    paint_stroke("house paint", load_of("PY35"), 1.0, 14.0);
    EXPECT_FALSE(painting.film().consistencies.are_several());
    paint_stroke("ink glaze", load_of("PY35"), 2.0, 14.0);
    EXPECT_TRUE(painting.film().consistencies.are_several());
}

TEST_F(MediaTest, ABareCanvasAndACleanBrushStartAnew) {
    paint_stroke("house paint", load_of("PB29"), 0.0, 10.0);
    painting.apply(Undo{});
    painting.apply(CleanBrush{});
    painting.apply(UseMedium{"heavy-body oil"});
    EXPECT_FALSE(painting.film().consistencies.are_several());
    painting.apply(Redo{});
    EXPECT_TRUE(painting.film().consistencies.are_several())
        << "what Redo brings back is of another medium";
}

TEST_F(MediaTest, AnotherMediumInHandChangesNothingThatLiesThere) {
    Painting other(small_canvas(), pool);
    for (Painting* each : {&painting, &other}) {
        each->apply(TakeBrush{"flat", 8, 1});
        each->apply(TiltCanvas{90, 90});
        each->apply(UseMedium{"house paint"});
        each->apply(load_of("PB29"));
        paint_wave(*each, 0.0, 10.0);
        each->apply(CleanBrush{});
    }
    painting.apply(UseMedium{"thinner"});
    for (int i = 0; i < 60; ++i) {
        if (i == 30) painting.apply(UseMedium{"wax paste"});
        if (i % 30 == 0) other.apply(UseMedium{"house paint"});  // wakes what lies there
        painting.advance_tick();
        other.advance_tick();
    }
    std::int64_t apart = 0;
    for (int y = 0; y < other.film().shape.height; ++y)
        for (int x = 0; x < other.film().shape.width; ++x)
            apart += std::abs(painting.film().thickness.at(x, y) - other.film().thickness.at(x, y));
    // Of several consistencies each cell is asked for its own, which it carries to 2^-18 mm.
    EXPECT_LT(static_cast<double>(apart),
              1e-3 * static_cast<double>(film::totals(other.film()).thickness));
}

TEST_F(MediaTest, UndoAndRedoBringMediaBack) {
    paint_stroke("house paint", load_of("PB29"), 0.0, 10.0);
    const film::WetMedia first = painting.film().media;
    paint_stroke("ink glaze", load_of("PY35"), 2.0, 12.0);
    const std::uint64_t painted = painting.state_hash();
    ASSERT_TRUE(painting.film().media.is_mixed(0));
    painting.apply(Undo{});
    EXPECT_FALSE(painting.film().media.is_mixed(0));
    EXPECT_EQ(painting.film().media.own, first.own);
    painting.apply(Redo{});
    EXPECT_EQ(painting.state_hash(), painted);
}

/// Where a medium lies, 0 to 1.
double share_of(const film::FilmState& film, const char* medium, int x, int y) {
    const auto& list = film.media.numbers;
    const auto numbers = film::film_numbers_of(film::find_medium(medium));
    const auto place = std::find(list.begin(), list.end(), numbers) - list.begin();
    const film::MediaCell amounts =
        film::media_in(film, film.shape.tile_at(x, y), grid::Shape::cell_in_tile(x, y));
    return amounts.at(static_cast<std::size_t>(place)) /
           std::max(1.0, static_cast<double>(film.thickness.at(x, y)));
}

TEST_F(MediaTest, EachStrokeIsOfTheMediumOfItsPaint) {
    paint_stroke("house paint", load_of("PB29"), 0.0, 10.0);
    painting.apply(CleanBrush{});
    painting.apply(UseMedium{"ink glaze"});
    painting.apply(load_of("PY35"));
    painting.apply(UseMedium{"wax paste"});  // what is on the brush stays ink
    paint_wave(painting, 2.0, 22.0);
    const int x = painting.film().shape.width / 2;
    int house = 0, ink = 0;
    for (int y = 0; y < painting.film().shape.height; ++y) {
        if (film::thickness_mm(painting.film().thickness.at(x, y)) < 0.01) continue;
        EXPECT_EQ(share_of(painting.film(), "heavy-body oil", x, y), 0.0);
        house += share_of(painting.film(), "house paint", x, y) > 0.999 ? 1 : 0;
        ink += share_of(painting.film(), "ink glaze", x, y) > 0.999 ? 1 : 0;
    }
    EXPECT_GT(house, 10);
    EXPECT_GT(ink, 5);
}

TEST_F(MediaTest, NumbersThatWereNotChangedChangeNothing) {
    Painting other(small_canvas(), pool);
    for (Painting* each : {&painting, &other}) {
        const auto own = each == &other ? std::optional(film::find_medium("house paint")) : std::nullopt;
        each->apply(TakeBrush{"flat", 8, 1});
        each->apply(UseMedium{"house paint", own});
        each->apply(load_of("PB29"));
        paint_wave(*each, 0.0, 10.0);
        each->apply(UseMedium{"House paint", own});
        each->advance_tick();
        EXPECT_FALSE(each->film().consistencies.are_several());
    }
    EXPECT_EQ(painting.state_hash(), other.state_hash());
}

TEST_F(MediaTest, PaintOfOnesOwnNumbersStandsWhereTheNamedOneRuns) {
    /// How far the middle of the paint sinks in a second, mm.
    const auto sinking_mm = [&](double yield_stress_Pa) {
        Painting fresh(small_canvas(), pool);
        film::Medium medium = film::find_medium("house paint");
        medium.yield_stress_Pa = yield_stress_Pa;
        fresh.apply(TiltCanvas{90, 90});
        fresh.apply(TakeBrush{"flat", 8, 1});
        fresh.apply(UseMedium{medium.name, medium});
        fresh.apply(load_of("PB29"));
        paint_wave(fresh, 0.0, 8.0);
        const auto middle_mm = [&] { return film::measure(fresh.film(), medium, {}, {}).centroid.y_mm; };
        const double painted_mm = middle_mm();
        for (int i = 0; i < 60; ++i)
            fresh.advance_tick();
        return middle_mm() - painted_mm;
    };
    EXPECT_GT(sinking_mm(0.5), 0.03);
    EXPECT_LT(sinking_mm(100.0), 0.001);
}

TEST_F(MediaTest, ANewNumberMakesTheFilmVaried) {
    paint_stroke("house paint", load_of("PB29"), 0.0, 10.0);
    film::Medium thicker = film::find_medium("house paint");
    thicker.viscosity_m2_s = 0.1;
    painting.apply(UseMedium{thicker.name, thicker});
    EXPECT_TRUE(painting.film().consistencies.are_several());
    EXPECT_EQ(painting.state().value.medium, (UseMedium{thicker.name, thicker}));
}

TEST_F(MediaTest, NumbersOutOfRangeAreRefusedAndNothingChanges) {
    film::Medium odd = film::find_medium("house paint");
    odd.surface_tension_N_m = std::nan("");
    try {
        painting.apply(UseMedium{odd.name, odd});
        FAIL() << "no tension is not a tension";
    } catch (const core::InputError& error) {
        EXPECT_STREQ(error.what(),
                     "the medium (\"house paint\"): surface_tension_N_m is null, it must "
                     "be a number from 0.02 to 0.07.");
    }
    EXPECT_EQ(painting.state().value.medium, UseMedium{"heavy-body oil"});
}

TEST_F(MediaTest, PaintsMixTheirConsistencyUnderTheBrush) {
    paint_stroke("heavy-body oil", load_of("PB29"), 0.0, 12.0);
    const double oil = std::log(0.3 / film::kThinnest_m2_s);
    EXPECT_NEAR(log_viscosity(60, 33), oil, 1e-3);
    paint_stroke("thinner", LoadPaint{}, 1.0, 13.0);
    int mixed = 0;
    for (int y = 0; y < painting.film().shape.height; ++y)
        for (int x = 0; x < painting.film().shape.width; ++x) {
            if (film::thickness_mm(painting.film().thickness.at(x, y)) < 0.01) continue;
            const double here = log_viscosity(x, y);
            EXPECT_LT(here, oil + 1e-2);
            mixed += here > 0.2 * oil && here < 0.95 * oil ? 1 : 0;
        }
    EXPECT_GT(mixed, 100);
    expect_balance();
}

TEST_F(MediaTest, AnOldRecordingThatChangesItsMediumStillPlays) {
    const Recording recording = crossing_session();
    for (const Event& event : recording.events)
        painting.apply(event.action);
    painting.apply(UseMedium{"heavy-body oil"});
    painting.advance_tick();
    expect_balance();
}

}  // namespace
}  // namespace pastoso::document
