#include "layers/view.hpp"

#include "film/support/support.hpp"
#include "layers/apart.hpp"
#include "layers/merging.hpp"
#include "layers/random_layer.hpp"

#include <gtest/gtest.h>

namespace pastoso::layers {
namespace {

using film::FilmState;

FilmState linen() {
    FilmState bare = test::bare_layer();
    core::ThreadPool pool(1);
    bare.support_mm = film::named_support("linen", test::kShape, test::kCell_mm, 0.0, pool);
    return bare;
}

/// What is seen in a cell of a film on white.
pigment::Bands reflectance(const FilmState& film, int x, int y) {
    pigment::Bands seen{};
    for (int band = 0; band < pigment::kBands; ++band)
        seen[band] = pigment::reflectance_over(film::optics_of(film.strata.optics.at(x, y), band),
                                               film::test::kWhiteGround[band]);
    seen = film::test::wet_over(film.strata.soluble_pigment.at(x, y).data(), seen);
    const film::PaintCell& below = film.lower.paint.at(x, y);
    seen = film::test::wet_over(below.data(), seen);
    return film::test::wet_over(film::upper_paint(below, film.paint.at(x, y)).data(), seen);
}

/// The same of layers of which one shines through the other, from below, without any rounding.
pigment::Bands expected_reflectance(const std::vector<SeenLayer>& layers, int x, int y) {
    pigment::Bands seen = film::test::kWhiteGround;
    for (const SeenLayer& layer : layers) {
        for (int band = 0; band < pigment::kBands; ++band) {
            const film::FilmState& film = *layer.film;
            auto light = film::optics_of(film.strata.optics.at(x, y), band);
            const film::PaintCell& below = film.lower.paint.at(x, y);
            const film::PaintCell above = film::upper_paint(below, film.paint.at(x, y));
            for (const std::int32_t* pigment :
                 {film.strata.soluble_pigment.at(x, y).data(), below.data(), above.data()}) {
                light = pigment::laid_over(
                    pigment::layer_optics(film::optical_thickness(pigment[band]),
                                          film::optical_thickness(pigment[pigment::kBands + band])),
                    light);
            }
            seen[band] = pigment::reflectance_over(
                pigment::faded(light, static_cast<float>(layer.opacity)), seen[band]);
        }
    }
    return seen;
}

double surface_mm(const FilmState& film, int x, int y) {
    return film.support_mm.at(x, y) + film::thickness_mm(film.thickness.at(x, y));
}

class ViewTest : public testing::Test {
  protected:
    void expect_looks_like(const FilmState& seen, const std::vector<SeenLayer>& layers) {
        for (int y = 0; y < test::kShape.height; ++y) {
            for (int x = 0; x < test::kShape.width; ++x) {
                const pigment::Bands found = reflectance(seen, x, y);
                const pigment::Bands expected = expected_reflectance(layers, x, y);
                double height_mm = canvas.support_mm.at(x, y);
                for (const SeenLayer& layer : layers)
                    height_mm += surface_mm(*layer.film, x, y);
                // Wet paint is rounded to steps of the support, once a layer.
                ASSERT_NEAR(surface_mm(seen, x, y), height_mm, 2.0 * film::kSupportQuantum_mm);
                for (int band = 0; band < pigment::kBands; ++band)
                    // The rounding of both layers' strata, of the view's, and the exponential's 1e-5.
                    ASSERT_NEAR(found[band], expected[band], 1e-4) << x << ", " << y << " band " << band;
            }
        }
    }
    core::ThreadPool pool{2};
    FilmState canvas = linen();
    View view;
    FilmState lower = test::random_layer(11), middle = test::random_layer(12),
              upper = test::random_layer(13);
};

TEST_F(ViewTest, OfNothingIsTheBareCanvas) {
    EXPECT_EQ(film::state_hash(view.of(canvas, {}, pool)), film::state_hash(canvas));
}

TEST_F(ViewTest, OfOneLayerIsTheLayer) {
    FilmState expected = laid_on(lower, canvas.support_mm);
    expected.strata.fixed = {};  // counts are no part of a view
    expected.strata.evaporated = 0;
    expected.worked.follow(false);  // it cannot be seen
    expected.media = film::WetMedia(expected.shape);
    EXPECT_EQ(film::state_hash(view.of(canvas, {{&lower}}, pool)), film::state_hash(expected));
}

TEST_F(ViewTest, OfSeveralLooksLikeAllOfThem) {
    const std::vector<SeenLayer> layers = {{&lower}, {&middle}, {&upper}};
    expect_looks_like(view.of(canvas, layers, pool), layers);
}

TEST_F(ViewTest, FadedLayersLetMoreThrough) {
    const std::vector<SeenLayer> layers = {{&lower}, {&middle, 0.5}, {&upper, 0.0}};
    expect_looks_like(view.of(canvas, layers, pool), layers);
}

TEST_F(ViewTest, PaintThatIsWetAndUncoveredShines) {
    FilmState dry = test::bare_layer(), wet = test::bare_layer();
    film::test::lay(wet, 1, 1, 0.2, film::test::kBlue, film::find_medium("heavy-body oil"));
    film::test::lay(wet, 2, 1, 0.2, film::test::kBlue, film::find_medium("heavy-body oil"));
    film::test::lay(dry, 1, 1, 0.2, film::test::kRed, film::find_medium("soft-body acrylic"));
    film::dry_now(dry, pool);
    const FilmState seen = view.of(canvas, {{&wet}, {&dry}}, pool);
    EXPECT_EQ(seen.thickness.at(1, 1), 0);
    EXPECT_EQ(seen.thickness.at(2, 1), wet.thickness.at(2, 1));
}

TEST_F(ViewTest, SharesWhatHasNotChanged) {
    const FilmState first = view.of(canvas, {{&lower}, {&upper}}, pool);
    film::test::lay(upper, 100, 3, 0.3, film::test::kBlue, film::find_medium("heavy-body oil"));
    const FilmState second = view.of(canvas, {{&lower}, {&upper}}, pool);
    EXPECT_TRUE(second.strata.optics.shares_tile(first.strata.optics, 0));
    EXPECT_FALSE(second.paint.shares_tile(first.paint, 1));
    expect_looks_like(second, {{&lower}, {&upper}});
}

TEST_F(ViewTest, FollowsLayersThatComeGoAndFade) {
    expect_looks_like(view.of(canvas, {{&lower}, {&upper}}, pool), {{&lower}, {&upper}});
    expect_looks_like(view.of(canvas, {{&upper}}, pool), {{&upper}});
    expect_looks_like(view.of(canvas, {{&upper, 0.3}, {&lower}}, pool), {{&upper, 0.3}, {&lower}});
    expect_looks_like(view.of(canvas, {{&upper, 0.7}, {&lower}}, pool), {{&upper, 0.7}, {&lower}});
    expect_looks_like(view.of(canvas, {{&middle}, {&upper, 0.3}, {&lower}}, pool),
                      {{&middle}, {&upper, 0.3}, {&lower}});
}

TEST_F(ViewTest, AMergedPaintingLooksTheSameWhereNothingRunsTogether) {
    film::dry_now(upper, pool);
    const FilmState both = merged(lower, upper, 1.0, pool);
    const FilmState seen = view.of(canvas, {{&both}}, pool);
    for (int y = 0; y < test::kShape.height; ++y) {
        for (int x = 0; x < test::kShape.width; ++x) {
            const pigment::Bands expected = expected_reflectance({{&lower}, {&upper}}, x, y);
            for (int band = 0; band < pigment::kBands; ++band)
                ASSERT_NEAR(reflectance(seen, x, y)[band], expected[band], 1e-4) << x << ", " << y;
        }
    }
}

}  // namespace
}  // namespace pastoso::layers
