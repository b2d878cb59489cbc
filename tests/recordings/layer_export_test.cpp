#include "recordings/layer_export.hpp"

#include "core/text_file.hpp"
#include "document/error_of.hpp"
#include "files/stored_image.hpp"
#include "files/temporary_folder.hpp"
#include "layers/apart.hpp"
#include "layers/clipping.hpp"
#include "recordings/channel_names.hpp"
#include "recordings/surface_values.hpp"
#include "shade/canvas.hpp"

#include <cmath>
#include <random>

#include <gmock/gmock.h>

namespace pastoso::recordings {
namespace {

using document::error_of;
using film::FilmState;
using testing::ElementsAre;
using testing::HasSubstr;
using Path = std::filesystem::path;

const files::KeepGoing kToTheEnd = [](double) { return true; };
constexpr grid::Shape kShape{90, 70};

/// Wet paint in about a third of the cells, on nothing.
FilmState random_paint(const pigment::Coefficients& paint, std::uint32_t seed) {
    FilmState film(kShape, 0.25);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int y = 0; y < kShape.height; ++y)
        for (int x = 0; x < kShape.width; ++x)
            if (share(random) < 0.3) test::set_paint(film, x, y, 0.5 * share(random), paint);
    return film;
}

FilmState smooth_paint(double thickness_mm) {
    FilmState film(kShape, 0.25);
    for (int y = 0; y < kShape.height; ++y)
        for (int x = 0; x < kShape.width; ++x)
            test::set_paint(film, x, y, thickness_mm + 0.1 * std::sin(0.1 * x + 0.07 * y), test::kBlue);
    return film;
}

/// Halves have 11 binary digits.
float half_step(float value) {
    return std::abs(value) * 0x1p-11F + 1e-7F;
}

std::shared_ptr<const FilmState> shared(const FilmState& film) {
    return std::make_shared<const FilmState>(film);
}

/// Three layers on an uneven support: one inactive, the active one, and a faded, hidden one above.
class LayerExport : public files::TemporaryFolder {
  protected:
    LayerExport() {
        FilmState ground(kShape, 0.25);
        test::set_support(ground, [](int x, int y) { return 0.125 * ((x / 3 + y / 5) % 2); });
        bare_mm = ground.support_mm;
        stack.layers[0].look.name = "Ground coat";
        stack.layers.push_back({.id = 2, .look = {.name = "Glaze"}});
        stack.layers.push_back({.id = 3,
                                .look = {.name = "Glaze", .visible = false, .opacity = 0.5},
                                .inactive = shared(upper)});
        stack.active = 1;
        lay_out();
    }

    void lay_out() {
        stack.layers[0].inactive = shared(lower);
        active = layers::laid_on(middle, document::base_below_active(stack, bare_mm));
        view = document::view_of(active, bare_mm, stack, pool);
    }

    files::ExportStatus write(const char* name, const files::KeepGoing& keep_going = kToTheEnd) {
        return export_layers(folder / name, source, document_layers(), pool, keep_going);
    }
    ChannelLayers document_layers() const { return channel_layers(active, bare_mm, stack); }

    /// What the renderer sees of a layer that lies on the support by itself.
    shade::SurfaceSamples surface_of(const FilmState& film, pigment::LinearImage* lit) {
        const shade::Lattice lattice = export_lattice(source);
        shade::SurfaceSamples samples;
        shade::Renderer(film, test::kGround, lattice, source.settings, pool)
            .render({0, 0, lattice.width, lattice.height}, lit, &samples);
        return samples;
    }

    void expect_layer(const files::StoredImage& file, const std::string& name, const FilmState& paint) {
        FilmState alone = paint;
        alone.support_mm = bare_mm;
        pigment::LinearImage lit;
        const shade::SurfaceSamples samples = surface_of(alone, &lit);
        for (int y = 0; y < kShape.height; y += 3) {
            for (int x = 0; x < kShape.width; ++x) {
                const auto i = static_cast<std::size_t>(y * kShape.width + x);
                const shade::SurfaceSample& sample = samples.samples[i];
                EXPECT_EQ(file.at(x, y, name + ".height_mm.V"), sample.height_mm);
                EXPECT_EQ(file.at(x, y, name + ".cover.A"), paint.thickness.at(x, y) > 0 ? 1.0F : 0.0F);
                const std::pair<const char*, float> halves[] = {
                    {".lit.R", lit.rgb[3 * i]},
                    {".lit.G", lit.rgb[3 * i + 1]},
                    {".albedo.R", sample.red},
                    {".albedo.B", sample.blue},
                    {".normal.Z", surface_normal(sample)[2]},
                    {".normal.Y", surface_normal(sample)[1]},
                    {".wetness.V", sample.wetness},
                    {".gloss.V", 1.0F - surface_roughness(sample, {})}};
                for (const auto& [channel, value] : halves) {
                    // Halves have 11 binary digits.
                    EXPECT_NEAR(file.at(x, y, name + channel), value, std::abs(value) * 0x1p-11F + 1e-7F)
                        << name << channel;
                }
            }
        }
    }

    core::ThreadPool pool{2};
    FilmState lower = random_paint(test::kBlue, 1), middle = random_paint(test::kRed, 2),
              upper = random_paint(test::kBlue, 3);
    film::SupportHeights bare_mm;
    document::LayerStack stack = document::single_layer();
    FilmState active, view;
    ExportSource source{view, test::kGround, {}};
};

TEST_F(LayerExport, EveryLayerHasItsOwnChannels) {
    ASSERT_EQ(write("a.exr"), files::ExportStatus::Written);
    const files::StoredImage file = files::stored_image(folder / "a.exr");
    EXPECT_EQ(file.spec.nchannels, 4 + 3 * 13);
    expect_layer(file, "Ground_coat", lower);
    expect_layer(file, "Glaze", middle);
    expect_layer(file, "Glaze_2", upper);
    const auto format = [&](const char* channel) {
        return file.spec.channelformat(file.spec.channelindex(channel));
    };
    EXPECT_EQ(format("Glaze.height_mm.V"), OIIO::TypeDesc::FLOAT);
    EXPECT_EQ(format("support.height_mm.V"), OIIO::TypeDesc::FLOAT);
    EXPECT_EQ(format("Glaze.albedo.G"), OIIO::TypeDesc::HALF);
    EXPECT_EQ(file.spec.get_string_attribute("ImageDescription"),
              "Lengths are in millimetres. Layers from below: Ground_coat is \"Ground coat\"; Glaze is "
              "\"Glaze\"; Glaze_2 is \"Glaze\", opacity 0.5, hidden.");
}

TEST_F(LayerExport, OfAClippedLayerOnlyWhatShowsIsThere) {
    stack.layers[1].look.clipped = true;
    lay_out();
    ASSERT_EQ(write("a.exr"), files::ExportStatus::Written);
    const files::StoredImage file = files::stored_image(folder / "a.exr");
    expect_layer(file, "Ground_coat", lower);
    expect_layer(file, "Glaze", layers::clipped(middle, lower).shown);
    EXPECT_THAT(file.spec.get_string_attribute("ImageDescription"),
                HasSubstr("Glaze is \"Glaze\", clipped; "));
}

TEST_F(LayerExport, ThePictureIsThatOfTheWholePainting) {
    ASSERT_EQ(write("a.exr"), files::ExportStatus::Written);
    const pigment::LinearImage lit =
        shade::render(view, test::kGround, kShape.cells(), source.settings, pool);
    const files::StoredImage file = files::stored_image(folder / "a.exr");
    for (int x = 0; x < kShape.width; ++x) {
        const float value = lit.rgb[static_cast<std::size_t>(3 * (33 * kShape.width + x))];
        EXPECT_NEAR(file.at(x, 33, "R"), value, half_step(value));
    }
    source.lit = false;
    ASSERT_EQ(write("b.exr"), files::ExportStatus::Written);
    pigment::LinearImage ignored;
    const shade::SurfaceSamples samples = surface_of(view, &ignored);
    const files::StoredImage flat = files::stored_image(folder / "b.exr");
    for (int x = 0; x < kShape.width; ++x) {
        const float value = samples.samples[static_cast<std::size_t>(33 * kShape.width + x)].green;
        EXPECT_NEAR(flat.at(x, 33, "G"), value, half_step(value));
    }
}

TEST_F(LayerExport, HeightsOfVisibleLayersAddUpToThePaintings) {
    // Away from the edges of paint, where the surface stays above the ground that it meets.
    lower = smooth_paint(0.2), middle = smooth_paint(0.35);
    lay_out();
    ASSERT_EQ(write("a.exr"), files::ExportStatus::Written);
    const files::StoredImage file = files::stored_image(folder / "a.exr");
    pigment::LinearImage ignored;
    const shade::SurfaceSamples whole = surface_of(view, &ignored);
    for (int y = 0; y < kShape.height; ++y) {
        for (int x = 0; x < kShape.width; ++x) {
            const float support_mm = file.at(x, y, "support.height_mm.V");
            const float sum_mm = file.at(x, y, "Ground_coat.height_mm.V") +
                                 file.at(x, y, "Glaze.height_mm.V") - support_mm;
            // Wet paint lies on wet paint in whole 2^-20 mm; the rest is rounding of floats near 1.
            EXPECT_NEAR(sum_mm, whole.samples[static_cast<std::size_t>(y * kShape.width + x)].height_mm,
                        2e-6);
        }
    }
}

TEST_F(LayerExport, CoverIsTheShareOfTheCellsBelowAPixel) {
    source.settings.scale = 0.5;
    ASSERT_EQ(write("a.exr"), files::ExportStatus::Written);
    const files::StoredImage file = files::stored_image(folder / "a.exr");
    for (int y = 0; y < 35; ++y) {
        for (int x = 0; x < 45; ++x) {
            int covered = 0;
            for (const auto& [right, down] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}})
                covered += middle.thickness.at(2 * x + right, 2 * y + down) > 0 ? 1 : 0;
            EXPECT_EQ(file.at(x, y, "Glaze.cover.A"), 0.25F * static_cast<float>(covered));
        }
    }
}

TEST_F(LayerExport, BandsAreThoseOfTheWhole) {
    ASSERT_EQ(write("a.exr"), files::ExportStatus::Written);
    const files::StoredImage small = files::stored_image(folder / "a.exr");
    // 11 pixels of a cell make 990 x 770 pixels: more than a band of 43 channels.
    source.settings.scale = 11.0;
    int bands = 0;
    ASSERT_EQ(write("b.exr", [&](double) { return ++bands > 0; }), files::ExportStatus::Written);
    EXPECT_GT(bands, 2);
    const files::StoredImage large = files::stored_image(folder / "b.exr");
    EXPECT_EQ(large.spec.height, 770);
    EXPECT_EQ(large.at(984, 764, "Glaze.cover.A"), small.at(89, 69, "Glaze.cover.A"));
}

TEST_F(LayerExport, AStoppedExportLeavesTheOldFile) {
    core::write_text_file(folder / "a.exr", "old");
    int asked = 0;
    EXPECT_EQ(write("a.exr", [&](double) { return ++asked < 2; }), files::ExportStatus::Stopped);
    EXPECT_EQ(core::read_text_file(folder / "a.exr"), "old");
    EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(LayerExport, OtherFormatsAreRefused) {
    EXPECT_THAT(error_of([&] { write("a.tif"); }), HasSubstr("a.tif: only .exr files hold"));
    EXPECT_EQ(files_in_folder(), 0U);
}

TEST(ChannelNames, AreSafeAndUnique) {
    EXPECT_THAT(channel_names({"Sky & sea", "sky sea", "Sky/sea!", "3rd", " .lit.R", "\xE7\xA9\xBA",
                               "Support", "", "B\xC3\xA4ume"}),
                ElementsAre("Sky_sea", "sky_sea_2", "Sky_sea_3", "_3rd", "lit_R", "layer_6", "Support_2",
                            "layer_8", "B_ume"));
    const std::string two_hundred(200, 'a');
    EXPECT_THAT(channel_names({two_hundred, two_hundred}),
                ElementsAre(std::string(60, 'a'), std::string(60, 'a') + "_2"));
}

}  // namespace
}  // namespace pastoso::recordings
