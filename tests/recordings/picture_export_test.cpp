#include "recordings/picture_export.hpp"

#include "core/text_file.hpp"
#include "document/error_of.hpp"
#include "files/image.hpp"
#include "files/temporary_folder.hpp"
#include "recordings/map_export.hpp"
#include "recordings/surface_values.hpp"
#include "shade/canvas.hpp"
#include "files/stored_image.hpp"

#include <cmath>

#include <gmock/gmock.h>

namespace pastoso::recordings {
namespace {

using document::error_of;
using pigment::WorkingSpace;
using testing::HasSubstr;
using Path = std::filesystem::path;

const files::KeepGoing kToTheEnd = [](double) { return true; };

class ExportTest : public files::TemporaryFolder {
  protected:
    core::ThreadPool pool{2};
    film::FilmState film = test::random_canvas({90, 70}, 3);
    ExportSource source{film, test::kGround, {}};

    Path path(const char* name) const { return folder / name; }
    std::string bytes(const char* name) const { return core::read_text_file(folder / name); }

    pigment::LinearImage picture() {
        return shade::render(film, test::kGround, film.shape.cells(), source.settings, pool);
    }
    shade::SurfaceSamples surface() {
        const shade::Lattice lattice = export_lattice(source);
        shade::SurfaceSamples samples;
        shade::Renderer(film, test::kGround, lattice, source.settings, pool)
            .render({0, 0, lattice.width, lattice.height}, nullptr, &samples);
        return samples;
    }
};

/// Makes 1800 x 1400 pixels of the canvas below.
constexpr double kTwoBands = 20.0;

TEST_F(ExportTest, FilesOfBandsAreThoseOfTheWholePicture) {
    source.settings.scale = kTwoBands;
    for (const char* name : {"a.png", "a.jpg"}) {
        ASSERT_EQ(export_picture(path(name), source, {}, pool, kToTheEnd), files::ExportStatus::Written);
        const std::string in_bands = bytes(name);
        files::write_picture(path(name), picture(), {}, export_px_per_mm(source));
        EXPECT_TRUE(in_bands == bytes(name)) << name;
    }
}

TEST_F(ExportTest, TiffHoldsLinearLightInSinglePrecision) {
    ASSERT_EQ(export_picture(path("a.tif"), source, {32, {}}, pool, kToTheEnd),
              files::ExportStatus::Written);
    const files::StoredImage back = files::stored_image(path("a.tif"));
    EXPECT_EQ(back.spec.format, OIIO::TypeDesc::FLOAT);
    EXPECT_EQ(back.values, picture().rgb);
    EXPECT_THAT(bytes("a.tif"), HasSubstr(files::linear_icc_profile(WorkingSpace::Srgb)));
    // By way of the profile, whose primaries are rounded to 2^-16.
    EXPECT_THAT(files::read_colour_image(path("a.tif")).rgb,
                testing::Pointwise(testing::FloatNear(2e-3F), picture().rgb));
}

TEST_F(ExportTest, WebpIsNearAndHoldsTheProfile) {
    for (const WorkingSpace space : {WorkingSpace::Srgb, WorkingSpace::DisplayP3}) {
        const pigment::LinearImage even{33, 17, std::vector<float>(33 * 17 * 3, 0.25F), space};
        files::write_picture(path("a.webp"), even, {});
        EXPECT_THAT(bytes("a.webp"), HasSubstr(files::icc_profile(space)));
        const std::string file = bytes("a.webp");
        const auto* head = reinterpret_cast<const unsigned char*>(file.data());
        EXPECT_EQ(head[4] + 256 * head[5] + 65536 * head[6], static_cast<int>(file.size()) - 8);
        const files::StoredImage back = files::stored_image(path("a.webp"));
        ASSERT_EQ(back.spec.width, 33);
        ASSERT_EQ(back.spec.height, 17);
        // Lossy: sRGB 0.537 within two steps of 255.
        EXPECT_NEAR(back.values[300], 0.537, 2.0 / 255.0);
    }
}

TEST_F(ExportTest, QualityDecidesOnTheSize) {
    for (const char* name : {"a.jpg", "a.webp"}) {
        files::write_picture(path(name), picture(), {8, {}, 95});
        const std::size_t fine = bytes(name).size();
        files::write_picture(path(name), picture(), {8, {}, 30});
        EXPECT_LT(bytes(name).size(), fine * 2 / 3) << name;
    }
}

TEST_F(ExportTest, WithoutLightThePictureHasThePaintsOwnColours) {
    source.lit = false;
    ASSERT_EQ(export_picture(path("a.tif"), source, {32, {}}, pool, kToTheEnd),
              files::ExportStatus::Written);
    const files::StoredImage back = files::stored_image(path("a.tif"));
    const shade::SurfaceSamples samples = surface();
    ASSERT_EQ(back.values.size(), 3 * samples.samples.size());
    for (std::size_t i = 0; i < samples.samples.size(); ++i) {
        EXPECT_EQ(back.values[3 * i], samples.samples[i].red);
        EXPECT_EQ(back.values[3 * i + 2], samples.samples[i].blue);
    }
}

TEST_F(ExportTest, MapsTellTheSurface) {
    MapHeights heights;
    ASSERT_EQ(export_maps(path("a.png"), source, {16, {}}, pool, kToTheEnd, &heights),
              files::ExportStatus::Written);
    const files::StoredImage normal = files::stored_image(path("a-normal.png")),
                             height = files::stored_image(path("a-height.png")),
                             roughness = files::stored_image(path("a-roughness.png"));
    const shade::SurfaceSamples samples = surface();
    const double range_mm = heights.white_mm - heights.black_mm;
    for (std::size_t i = 0; i < samples.samples.size(); ++i) {
        const shade::SurfaceSample& sample = samples.samples[i];
        // Half a step of 65535, and floats.
        ASSERT_GT(sample.height_mm, heights.black_mm);
        ASSERT_LT(sample.height_mm, heights.white_mm);
        EXPECT_NEAR(heights.black_mm + range_mm * height.values[i], sample.height_mm, range_mm * 8e-6);
        EXPECT_NEAR(roughness.values[i], surface_roughness(sample, {}), 8e-6);
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(2 * normal.values[3 * i + k] - 1, surface_normal(sample)[k], 16e-6);
    }
    EXPECT_THAT(height.spec.get_string_attribute("ImageDescription"),
                testing::StartsWith("Height: 0 is "));
    EXPECT_EQ(normal.spec.find_attribute("ICCProfile"), nullptr);
    const auto colour = files::read_colour_image(path("a-basecolor.png"));
    EXPECT_EQ(colour.width, 90);
}

TEST_F(ExportTest, NormalsPointUpThePictureWhereTheCanvasRisesDownwards) {
    test::set_support(film, [](int, int y) { return 0.25 * y; });  // 45 degrees
    ASSERT_EQ(export_maps(path("a.exr"), source, {}, pool, kToTheEnd), files::ExportStatus::Written);
    film.thickness = grid::TiledField<std::int32_t>(film.shape);
    ASSERT_EQ(export_maps(path("a.exr"), source, {}, pool, kToTheEnd), files::ExportStatus::Written);
    const files::StoredImage normal = files::stored_image(path("a-normal.exr"));
    // Rising downwards, the surface looks upwards: +Y. Halves near 1.
    EXPECT_NEAR(normal.at(40, 30, "R"), 0.5, 1e-3);
    EXPECT_NEAR(normal.at(40, 30, "G"), 0.5 + 0.5 * std::sqrt(0.5), 1e-3);
    EXPECT_NEAR(normal.at(40, 30, "B"), 0.5 + 0.5 * std::sqrt(0.5), 1e-3);
    // Millimetres in single precision: exact multiples of 1/8 here, but for rounding.
    EXPECT_NEAR(files::stored_image(path("a-height.exr")).values[90 * 30 + 40], 0.25 * 30, 1e-5);
}

TEST_F(ExportTest, AStoppedExportLeavesEverythingAsItWas) {
    for (const char* name : {"a.jpg", "a-height.png"})
        core::write_text_file(path(name), "old");
    int asked = 0;
    const files::KeepGoing once = [&](double) { return ++asked < 2; };
    // Between two bands, and after the last.
    source.settings.scale = kTwoBands;
    EXPECT_EQ(export_picture(path("a.jpg"), source, {}, pool, once), files::ExportStatus::Stopped);
    source.settings.scale = 1.0;
    asked = 0;
    EXPECT_EQ(export_maps(path("a.png"), source, {}, pool, once), files::ExportStatus::Stopped);
    EXPECT_EQ(bytes("a.jpg"), "old");
    EXPECT_EQ(bytes("a-height.png"), "old");
    EXPECT_EQ(files_in_folder(), 2U);
}

TEST_F(ExportTest, RefusesWhatFormatsDoNotHold) {
    EXPECT_THAT(error_of([&] {
                    files::check_picture_path(path("a.png"), {32, {}});
                }),
                HasSubstr("a.png: .png files do not hold 32-bit pictures."));
    EXPECT_THAT(error_of([&] { check_map_paths(path("a.jpg"), {}); }),
                HasSubstr("a.jpg: maps are saved as .png, .tif or .exr"));
    source.settings.scale = 200.0 / 90.0 * 64.0;
    EXPECT_THAT(error_of([&] { export_picture(path("a.png"), source, {}, pool, kToTheEnd); }),
                HasSubstr("outside the range from 1/64 to 64"));
    files::ImageLayout wide;
    wide.width = 20000;
    wide.height = 1;
    EXPECT_THAT(error_of([&] { files::check_layout(path("a.webp"), wide); }),
                HasSubstr("a.webp: .webp files hold at most 16383 pixels a side; this picture has "
                          "20000 x 1."));
    EXPECT_EQ(files_in_folder(), 0U);
}

}  // namespace
}  // namespace pastoso::recordings
