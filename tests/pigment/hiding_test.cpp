#include "pigment/hiding.hpp"

#include "pigment/palette.hpp"

#include <gtest/gtest.h>

namespace pastoso::pigment {
namespace {

/// Of a flat bristle brush.
constexpr double kUsualFilm_mm = 0.22;

Hiding grade(const char* name, double film_mm = kUsualFilm_mm) {
    return hiding_of(find_pigment(name).coefficients, film_mm);
}

TEST(Hiding, IsThatForWhichPaintersKnowTheirPigments) {
    for (const char* opaque : {"PW6", "PY35", "PO20", "PR108", "PY43", "PR101", "PG17"})
        EXPECT_EQ(grade(opaque), Hiding::Opaque) << opaque;
    for (const char* semi_opaque : {"PW4", "PO73"})
        EXPECT_EQ(grade(semi_opaque), Hiding::SemiOpaque) << semi_opaque;
    for (const char* semi_transparent : {"PR83", "PB15:3", "PG7", "PV19", "PR122", "PY74"})
        EXPECT_EQ(grade(semi_transparent), Hiding::SemiTransparent) << semi_transparent;
    for (const char* transparent : {"PB29", "PG18", "PG36"})
        EXPECT_EQ(grade(transparent), Hiding::Transparent) << transparent;
}

TEST(Hiding, GrowsWithTheFilm) {
    for (const Pigment& paint : bundled_palette()) {
        Hiding thinner = Hiding::Transparent;
        for (double film_mm = 0.001; film_mm < 10.0; film_mm *= 2.0) {
            const Hiding hiding = hiding_of(paint.coefficients, film_mm);
            EXPECT_GE(hiding, thinner) << paint.ci_name << " at " << film_mm << " mm";
            thinner = hiding;
        }
    }
}

TEST(Hiding, GoesByHowMuchPigmentIsInTheFilm) {
    Coefficients thinned = find_pigment("PR108").coefficients;
    for (float& per_mm : thinned)
        per_mm *= 0.1F;
    EXPECT_EQ(hiding_of(thinned, kUsualFilm_mm), Hiding::Transparent);
    EXPECT_EQ(hiding_of(thinned, 10.0 * kUsualFilm_mm), Hiding::Opaque);
    EXPECT_EQ(hiding_of({}, 1.0), Hiding::Transparent);
}

TEST(Hiding, OfAThinFilmIsLessThanThatOfAThickOne) {
    EXPECT_EQ(grade("PW6", 0.01), Hiding::Transparent);
    EXPECT_EQ(grade("PB29", 3.0), Hiding::Opaque);
}

}  // namespace
}  // namespace pastoso::pigment
