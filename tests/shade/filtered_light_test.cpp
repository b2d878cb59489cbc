// Steep relief as its mean over two cells: against sums over the slopes that lie within them.

#include "shade/shading_model.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace pastoso::shade {
namespace {

/// Light from a height of 45 degrees on the right.
ShadingConstants light() {
    ShadingConstants constants;
    constants.light_x = constants.light_z = std::sqrt(0.5F);
    return constants;
}

/// A relief that bends along x, with a slope there.
SurfacePoint bent(float slope, float bend) {
    SurfacePoint point{};
    point.slope_x = slope;
    point.bend_xx = bend;
    return point;
}

float eye(const SurfacePoint& point) {
    return 1.0F / std::sqrt(1.0F + point.slope_x * point.slope_x + point.slope_y * point.slope_y);
}

float towards_light(const SurfacePoint& point) {
    const ShadingConstants to = light();
    return (to.light_z - point.slope_x * to.light_x) * eye(point);
}

float lit(const SurfacePoint& point) {
    return mean_lit(towards_light(point), eye(point), point, light());
}

/// The mean of max(0, n.l) over a normal distribution of slopes with the point's variance, n_z being
/// that of the middle as in the equation.
double mean_over_slopes(const SurfacePoint& point) {
    const double deviation = kSpan_cells * std::abs(point.bend_xx) / std::sqrt(12.0);
    double sum = 0.0, weights = 0.0;
    for (double x = -6.0; x <= 6.0; x += 0.01) {
        const double weight = std::exp(-0.5 * x * x);
        const double slope = point.slope_x + deviation * x;
        sum += weight * std::max(0.0, std::sqrt(0.5) * (1.0 - slope) * eye(point));
        weights += weight;
    }
    return sum / weights;
}

TEST(FilteredLight, IsThatOfTheNormalWhereTheSlopeDoesNotVary) {
    for (const float slope : {-2.0F, 0.0F, 0.7F, 1.0F, 3.0F})
        EXPECT_FLOAT_EQ(lit(bent(slope, 0.0F)), std::max(0.0F, towards_light(bent(slope, 0.0F))));
}

TEST(FilteredLight, IsTheMeanOverTheSlopesOfTwoCells) {
    for (const float bend : {0.1F, 0.4F, 1.0F})
        for (const float slope : {-1.0F, 0.0F, 0.5F, 1.0F, 1.5F, 2.5F})
            // The root falls off more slowly than the normal distribution's tail; exact at the
            // terminator.
            EXPECT_NEAR(lit(bent(slope, bend)), mean_over_slopes(bent(slope, bend)), 0.04)
                << "slope " << slope << ", bend " << bend;
    EXPECT_NEAR(lit(bent(1.0F, 0.4F)), mean_over_slopes(bent(1.0F, 0.4F)), 1e-4);
}

TEST(FilteredLight, KnowsNoDirection) {
    SurfacePoint along_x = bent(0.0F, 0.5F), along_y{};
    along_y.bend_yy = -0.5F;
    EXPECT_FLOAT_EQ(slope_variance(along_x), slope_variance(along_y));
    EXPECT_FLOAT_EQ(slope_variance(along_x), kSpan_cells * kSpan_cells * 0.25F / 12.0F);
    // Turned by 45 degrees, the same bend is half in xy.
    SurfacePoint aslant{};
    aslant.bend_xx = aslant.bend_yy = aslant.bend_xy = 0.25F;
    EXPECT_FLOAT_EQ(slope_variance(aslant), slope_variance(along_x));
}

}  // namespace
}  // namespace pastoso::shade
