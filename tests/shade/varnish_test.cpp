// Under varnish: one gloss everywhere, deeper darks, whites that keep their light, and nothing at all
// where there is none.
#include "shade/varnish.hpp"

#include "canvas.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "film/cell/drying.hpp"
#include "pigment/lab.hpp"
#include "shade/shading_model.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::shade {
namespace {

constexpr Varnish kGloss{Finish::Gloss};
constexpr pigment::Coefficients kBlack = {300, 300, 300, 300, 300, 300, 2, 2, 2, 2, 2, 2};
constexpr pigment::Coefficients kWhite = {0.02F, 0, 0, 0, 0, 0, 60, 60, 60, 60, 60, 60};
constexpr Finish kFinishes[] = {Finish::Matte, Finish::Satin, Finish::Gloss};

/// A flat coat of dry paint, a millimetre thick.
film::FilmState dry(const pigment::Coefficients& paint) {
    film::FilmState film(grid::Shape{20, 20}, 0.25);
    for (int i = 0; i < 400; ++i)
        test::set_paint(film, i % 20, i / 20, 1.0, paint);
    core::ThreadPool pool(1);
    film::dry_now(film, pool);
    return film;
}

pigment::LinearImage picture(const film::FilmState& film, const Varnish& varnish) {
    RenderSettings settings;
    settings.lighting = varnished(settings.lighting, varnish);
    settings.viewing = varnished(settings.viewing, varnish);
    core::ThreadPool pool(1);
    return render(film, test::kGround, film.shape.cells(), settings, pool);
}

pigment::Lab seen(const film::FilmState& film, const Varnish& varnish) {
    const pigment::LinearImage image = picture(film, varnish);
    const float* middle = image.rgb.data() + 3 * (10 * image.width + 10);
    return pigment::lab(pigment::LinearRgb{middle[0], middle[1], middle[2]});
}

TEST(Varnish, NoneIsThePictureBeforeBitForBit) {
    const film::FilmState film = test::random_canvas({70, 50}, 21);
    core::ThreadPool pool(1);
    const pigment::LinearImage before = render(film, test::kGround, film.shape.cells(), {}, pool);
    EXPECT_EQ(picture(film, {}).rgb, before.rgb);
    EXPECT_EQ(picture(film, {Finish::None, 1.0, 1.0}).rgb, before.rgb);
    EXPECT_EQ(picture(film, {Finish::Gloss, 0.0, 1.0}).rgb, before.rgb);
    EXPECT_NE(picture(film, kGloss).rgb, before.rgb);
}

TEST(Varnish, AFullCoatIsAsSmoothOnDryPaintAsOnWet) {
    for (const Finish finish : kFinishes) {
        const Lighting lighting = varnished(Lighting{}, {finish});
        EXPECT_EQ(lighting.dry_roughness, lighting.wet_roughness);
        EXPECT_EQ(lighting.dry_roughness, varnish_roughness(finish));
    }
    EXPECT_LT(varnish_roughness(Finish::Gloss), Lighting{}.wet_roughness);
    EXPECT_LT(varnish_roughness(Finish::Gloss), varnish_roughness(Finish::Satin));
    EXPECT_LT(varnish_roughness(Finish::Satin), varnish_roughness(Finish::Matte));
    EXPECT_LT(varnish_roughness(Finish::Matte), Lighting{}.dry_roughness);
}

TEST(Varnish, AThinCoatGoesPartOfTheWay) {
    const Lighting half = varnished(Lighting{}, {Finish::Gloss, 0.5});
    EXPECT_NEAR(half.dry_roughness, 0.5 * (0.60 + 0.10), 1e-12);
    EXPECT_NEAR(half.wet_roughness, 0.5 * (0.14 + 0.10), 1e-12);
}

TEST(Varnish, GlossDeepensADryBlack) {
    const film::FilmState black = dry(kBlack);
    const double bare = seen(black, {}).lightness;
    const double satin = seen(black, {Finish::Satin}).lightness;
    const double gloss = seen(black, kGloss).lightness;
    // The veil of the rough surface is 1.5 % of the light, L* about 13.
    EXPECT_GT(bare, 10.0);
    EXPECT_LT(satin, bare - 1.0);
    EXPECT_LT(gloss, bare - 6.0);
}

TEST(Varnish, AFreshCoatLeavesWhiteAsItIs) {
    const film::FilmState white = dry(kWhite);
    const pigment::Lab bare = seen(white, {});
    for (const Finish finish : kFinishes)
        EXPECT_LT(pigment::ciede2000(seen(white, {finish}), bare), 1.0);
}

TEST(Varnish, AgeTakesBlueAway) {
    const film::FilmState white = dry(kWhite);
    const pigment::Lab bare = seen(white, kGloss);
    const pigment::Lab old = seen(white, {Finish::Gloss, 1.0, 1.0});
    EXPECT_GT(old.b, bare.b + 20.0);
    EXPECT_LT(old.lightness, bare.lightness - 2.0);
    EXPECT_GT(old.lightness, bare.lightness - 15.0);
    const pigment::Lab younger = seen(white, {Finish::Gloss, 1.0, 0.5});
    EXPECT_GT(younger.b, bare.b);
    EXPECT_LT(younger.b, old.b);
}

TEST(Varnish, TakesLightAwayAndAddsNone) {
    for (const Finish finish : kFinishes) {
        for (const double age : {0.0, 0.3, 1.0}) {
            for (const float passed : varnish_transmission({finish, 1.0, age})) {
                EXPECT_GT(passed, 0.0F);
                EXPECT_LE(passed, 1.0F);
            }
        }
    }
}

/// What a surface that reflected all of it would send back, for an eye above it: the integral of
/// 4 D G' n.l n.l over the half sphere of lights, in steps of half a degree.
double reflected_share(double roughness) {
    const int steps = 180;
    const double step = 0.5 * core::kPi / steps;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double angle = (i + 0.5) * step;
        const auto cosine = static_cast<float>(std::cos(angle));
        const auto half = static_cast<float>(std::cos(0.5 * angle));
        sum += ggx(static_cast<float>(roughness * roughness), cosine, 1.0F, half) * cosine * 2.0 *
               core::kPi * std::sin(angle) * step;
    }
    return sum;
}

TEST(Varnish, ItsSurfaceReflectsNoMoreThanArrives) {
    for (const Finish finish : kFinishes) {
        const double share = reflected_share(varnish_roughness(finish));
        EXPECT_LE(share, 1.0 + 1e-3);
        // A rough surface loses what it reflects more than once.
        EXPECT_GT(share, 0.7);
    }
}

TEST(Varnish, ValuesBeyondTheirRangesAreRefused) {
    EXPECT_THROW(varnished(Lighting{}, {Finish::Gloss, 1.5}), core::InputError);
    EXPECT_THROW(varnished(Lighting{}, {Finish::Gloss, 1.0, -0.1}), core::InputError);
    EXPECT_THROW(varnished(pigment::Viewing{}, {Finish::None, std::nan("")}), core::InputError);
}

}  // namespace
}  // namespace pastoso::shade
