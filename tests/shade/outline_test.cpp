#include "shade/outline.hpp"

#include "canvas.hpp"
#include "core/units.hpp"
#include "grid/bspline.hpp"
#include "shade/render.hpp"

#include <algorithm>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::shade {
namespace {

/// Thickness in mm at a place in cells; negative where there is no paint.
using Film = std::function<double(double, double)>;

constexpr int kSize = 48;

/// A canvas whose cells have the means of a film, of 16 x 16 samples a cell.
film::FilmState painted(const Film& thickness_mm, grid::Shape shape = {kSize, kSize}) {
    constexpr int kSamples = 16;
    film::FilmState film(shape, 0.25);
    for (int y = 0; y < shape.height; ++y) {
        for (int x = 0; x < shape.width; ++x) {
            double sum = 0.0;
            for (int i = 0; i < kSamples * kSamples; ++i)
                sum += std::max(0.0, thickness_mm(x + (i % kSamples + 0.5) / kSamples,
                                                  y + (i / kSamples + 0.5) / kSamples));
            test::set_paint(film, x, y, sum / (kSamples * kSamples), test::kBlue);
        }
    }
    return film;
}

struct Cover {
    explicit Cover(const film::FilmState& film, const grid::Rect& part)
        : cells(part),
          share(static_cast<std::size_t>(part.width()) * part.height()),
          cover(share.size()),
          near(share.size()) {
        outline_cells(film, cells, {share.data(), cover.data(), near.data()}, cells.width());
    }
    explicit Cover(const film::FilmState& film) : Cover(film, film.shape.cells()) {}

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - cells.y0) * cells.width() + x - cells.x0;
    }

    /// Above 0 within the outline.
    double at(double x, double y) const {
        const int column = static_cast<int>(std::floor(x - 0.5));
        const int row = static_cast<int>(std::floor(y - 0.5));
        const auto along_x = grid::bspline_weights(static_cast<float>(x - 0.5 - column));
        const auto along_y = grid::bspline_weights(static_cast<float>(y - 0.5 - row));
        double sum = 0.0;
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i)
                sum += along_x.value[i] * along_y.value[j] * cover[index(column - 1 + i, row - 1 + j)];
        return sum;
    }

    grid::Rect cells;
    std::vector<float> share, cover;
    std::vector<std::uint8_t> near;
};

struct Line {
    double x, y;       ///< of a place on it, in cells
    double angle_rad;  ///< of its normal, away from the paint
};

/// How far out the outline lies there, in cells; 3 where there is none within as much.
double beyond(const Cover& cover, const Line& line) {
    constexpr double kReach = 3.0, kStep = 1.0 / 256;
    const double across_x = std::cos(line.angle_rad), across_y = std::sin(line.angle_rad);
    for (double way = kReach; way > -kReach; way -= kStep)
        if (cover.at(line.x + way * across_x, line.y + way * across_y) > 0.0) return way;
    return -kReach;
}

struct Offsets {
    double mean = 0.0, most = 0.0;  ///< in cells, the second without its sign
};

/// Around circles of the film whose thickness is a function of the way in from the edge.
Offsets around(double radius, const std::function<double(double)>& thickness_mm) {
    Offsets offsets;
    int count = 0;
    for (const auto& [x, y] : {std::pair{24.0, 24.0}, {24.37, 23.81}, {23.55, 24.5}}) {
        const Cover cover(painted([&, x = x, y = y](double at_x, double at_y) {
            const double in = radius - std::hypot(at_x - x, at_y - y);
            return in > 0.0 ? thickness_mm(in) : -1.0;
        }));
        for (int i = 0; i < 120; ++i) {
            const double angle = 2.0 * core::kPi * i / 120;
            const double way =
                beyond(cover, {x + radius * std::cos(angle), y + radius * std::sin(angle), angle});
            offsets.mean += way;
            offsets.most = std::max(offsets.most, std::abs(way));
            ++count;
        }
    }
    offsets.mean /= count;
    return offsets;
}

// The spline draws an arc of radius R in by 5 / (24 R), of the cell's and its own width: 0.02 cells
// here.
TEST(Outline, OfADiscLiesOnItsEdgeAtEveryAngle) {
    const Offsets offsets = around(11.3, [](double) { return 0.3; });
    EXPECT_NEAR(offsets.mean, -0.041, 0.01);
    EXPECT_LE(offsets.most, 0.1);
}

// One law serves cliffs, slopes and what lies between: aslant the nearest cells lie farther away than
// their neighbours in a row, which the most of nine takes for steeper.
TEST(Outline, OfASlopeLiesOnItsFoot) {
    const Offsets offsets = around(11.3, [](double in) { return 0.05 * in; });
    EXPECT_LE(std::abs(offsets.mean), 0.2);
    EXPECT_LE(offsets.most, 0.25);
}

TEST(Outline, OfARoundedRimLiesOnItsEdge) {
    const Offsets offsets = around(11.3, [](double in) {
        return 0.3 * std::sqrt(std::max(0.0, 1.0 - std::pow(1.0 - in / 11.3, 2)));
    });
    EXPECT_LE(std::abs(offsets.mean), 0.1);
    EXPECT_LE(offsets.most, 0.15);
}

TEST(Outline, OfStraightEdgesHasNoStepsOfCells) {
    for (const double slant_deg : {0.0, 3.0, 7.0, 20.0, 33.0, 45.0}) {
        const double angle = core::radians(slant_deg + 90.0);
        const auto in = [&](double x, double y) {
            return (24.2 - x) * std::cos(angle) + (24.0 - y) * std::sin(angle);
        };
        const Cover cover(painted([&](double x, double y) { return in(x, y) > 0.0 ? 0.3 : -1.0; }));
        double least = 3.0, most = -3.0;
        for (double along = -12.0; along < 12.0; along += 0.3) {
            const double way =
                beyond(cover, {24.2 - along * std::sin(angle), 24.0 + along * std::cos(angle), angle});
            least = std::min(least, way);
            most = std::max(most, way);
        }
        // Cells alone would give 1 at 3 degrees.
        EXPECT_LE(most - least, 0.08) << slant_deg;
    }
}

double area(const Cover& cover) {
    constexpr double kStep = 0.05;
    double sum = 0.0;
    for (double y = 8.0; y < 40.0; y += kStep)
        for (double x = 8.0; x < 40.0; x += kStep)
            sum += cover.at(x, y) > 0.0 ? kStep * kStep : 0.0;
    return sum;
}

TEST(Outline, OfWhatIsNoWiderThanACellIsNotLost) {
    film::FilmState dot(grid::Shape{kSize, kSize}, 0.25);
    test::set_paint(dot, 20, 25, 0.01, test::kBlue);
    EXPECT_NEAR(area(Cover(dot)), 1.0, 0.3);
    for (const double slant_deg : {0.0, 20.0, 45.0}) {
        const double angle = core::radians(slant_deg);
        const Cover line(painted([&](double x, double y) {
            const double along = (x - 24) * std::cos(angle) + (y - 24.4) * std::sin(angle);
            const double across = (y - 24.4) * std::cos(angle) - (x - 24) * std::sin(angle);
            return std::abs(along) < 10 && std::abs(across) < 0.5 ? 0.1 : -1.0;
        }));
        // Lines are up to a quarter of a cell too wide.
        EXPECT_NEAR(area(line), 20.0, 6.0) << slant_deg;
    }
}

TEST(Outline, DoesNotPartThickPaintFromAThinFilmBelow) {
    for (const double film_mm : {0.1, 0.01, 0.002}) {
        const Cover cover(painted(
            [&](double x, double y) { return film_mm + (std::hypot(x - 24, y - 24) < 7 ? 0.5 : 0.0); }));
        // Where a cell's share of the thick edge is taken for the end of paint, those around it are not.
        for (double y = 12; y < 36; y += 0.25)
            for (double x = 12; x < 36; x += 0.25)
                ASSERT_GT(cover.at(x, y), 0.1) << film_mm;
    }
}

TEST(Outline, OfDryCanvasIsNowhere) {
    const Cover cover(film::FilmState(grid::Shape{70, 9}, 0.25));
    for (std::size_t i = 0; i < cover.cover.size(); ++i) {
        EXPECT_EQ(cover.cover[i], -0.5F);
        EXPECT_EQ(cover.near[i], 0);
    }
}

TEST(Outline, IsTheSameInAMirror) {
    const film::FilmState film = test::random_canvas({70, 66}, 21);
    const Cover cover(film), mirrored(test::mirrored(film));
    for (int y = 0; y < 66; ++y) {
        for (int x = 0; x < 70; ++x) {
            ASSERT_EQ(cover.share[cover.index(x, y)], mirrored.share[cover.index(69 - x, y)]);
            ASSERT_EQ(cover.cover[cover.index(x, y)], mirrored.cover[cover.index(69 - x, y)]);
        }
    }
}

TEST(Outline, OfPartsIsThatOfTheWhole) {
    const film::FilmState film = test::random_canvas({150, 100}, 22);
    const Cover whole(film, {-2, -2, 152, 102});
    for (int y = -2; y < 102; y += 17) {
        for (int x = -2; x < 152; x += 23) {
            const Cover part(film, {x, y, std::min(x + 23, 152), std::min(y + 17, 102)});
            for (int j = part.cells.y0; j < part.cells.y1; ++j) {
                for (int i = part.cells.x0; i < part.cells.x1; ++i) {
                    ASSERT_EQ(part.share[part.index(i, j)], whole.share[whole.index(i, j)]);
                    ASSERT_EQ(part.cover[part.index(i, j)], whole.cover[whole.index(i, j)]);
                    ASSERT_EQ(part.near[part.index(i, j)], whole.near[whole.index(i, j)]);
                }
            }
        }
    }
}

pigment::LinearImage picture(const film::FilmState& film, double scale) {
    RenderSettings settings;
    settings.scale = scale;
    settings.lighting.elevation_deg = 90.0;
    settings.lighting.ambient = 0.0;
    core::ThreadPool pool(1);
    return render(film, test::kGround, film.shape.cells(), settings, pool);
}

TEST(Outline, LeavesPixelsOutsideUntouched) {
    constexpr double kScale = 6.4, kRadius = 11.3;
    film::FilmState film =
        painted([](double x, double y) { return std::hypot(x - 24, y - 24) < kRadius ? 0.4 : -1.0; });
    const auto weave = [](int x, int y) { return 0.1 * std::sin(1.3 * x) * std::cos(0.9 * y); };
    test::set_support(film, weave);
    film::FilmState dry(film.shape, film.cell_mm);
    test::set_support(dry, weave);
    const pigment::LinearImage seen = picture(film, kScale), bare = picture(dry, kScale);
    int mixed = 0;
    for (int y = 0; y < seen.height; ++y) {
        for (int x = 0; x < seen.width; ++x) {
            const double out = std::hypot((x + 0.5) / kScale - 24, (y + 0.5) / kScale - 24) - kRadius;
            const float* pixel = seen.rgb.data() + 3 * (static_cast<std::ptrdiff_t>(y) * seen.width + x);
            const float* other = bare.rgb.data() + (pixel - seen.rgb.data());
            const bool same = std::equal(pixel, pixel + 3, other);
            // Half a pixel's diagonal and what the outline is off.
            if (out > 0.22) {
                ASSERT_TRUE(same) << x << " " << y;
            }
            if (out < -0.22) {
                ASSERT_LT(pixel[0], 0.3F * other[0]) << x << " " << y;
            }
            mixed += !same && pixel[0] > 0.3F * other[0] ? 1 : 0;
        }
    }
    // A ring one pixel wide, the diagonal ones wider.
    EXPECT_LE(mixed, 2.0 * core::kPi * kRadius * kScale * 1.5);
}

/// A film of an even thickness on cells of 0.25 mm.
float sharpness_of(double thickness_mm, const pigment::Coefficients& paint) {
    film::FilmState film(grid::Shape{3, 3}, 0.25);
    test::set_paint(film, 1, 1, thickness_mm, paint);
    std::vector<float> sharp(9);
    edge_sharpness(film, film.shape.cells(), sharp.data(), 3);
    return sharp[4];
}

TEST(Outline, IsAsSharpAsThePaintHides) {
    EXPECT_EQ(sharpness_of(0.4, test::kBlue), 1.0F);
    EXPECT_EQ(sharpness_of(0.4, {}), 0.0F) << "a medium without pigment";
    // In its band of 108 and 3 per mm: sqrt(108 (108 + 6)) h - 1/2.
    const double per_mm = std::sqrt(108.0 * 114.0);
    EXPECT_NEAR(sharpness_of(0.008, test::kBlue), per_mm * 0.008 - 0.5, 1e-3);
    EXPECT_EQ(sharpness_of(0.004, test::kBlue), 0.0F);
}

TEST(Outline, OfATransparentWashIsNotDrawn) {
    film::FilmState film =
        painted([](double x, double y) { return std::hypot(x - 24, y - 24) < 11 ? 0.002 : -1.0; });
    const pigment::LinearImage seen = picture(film, 5.0);
    float steepest = 0.0F;
    for (std::size_t i = 0; i + 3 < seen.rgb.size(); i += 3)
        if (i / 3 % seen.width + 1 < static_cast<std::size_t>(seen.width))
            steepest = std::max(steepest, std::abs(seen.rgb[i + 3] - seen.rgb[i]));
    const float* middle =
        seen.rgb.data() +
        3 * (static_cast<std::ptrdiff_t>(seen.height / 2) * seen.width + seen.width / 2);
    const float contrast = seen.rgb[0] - middle[0];
    ASSERT_GT(contrast, 0.02F);
    // The spline takes more than a cell from one side to the other.
    EXPECT_LT(steepest, 0.3F * contrast);
}

TEST(Outline, ComesGraduallyAsThePictureIsEnlarged) {
    EXPECT_EQ(outline_strength(0.3), 0.0F);
    EXPECT_EQ(outline_strength(1.0), 0.0F);
    EXPECT_FLOAT_EQ(outline_strength(1.25), 0.25F);
    EXPECT_EQ(outline_strength(2.0), 1.0F);
    EXPECT_EQ(outline_strength(6.4), 1.0F);
}

TEST(Outline, CutsSamplesByTheShareWithin) {
    // An edge that falls by 0.8 a cell, seen by samples of a quarter of a cell.
    EXPECT_FLOAT_EQ(share_within(0.0F, 0.48F, -0.64F, 0.25F), 0.5F);
    EXPECT_FLOAT_EQ(share_within(0.05F, 0.48F, -0.64F, 0.25F), 0.75F);
    EXPECT_EQ(share_within(0.1F, 0.48F, -0.64F, 0.25F), 1.0F);
    EXPECT_EQ(share_within(-0.11F, 0.48F, -0.64F, 0.25F), 0.0F);
}

}  // namespace
}  // namespace pastoso::shade
