#include "tools/export_settings.hpp"

#include "core/error.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"
#include "tools/export_names.hpp"

#include <gmock/gmock.h>

namespace pastoso::tools {
namespace {

using testing::HasSubstr;
using Path = std::filesystem::path;

constexpr ExportForm kAllForms[] = {ExportForm::Picture, ExportForm::Layers, ExportForm::Maps,
                                    ExportForm::Relief, ExportForm::Timelapse};

std::size_t number_of(ExportForm form, const std::string& name) {
    const auto formats = export_formats(form);
    for (std::size_t i = 0; i < formats.size(); ++i)
        if (name == formats[i].name) return i;
    ADD_FAILURE() << name;
    return 0;
}

const ExportFormat& format_named(ExportForm form, const std::string& name) {
    return export_formats(form)[number_of(form, name)];
}

class ExportSettingsTest : public ::testing::Test {
  protected:
    Path file() const { return folder_.path() / "export.json"; }

    std::string fault_of(const std::string& what, const std::string& instead) {
        write_export_settings({}, file());
        std::string text = core::read_text_file(file());
        const std::size_t place = text.find(what);
        EXPECT_NE(place, std::string::npos) << what << " in " << text;
        core::write_text_file(file(), text.replace(place, what.size(), instead));
        try {
            read_export_settings(file());
        } catch (const core::InputError& error) {
            return error.what();
        }
        return "";
    }

    tests::TemporaryFolder folder_;
};

TEST_F(ExportSettingsTest, ComeBackAsTheyWereWritten) {
    ExportSettings settings;
    settings.form = ExportForm::Relief;
    settings.formats = {5, 0, 3, 2, 4};
    settings.folder = "/home/painter/Näh";
    settings.of_well = true;
    settings.lit = false;
    settings.scale = 1.0 / 3.0;
    settings.profile = "/usr/share/color/press.icc";
    settings.quality = 71;
    settings.relief = {3.5, 2.25, 0.125};
    settings.fps = 60.0;
    settings.speed = 250.0;
    settings.film_px_per_mm = 8.0;
    write_export_settings(settings, file());
    EXPECT_EQ(read_export_settings(file()), settings);
}

TEST_F(ExportSettingsTest, AreTheFirstOnesWhereThereIsNoFile) {
    EXPECT_EQ(read_export_settings(file()), ExportSettings{});
}

TEST_F(ExportSettingsTest, FaultsAreToldWithTheirPlace) {
    const std::string name = file().string();
    EXPECT_EQ(fault_of("\"form\": \"picture\"", "\"form\": \"poem\""),
              name + ", form: \"poem\" is not one of picture, layers, maps, relief, timelapse.");
    EXPECT_EQ(fault_of("\"stl\"", "\"png8\""),
              name + ", formats.relief: \"png8\" is not one of stl, ply, obj.");
    EXPECT_EQ(fault_of("\"scale\": 1.0", "\"scale\": 65"),
              name + ", scale: 65 is not from 0.0625 to 64.0.");
    EXPECT_EQ(fault_of("\"base_mm\": 2.0", "\"base_mm\": 0"),
              name + ", relief.base_mm: 0 is not from 0.1 to 100.0.");
    EXPECT_EQ(fault_of("\"fps\": 25.0", "\"fps\": 0.5"),
              name + ", timelapse.fps: 0.5 is not from 1.0 to 120.0.");
    EXPECT_THAT(fault_of("\"quality\": 95", "\"quality\": 101"), HasSubstr(name + ", quality: "));
    EXPECT_THAT(fault_of("\"lit\": true", "\"lit\": 1"), HasSubstr(", lit: expected true or false"));
    EXPECT_THAT(fault_of("\"version\": 1", "\"version\": 2"), HasSubstr(", version: "));
    EXPECT_THAT(fault_of("\"folder\"", "\"shelf\""), HasSubstr("shelf"));
    EXPECT_THAT(fault_of("{", "["), HasSubstr("this is not valid JSON"));
}

TEST(ExportChoice, SaysWhatTheSettingsSay) {
    ExportSettings settings;
    settings.form = ExportForm::Picture;
    settings.formats[0] = number_of(ExportForm::Picture, "tiff16");
    settings.of_well = true;
    settings.lit = false;
    settings.scale = 2.5;
    settings.profile = "display-p3";
    settings.quality = 60;
    ExportLight light;
    light.light = "A";
    light.lighting.azimuth_deg = 20.0;
    recordings::ExportChoice choice = export_choice(settings, "/a/b.tif", light);
    EXPECT_EQ(choice.kind, recordings::ExportKind::Picture);
    EXPECT_EQ(choice.path, "/a/b.tif");
    EXPECT_TRUE(choice.of_well);
    EXPECT_FALSE(choice.lit);
    EXPECT_EQ(choice.scale, 2.5);
    EXPECT_EQ(choice.picture.light, "A");
    EXPECT_EQ(choice.picture.profile, "display-p3");
    EXPECT_EQ(choice.picture.depth_bits, 16);
    EXPECT_EQ(choice.picture.quality, 60);
    EXPECT_EQ(choice.lighting.azimuth_deg, 20.0);

    settings.form = ExportForm::Relief;
    settings.relief.base_mm = 7.0;
    choice = export_choice(settings, "/a/b.stl", light);
    EXPECT_EQ(choice.kind, recordings::ExportKind::Relief);
    EXPECT_FALSE(choice.of_well) << "only pictures are made of the well";
    EXPECT_EQ(choice.relief, settings.relief);
}

TEST(ExportChoice, AVideoHasItsOwnColours) {
    ExportSettings settings;
    settings.form = ExportForm::Timelapse;
    settings.profile = "/gone.icc";
    settings.fps = 30.0;
    settings.speed = 4.0;
    settings.formats[4] = number_of(ExportForm::Timelapse, "frames16");
    recordings::TimelapseChoice choice = timelapse_choice(settings, "/a/frames", {});
    EXPECT_EQ(choice.picture.profile, "/gone.icc");
    EXPECT_EQ(choice.picture.depth_bits, 16);
    EXPECT_EQ(choice.fps, 30.0);
    EXPECT_EQ(choice.speed, 4.0);
    EXPECT_EQ(choice.px_per_mm, std::nullopt);
    settings.film_px_per_mm = 6.0;
    EXPECT_EQ(timelapse_choice(settings, "film", {}).px_per_mm, 6.0);
    settings.formats[4] = number_of(ExportForm::Timelapse, "mp4");
    choice = timelapse_choice(settings, "/a/film.mp4", {});
    EXPECT_EQ(choice.picture.profile, "srgb");
    EXPECT_EQ(choice.picture.depth_bits, 8);
}

TEST(ExportNames, EndAsTheFormatDoes) {
    const ExportFormat& png = format_named(ExportForm::Picture, "png16");
    const ExportFormat& tiff = format_named(ExportForm::Picture, "tiff8");
    const ExportFormat& frames = format_named(ExportForm::Timelapse, "frames8");
    EXPECT_EQ(with_ending("/a/sun", png), Path("/a/sun.png"));
    EXPECT_EQ(with_ending("/a/sun.stl", png), Path("/a/sun.png"));
    EXPECT_EQ(with_ending("/a/sun.PNG", png), Path("/a/sun.PNG"));
    EXPECT_EQ(with_ending("/a/sun.tiff", tiff), Path("/a/sun.tiff"));
    EXPECT_EQ(with_ending("/a/sun.v2", png), Path("/a/sun.v2.png"));
    EXPECT_EQ(with_ending("/a.png/sun", png), Path("/a.png/sun.png"));
    EXPECT_EQ(with_ending("/a/sun.mp4", frames), Path("/a/sun"));
    EXPECT_EQ(with_ending("/a/sun.v2", frames), Path("/a/sun.v2"));
}

TEST(ExportNames, ATypedEndingAsksForItsFormat) {
    const auto asked = [](const char* name, const char* present, ExportForm form) -> std::string {
        const auto format = format_of(name, form, number_of(form, present));
        return format ? export_formats(form)[*format].name : "none";
    };
    EXPECT_EQ(asked("a.jpeg", "png16", ExportForm::Picture), "jpeg");
    EXPECT_EQ(asked("a.png", "png16", ExportForm::Picture), "png16");
    EXPECT_EQ(asked("a.png", "exr", ExportForm::Picture), "png8");
    EXPECT_EQ(asked("a.stl", "exr", ExportForm::Picture), "none");
    EXPECT_EQ(asked("a", "mp4", ExportForm::Timelapse), "none");
    EXPECT_EQ(asked("a.webm", "frames8", ExportForm::Timelapse), "webm");
}

TEST(ExportNames, AFreeNameIsFound) {
    const tests::TemporaryFolder folder;
    const Path png = folder.path() / "a.png";
    EXPECT_EQ(untaken(png, ExportForm::Picture), png);
    core::write_text_file(png, "old");
    core::write_text_file(folder.path() / "a-2.png", "old");
    EXPECT_EQ(untaken(png, ExportForm::Picture), folder.path() / "a-3.png");
    EXPECT_FALSE(is_taken(png, ExportForm::Maps)) << "maps have names of their own";
    core::write_text_file(folder.path() / "a-height.png", "old");
    EXPECT_TRUE(is_taken(png, ExportForm::Maps));
    std::filesystem::create_directory(folder.path() / "frames");
    EXPECT_EQ(untaken(folder.path() / "frames", ExportForm::Timelapse), folder.path() / "frames-2");
}

TEST(ExportFormats, EveryEndingIsOneOfItsForm) {
    for (const ExportForm form : kAllForms) {
        for (const ExportFormat& format : export_formats(form)) {
            const Path path = with_ending("a", format);
            const std::size_t number = number_of(form, format.name);
            if (path.has_extension()) {
                EXPECT_EQ(format_of(path, form, number), number) << format.name;
            }
            EXPECT_EQ(with_ending(path, format), path);
        }
    }
}

}  // namespace
}  // namespace pastoso::tools
