#include "layers/clipping.hpp"

#include "layers/apart.hpp"
#include "layers/cutting.hpp"
#include "layers/random_layer.hpp"
#include "layers/sums.hpp"
#include "layers/view.hpp"

#include <gtest/gtest.h>

namespace pastoso::layers {
namespace {

using film::FilmState;
using test::sums_of;

bool looks_same_at(const FilmState& a, const FilmState& b, int x, int y) {
    return a.thickness.at(x, y) == b.thickness.at(x, y) && a.paint.at(x, y) == b.paint.at(x, y) &&
           a.lower.paint.at(x, y) == b.lower.paint.at(x, y) &&
           a.support_mm.at(x, y) == b.support_mm.at(x, y) &&
           a.strata.soluble_thickness.at(x, y) == b.strata.soluble_thickness.at(x, y) &&
           a.strata.soluble_pigment.at(x, y) == b.strata.soluble_pigment.at(x, y) &&
           a.strata.optics.at(x, y) == b.strata.optics.at(x, y) &&
           a.strata.uppermost.at(x, y) == b.strata.uppermost.at(x, y);
}

void lay_at(FilmState& film, int x, int y) {
    film::test::lay(film, x, y, 0.3, film::test::kRed, film::find_medium("heavy-body oil"));
}

/// Of a cell with nothing but wet paint.
void wipe_at(FilmState& film, int x, int y) {
    film.thickness.set(x, y, 0);
    film.paint.set(x, y, {});
    film.support_mm.set(x, y, 0.0F);
}

class Clipping : public testing::Test {
  protected:
    /// The clipper, which remembers, against clipping afresh.
    void expect_clips() {
        const FilmState& seen = clipper.shown(upper, lower);
        const FilmState expected = clipped(upper, lower).shown;
        for (int y = 0; y < test::kShape.height; ++y)
            for (int x = 0; x < test::kShape.width; ++x)
                ASSERT_TRUE(looks_same_at(seen, expected, x, y)) << x << ", " << y;
    }
    /// The view, which remembers, against one of the layer that is cut.
    void expect_looks_cut(double opacity) {
        const FilmState cut = clipped(upper, lower).shown;
        const FilmState seen = view.of(canvas, {{&lower}, {&upper, opacity, &lower}}, pool);
        const FilmState expected = View().of(canvas, {{&lower}, {&cut, opacity}}, pool);
        EXPECT_EQ(film::state_hash(seen), film::state_hash(expected));
    }

    core::ThreadPool pool{2};
    FilmState canvas = test::bare_layer();
    FilmState lower = test::random_layer(21), upper = test::random_layer(22);
    Clipper clipper;
    View view;
};

TEST_F(Clipping, PaintIsWhatIsThickEnoughWetAndDryTogether) {
    FilmState layer = test::bare_layer();
    layer.thickness.set(1, 1, 3355);  // quanta of 2^-25 mm: 0.09998 um
    layer.thickness.set(2, 1, 3356);  // 0.10002 um
    layer.support_mm.set(3, 1, 0.9e-4F);
    layer.support_mm.set(4, 1, 1.1e-4F);
    layer.support_mm.set(140, 69, 0.6e-4F);
    layer.thickness.set(140, 69, 2000);  // 0.06 um
    const grid::Mask painted = painted_cells(layer);
    EXPECT_EQ(grid::chosen_cells(painted), 3);
    EXPECT_EQ(painted.at(2, 1), grid::kWhole);
    EXPECT_EQ(painted.at(4, 1), grid::kWhole);
    EXPECT_EQ(painted.at(140, 69), grid::kWhole);
}

TEST_F(Clipping, EveryCellShowsOrIsHidden) {
    const FilmState bare = test::bare_layer();
    const grid::Mask painted = painted_cells(lower);
    const auto [shown, hidden] = clipped(upper, lower);
    int both = 0, neither = 0;
    for (int y = 0; y < test::kShape.height; ++y)
        for (int x = 0; x < test::kShape.width; ++x) {
            const bool lies_on_paint = painted.at(x, y) != 0;
            ASSERT_TRUE(looks_same_at(lies_on_paint ? shown : hidden, upper, x, y));
            ASSERT_TRUE(looks_same_at(lies_on_paint ? hidden : shown, bare, x, y));
            if (holds_paint(upper, x, y)) ++(lies_on_paint ? both : neither);
        }
    EXPECT_GT(both, 100);
    EXPECT_GT(neither, 100);
}

TEST_F(Clipping, LosesNothing) {
    upper.strata.evaporated = 12345;
    const auto [shown, hidden] = clipped(upper, lower);
    EXPECT_EQ(sums_of(shown) + sums_of(hidden), sums_of(upper));
    EXPECT_EQ(shown.strata.evaporated, 12345);
    EXPECT_EQ(hidden.strata.evaporated, 0);
}

TEST_F(Clipping, OnToItselfShowsAllAndOnToABareLayerNothing) {
    const FilmState bare = test::bare_layer();
    FilmState layer = test::bare_layer();
    lay_at(layer, 5, 5);
    EXPECT_EQ(sums_of(clipped(layer, layer).shown), sums_of(layer));
    EXPECT_EQ(sums_of(clipped(layer, bare).hidden), sums_of(layer));
    EXPECT_FALSE(holds_paint(clipped(layer, bare).shown, 0));
}

TEST_F(Clipping, FollowsBothLayers) {
    expect_clips();
    wipe_at(upper, 149, 69);
    wipe_at(lower, 149, 69);
    lay_at(upper, 149, 69);
    expect_clips();
    EXPECT_EQ(clipper.shown(upper, lower).thickness.at(149, 69), 0);
    lay_at(lower, 149, 69);
    expect_clips();
    EXPECT_GT(clipper.shown(upper, lower).thickness.at(149, 69), 0);
    wipe_at(lower, 149, 69);
    expect_clips();
    EXPECT_EQ(clipper.shown(upper, lower).thickness.at(149, 69), 0);
    std::swap(upper, lower);
    expect_clips();
    lower = test::bare_layer();
    expect_clips();
}

TEST_F(Clipping, SharesWhatLooksTheSame) {
    const FilmState first = clipper.shown(upper, lower);
    lay_at(lower, 100, 3);
    lay_at(upper, 100, 3);
    const FilmState second = clipper.shown(upper, lower);
    EXPECT_TRUE(looks_same(first, second, 0));
    EXPECT_FALSE(looks_same(first, second, 1));
}

TEST_F(Clipping, AViewLooksAsIfTheLayerWereCut) {
    for (const double opacity : {1.0, 0.4}) {
        expect_looks_cut(opacity);
        lay_at(upper, 140, 10);
        expect_looks_cut(opacity);
        lay_at(lower, 140, 10);
        expect_looks_cut(opacity);
        wipe_at(lower, 140, 10);
        expect_looks_cut(opacity);
    }
}

TEST_F(Clipping, AViewFollowsLayersThatAreClippedAndLetGo) {
    const auto unclipped = [&] {
        const FilmState seen = view.of(canvas, {{&lower}, {&upper}}, pool);
        EXPECT_EQ(film::state_hash(seen),
                  film::state_hash(View().of(canvas, {{&lower}, {&upper}}, pool)));
    };
    unclipped();
    expect_looks_cut(1.0);
    unclipped();
    lay_at(lower, 3, 3);
    expect_looks_cut(1.0);
}

}  // namespace
}  // namespace pastoso::layers
