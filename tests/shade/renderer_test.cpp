#include "canvas.hpp"
#include "core/error.hpp"
#include "shade/render.hpp"

#include <cstring>

#include <gtest/gtest.h>

namespace pastoso::shade {
namespace {

/// The pictures' values of a rectangle, part by part.
template <class Value>
void put(const std::vector<Value>& part, const grid::Rect& pixels, int values, int width,
         std::vector<Value>& whole) {
    const auto row = static_cast<std::ptrdiff_t>(values) * pixels.width();
    for (int y = pixels.y0; y < pixels.y1; ++y) {
        std::copy_n(part.begin() + (y - pixels.y0) * row, row,
                    whole.begin() + values * (static_cast<std::ptrdiff_t>(y) * width + pixels.x0));
    }
}

bool same_bits(const SurfaceSamples& a, const SurfaceSamples& b) {
    return a.samples.size() == b.samples.size() &&
           std::memcmp(a.samples.data(), b.samples.data(), a.samples.size() * sizeof(SurfaceSample)) ==
               0;
}

TEST(Renderer, PartsHaveTheBitsOfTheWhole) {
    const film::FilmState film = test::random_canvas({150, 90}, 7);
    core::ThreadPool pool(2);
    for (const double scale : {0.3, 1.0, 2.7}) {
        RenderSettings settings;
        settings.scale = scale;
        const Lattice lattice = picture_lattice(film.shape, film.shape.cells(), scale);
        const Renderer renderer(film, test::kGround, lattice, settings, pool);
        const grid::Rect all{0, 0, lattice.width, lattice.height};
        pigment::LinearImage whole, lit;
        SurfaceSamples whole_surface, surface;
        renderer.render(all, &whole, &whole_surface);
        EXPECT_EQ(whole.rgb, render(film, test::kGround, film.shape.cells(), settings, pool).rgb);
        pigment::LinearImage joined = whole;
        SurfaceSamples joined_surface = whole_surface;
        joined.rgb.assign(whole.rgb.size(), -1.0F);
        joined_surface.samples.assign(whole_surface.samples.size(), SurfaceSample{});
        for (int y = 0; y < lattice.height; y += 13) {
            for (int x = 0; x < lattice.width; x += 29) {
                const grid::Rect part = grid::intersection(all, {x, y, x + 29, y + 13});
                renderer.render(part, &lit, &surface);
                put(lit.rgb, part, 3, lattice.width, joined.rgb);
                put(surface.samples, part, 1, lattice.width, joined_surface.samples);
            }
        }
        EXPECT_EQ(joined.rgb, whole.rgb) << scale;
        EXPECT_TRUE(same_bits(joined_surface, whole_surface)) << scale;
    }
}

TEST(Renderer, SamplesOfAnInclineTellItsHeightAndSlope) {
    film::FilmState film({40, 30}, 0.5);
    test::set_support(film, [](int x, int y) { return 0.02 * (x + 0.5) + 0.05 * (y + 0.5); });
    core::ThreadPool pool(1);
    const Lattice lattice = picture_lattice(film.shape, film.shape.cells(), 2.0);
    SurfaceSamples surface;
    Renderer(film, test::kGround, lattice, {}, pool)
        .render({0, 0, lattice.width, lattice.height}, nullptr, &surface);
    // Away from the edges, where the cells beyond repeat the last; floats of numbers near 1.
    for (int y = 10; y < 50; ++y) {
        for (int x = 10; x < 70; ++x) {
            const SurfaceSample& sample = surface.samples[static_cast<std::size_t>(y) * 80 + x];
            EXPECT_NEAR(sample.height_mm, 0.02 * 0.5 * (x + 0.5) + 0.05 * 0.5 * (y + 0.5), 1e-6);
            EXPECT_NEAR(sample.slope_x, 0.04, 2e-6);
            EXPECT_NEAR(sample.slope_y, 0.10, 2e-6);
            EXPECT_EQ(sample.wetness, 0.0F);
        }
    }
}

TEST(Renderer, ColoursWithoutLightAreThoseOfTheCells) {
    film::FilmState film({24, 24}, 0.25);
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 24; ++x)
            test::set_paint(film, x, y, 0.5, test::kBlue);
    core::ThreadPool pool(1);
    pigment::LinearImage lit;
    SurfaceSamples surface;
    RenderSettings settings;
    settings.lighting.specular = false;
    const Lattice lattice = picture_lattice(film.shape, film.shape.cells(), 1.0);
    Renderer(film, test::kGround, lattice, settings, pool).render({4, 4, 8, 8}, &lit, &surface);
    // A flat matt canvas shows its colours as they are (shading_model.hpp), but for rounding.
    for (std::size_t i = 0; i < surface.samples.size(); ++i) {
        EXPECT_NEAR(surface.samples[i].red, lit.rgb[3 * i], 1e-6);
        EXPECT_NEAR(surface.samples[i].blue, lit.rgb[3 * i + 2], 1e-6);
        EXPECT_EQ(surface.samples[i].wetness, 1.0F);
    }
}

TEST(Renderer, RefusesSidesThatNoFileHolds) {
    EXPECT_THROW(picture_lattice({1000, 10}, {0, 0, 1000, 10}, 33.0), core::InputError);
    EXPECT_EQ(picture_lattice({1024, 10}, {0, 0, 1024, 10}, 32.0).width, 32768);
}

}  // namespace
}  // namespace pastoso::shade
