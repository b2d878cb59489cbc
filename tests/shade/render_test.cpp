#include "shade/render.hpp"

#include "canvas.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "pigment/colour.hpp"
#include "shade/cell_layers.hpp"
#include "shade/shading_model.hpp"
#include "shade/tile_colour.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::shade {
namespace {

pigment::LinearImage picture(const film::FilmState& film, const RenderSettings& settings,
                             int threads = 1) {
    core::ThreadPool pool(threads);
    return render(film, test::kGround, film.shape.cells(), settings, pool);
}

const float* pixel(const pigment::LinearImage& image, int x, int y) {
    return image.rgb.data() + 3 * (static_cast<std::ptrdiff_t>(y) * image.width + x);
}

/// The shading equation as the textbooks write it, in double precision.
struct Reference {
    double roughness, slope_x, slope_y, sky;

    double operator()(double colour, const Lighting& lighting) const {
        const double azimuth = core::radians(lighting.azimuth_deg);
        const double elevation = core::radians(lighting.elevation_deg);
        const double light[3] = {std::cos(elevation) * std::cos(azimuth),
                                 -std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
        const double length = std::sqrt(1 + slope_x * slope_x + slope_y * slope_y);
        const double normal[3] = {-slope_x / length, -slope_y / length, 1 / length};
        const double half_length = std::hypot(light[0], light[1], light[2] + 1);
        double nl = 0, nh = 0;
        for (int i = 0; i < 3; ++i) {
            nl += normal[i] * light[i];
            nh += normal[i] * (light[i] + (i == 2 ? 1 : 0)) / half_length;
        }
        const double lit = std::max(nl, 0.0) * (1 - lighting.ambient) / light[2];
        const double highlight =
            lit * core::kPi * distribution(nh) * masking(nl) * fresnel(light[2], half_length);
        const double value =
            colour * (lit + lighting.ambient * sky) + (lighting.specular ? highlight : 0.0);
        return value <= 0.85 ? value : 0.85 + (value - 0.85) / (1 + (value - 0.85) / 0.15);
    }

    double distribution(double nh) const {
        const double a2 = roughness * roughness;
        const double d = nh * nh * (a2 - 1) + 1;
        return a2 / (core::kPi * d * d);
    }
    /// G / (4 n.l n.v) with Smith's height-correlated G = 1 / (1 + Lambda(l) + Lambda(v)).
    double masking(double nl) const {
        const double nv = 1 / std::sqrt(1 + slope_x * slope_x + slope_y * slope_y);
        const auto lambda = [this](double cosine) {
            const double tangent2 = 1 / (cosine * cosine) - 1;
            return 0.5 * (std::sqrt(1 + roughness * roughness * tangent2) - 1);
        };
        return 1 / (1 + lambda(nl) + lambda(nv)) / (4 * nl * nv);
    }
    static double fresnel(double light_z, double half_length) {
        return 0.04 + 0.96 * std::pow(1 - (light_z + 1) / half_length, 5);
    }
};

CellColour ground_colour() {
    const film::FilmState film(grid::Shape{1, 1}, 0.25);
    std::vector<CellColour> colours(grid::kTileCells);
    tile_colours(film, 0, test::kGround, colours.data());
    return colours[0];
}

TEST(Render, AFlatCanvasShowsItsColourTimesTheLight) {
    const film::FilmState film(grid::Shape{70, 40}, 0.25);
    RenderSettings settings;
    settings.lighting.specular = false;
    const CellColour ground = ground_colour();
    for (const double scale : {0.5, 1.0, 3.0}) {
        settings.scale = scale;
        const pigment::LinearImage image = picture(film, settings);
        ASSERT_EQ(image.width, 70 * scale);
        ASSERT_EQ(image.height, 40 * scale);
        for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
            // Without highlights an even light leaves every colour as it is.
            EXPECT_NEAR(image.rgb[i], ground.red, 1e-5F);
            EXPECT_NEAR(image.rgb[i + 1], ground.green, 1e-5F);
            EXPECT_NEAR(image.rgb[i + 2], ground.blue, 1e-5F);
        }
    }
}

TEST(Render, ALampShowsTheSamePaintInItsOwnLight) {
    const film::FilmState film(grid::Shape{70, 40}, 0.25);
    RenderSettings settings;
    settings.lighting.specular = false;
    settings.viewing =
        pigment::viewing_under(pigment::find_illuminant("A"), pigment::WorkingSpace::DisplayP3);
    std::vector<CellColour> colours(grid::kTileCells);
    tile_colours(film, 0, test::kGround, colours.data(), settings.viewing.to_rgb);
    const pigment::LinearImage image = picture(film, settings);
    EXPECT_EQ(image.space, pigment::WorkingSpace::DisplayP3);
    EXPECT_NEAR(image.rgb[0], colours[0].red, 1e-5F);
    EXPECT_NEAR(image.rgb[1], colours[0].green, 1e-5F);
    EXPECT_NEAR(image.rgb[2], colours[0].blue, 1e-5F);
    EXPECT_GT(std::abs(colours[0].blue - ground_colour().blue), 1e-3F);
}

TEST(Render, AFlatWetFilmAddsTheHighlight) {
    film::FilmState film(grid::Shape{20, 20}, 0.25);
    for (int i = 0; i < 400; ++i)
        test::set_paint(film, i % 20, i / 20, 1.0, test::kBlue);
    std::vector<CellColour> colours(grid::kTileCells);
    tile_colours(film, 0, test::kGround, colours.data());
    const RenderSettings settings;
    const pigment::LinearImage image = picture(film, settings);
    const Reference wet{settings.lighting.wet_roughness, 0.0, 0.0, 1.0};
    EXPECT_NEAR(pixel(image, 10, 10)[0], wet(colours[0].red, settings.lighting), 1e-5);
    EXPECT_NEAR(pixel(image, 10, 10)[2], wet(colours[0].blue, settings.lighting), 1e-5);
}

TEST(Render, TiltedPlanesFollowTheShadingEquation) {
    for (const auto& [slope_x, slope_y] :
         {std::pair{0.3, 0.1}, {-0.2, 0.4}, {0.5, -0.5}, {-0.1, -0.3}}) {
        film::FilmState film(grid::Shape{61, 61}, 0.25);
        test::set_support(film, [sx = slope_x, sy = slope_y](int x, int y) {
            return 20.0 + 0.25 * (sx * x + sy * y);
        });
        RenderSettings settings;
        settings.lighting.azimuth_deg = 160.0;
        const pigment::LinearImage image = picture(film, settings);
        core::ThreadPool pool(1);
        const CellLayers layers =
            cell_layers(film, test::kGround, film.shape.cells(), settings.lighting, pool);
        const Reference dry{settings.lighting.dry_roughness, slope_x, slope_y, layers.sky[30 * 61 + 30]};
        // Heights of 20 mm in single precision leave slopes to 1e-5.
        EXPECT_NEAR(pixel(image, 30, 30)[0], dry(ground_colour().red, settings.lighting), 1e-4);
        EXPECT_NEAR(pixel(image, 30, 30)[1], dry(ground_colour().green, settings.lighting), 1e-4);
    }
}

TEST(Render, AWallLeavesOnlyTheSkyInItsShadow) {
    film::FilmState film(grid::Shape{80, 40}, 0.25);
    test::set_support(film, [](int x, int) { return x < 40 ? 4.0 : 0.0; });
    RenderSettings settings;
    settings.lighting.azimuth_deg = 180.0;
    settings.lighting.elevation_deg = 30.0;
    settings.lighting.specular = false;
    const pigment::LinearImage image = picture(film, settings);
    // The shadow is 4 mm / tan 30 = 27.7 cells long; at 2 mm from the wall it sees all but half of the
    // sky.
    EXPECT_LE(pixel(image, 50, 20)[1], 0.31F * ground_colour().green);
    EXPECT_GE(pixel(image, 50, 20)[1], 0.14F * ground_colour().green);
    EXPECT_NEAR(pixel(image, 75, 20)[1], ground_colour().green, 1e-4F);
}

TEST(Render, AMirroredCanvasAndLightGiveTheMirroredPicture) {
    const film::FilmState film = test::random_canvas({60, 50}, 10);
    RenderSettings settings;
    settings.lighting.azimuth_deg = 130.0;
    const pigment::LinearImage image = picture(film, settings);
    settings.lighting.azimuth_deg = 50.0;
    const pigment::LinearImage reflected = picture(test::mirrored(film), settings);
    for (int y = 0; y < 50; ++y) {
        for (int x = 0; x < 60; ++x) {
            for (int channel = 0; channel < 3; ++channel) {
                // The sums run in the opposite order; the highlight is the most sensitive to a slope's
                // last bit.
                EXPECT_NEAR(pixel(image, x, y)[channel], pixel(reflected, 59 - x, y)[channel], 1e-4F);
            }
        }
    }
}

TEST(Render, AnyNumberOfThreadsGivesTheSameBits) {
    const film::FilmState film = test::random_canvas({200, 150}, 11);
    RenderSettings settings;
    settings.scale = 1.3;
    const pigment::LinearImage one = picture(film, settings, 1);
    EXPECT_EQ(one.rgb, picture(film, settings, 2).rgb);
    EXPECT_EQ(one.rgb, picture(film, settings, 3).rgb);
}

TEST(Render, APartIsAPartOfTheWhole) {
    const film::FilmState film = test::random_canvas({100, 90}, 12);
    const RenderSettings settings;
    const pigment::LinearImage whole = picture(film, settings);
    core::ThreadPool pool(1);
    const grid::Rect part{33, 20, 77, 66};
    const pigment::LinearImage cut = render(film, test::kGround, part, settings, pool);
    for (int y = part.y0; y < part.y1; ++y) {
        for (int x = part.x0; x < part.x1; ++x) {
            ASSERT_EQ(pixel(cut, x - part.x0, y - part.y0)[1], pixel(whole, x, y)[1]) << x << " " << y;
        }
    }
}

TEST(Render, HalfTheScaleIsTheMeanOfFourPixels) {
    const film::FilmState film = test::random_canvas({80, 60}, 13);
    RenderSettings settings;
    const pigment::LinearImage full = picture(film, settings);
    settings.scale = 0.5;
    const pigment::LinearImage half = picture(film, settings);
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
            const float mean =
                0.25F * (pixel(full, 2 * x, 2 * y)[0] + pixel(full, 2 * x + 1, 2 * y)[0] +
                         pixel(full, 2 * x, 2 * y + 1)[0] + pixel(full, 2 * x + 1, 2 * y + 1)[0]);
            EXPECT_NEAR(pixel(half, x, y)[0], mean, 1e-5F);
        }
    }
}

/// The largest second difference along the rows of a picture, away from its edges.
double largest_second_difference(const pigment::LinearImage& image) {
    double largest = 0.0;
    for (int y = image.height / 4; y < image.height * 3 / 4; ++y) {
        for (int x = image.width / 4; x < image.width * 3 / 4; ++x) {
            const double difference =
                pixel(image, x - 1, y)[1] - 2.0 * pixel(image, x, y)[1] + pixel(image, x + 1, y)[1];
            largest = std::max(largest, std::abs(difference));
        }
    }
    return largest;
}

TEST(Render, EnlargedColoursShowNoCells) {
    film::FilmState film(grid::Shape{40, 40}, 0.25);
    std::mt19937 random(14);
    for (int i = 0; i < 1600; ++i) {
        test::set_paint(film, i % 40, i / 40, 1.0,
                        random() % 2 == 0 ? test::kBlue : pigment::Coefficients{});
    }
    RenderSettings settings;
    settings.scale = 8.0;
    settings.lighting.elevation_deg = 90.0;
    settings.lighting.specular = false;
    // B-splines of values within [0, 0.8] have second derivatives of at most 2 * 0.8 per cell squared;
    // linear interpolation would give kinks of 2 * 0.8 / 8.
    EXPECT_LE(largest_second_difference(picture(film, settings)), 2 * 0.8 / 64.0);
}

TEST(Render, EnlargedReliefShowsNoCells) {
    film::FilmState film(grid::Shape{40, 40}, 0.25);
    for (int i = 0; i < 1600; ++i) {
        const double wave = std::sin(0.9 * (i % 40)) * std::cos(0.7 * (i / 40));
        test::set_paint(film, i % 40, i / 40, 0.5 + 0.1 * wave, test::kRed);
    }
    RenderSettings settings;
    settings.scale = 16.0;
    const double coarse = largest_second_difference(picture(film, settings));
    settings.scale = 32.0;
    const double fine = largest_second_difference(picture(film, settings));
    // Of a picture without kinks the second difference falls to a quarter when the pixels are halved, of
    // one with kinks to a half.
    EXPECT_LE(fine, 0.3 * coarse);
}

TEST(Render, HighlightsOnlyAddLight) {
    const film::FilmState film = test::random_canvas({40, 40}, 15);
    RenderSettings settings;
    const pigment::LinearImage shining = picture(film, settings);
    settings.lighting.specular = false;
    const pigment::LinearImage matt = picture(film, settings);
    float most = 0.0F;
    for (std::size_t i = 0; i < matt.rgb.size(); ++i) {
        EXPECT_GE(shining.rgb[i], matt.rgb[i]);
        EXPECT_LT(shining.rgb[i], 1.0F);
        most = std::max(most, shining.rgb[i] - matt.rgb[i]);
    }
    // Slopes of noise vary by more than the gloss within a cell: its highlights are broad.
    EXPECT_GE(most, 0.02F);
}

TEST(Render, RefusesSettingsOutOfRange) {
    const film::FilmState film(grid::Shape{10, 10}, 0.25);
    core::ThreadPool pool(1);
    RenderSettings settings;
    settings.scale = 0.0;
    EXPECT_THROW(render(film, test::kGround, {0, 0, 10, 10}, settings, pool), core::InputError);
    settings.scale = 1.0;
    EXPECT_THROW(render(film, test::kGround, {0, 0, 11, 10}, settings, pool), core::InputError);
    EXPECT_THROW(render(film, test::kGround, {5, 5, 5, 9}, settings, pool), core::InputError);
    settings.lighting.elevation_deg = 0.0;
    EXPECT_THROW(render(film, test::kGround, {0, 0, 10, 10}, settings, pool), core::InputError);
    settings.lighting.elevation_deg = std::nan("");
    EXPECT_THROW(render(film, test::kGround, {0, 0, 10, 10}, settings, pool), core::InputError);
}

}  // namespace
}  // namespace pastoso::shade
