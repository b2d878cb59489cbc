#include "project/import_open_raster.hpp"

#include "core/error.hpp"
#include "core/temporary_folder.hpp"
#include "document/layered_canvas.hpp"
#include "document/player.hpp"
#include "files/image.hpp"
#include "pigment/lab.hpp"
#include "project/archives.hpp"
#include "project/paintings.hpp"
#include "project/stack_reader.hpp"
#include "shade/render.hpp"

#include <algorithm>

#include <gmock/gmock.h>

namespace pastoso::project {
namespace {

using testing::HasSubstr;

std::string png_of(int width, int height, const std::array<std::uint8_t, 4>& colour) {
    pigment::Picture picture{width, height, {}};
    for (int i = 0; i < width * height; ++i)
        picture.rgba.insert(picture.rgba.end(), colour.begin(), colour.end());
    return files::png_file(picture);
}

Entries small_file() {
    return {
        {"mimetype", "image/openraster"},
        {"stack.xml",
         "<image w='30' h='20' xres='25.4' yres='25.4'><stack>"
         "<stack name='Group' opacity='0.5'><layer name='Red' src='data/red.png' x='5' y='5'/></stack>"
         "<layer name='Grey' src='data/grey.png' visibility='hidden'/></stack></image>"},
        {"data/red.png", png_of(10, 10, {220, 30, 20, 255})},
        {"data/grey.png", png_of(30, 20, {90, 90, 90, 255})}};
}

class ImportOpenRaster : public testing::Test {
  protected:
    LoadedProject import(const Bytes& file, ImportSettings settings = {}) {
        return parse_open_raster(file, "a.ora", settings, pool);
    }
    std::string error_of(const Entries& entries) {
        try {
            import(archive_of(entries));
        } catch (const core::InputError& error) {
            return error.what();
        }
        return "";
    }

    core::ThreadPool pool{2};
    tests::TemporaryFolder folder;
};

TEST_F(ImportOpenRaster, MakesALayerOfPaintOfEveryLayer) {
    const LoadedProject project = import(archive_of(small_file()));
    const document::LayerStack& stack = project.painting.value.layers;
    EXPECT_EQ(project.painting.value.bare->settings.width_mm, 30.0);
    EXPECT_EQ(project.painting.value.bare->settings.height_mm, 20.0);
    ASSERT_EQ(stack.layers.size(), 2U);
    EXPECT_EQ(stack.layers[0].look, (document::LayerLook{.name = "Grey", .visible = false}));
    EXPECT_EQ(stack.layers[1].look, (document::LayerLook{.name = "Red"}));
    ASSERT_EQ(stack.groups.size(), 1U);
    EXPECT_EQ(stack.groups[0].look, (document::LayerLook{.name = "Group", .opacity = 0.5}));
    EXPECT_EQ(stack.layers[1].group, stack.groups[0].id);
    const document::LayerFilms films = document::layers_apart(
        project.painting.value.film, project.painting.value.bare->support_mm, stack);
    // 4 cells per mm: the red square covers 5 to 15 mm.
    EXPECT_EQ(films[1]->support_mm.at(19, 19), 0.0F);
    EXPECT_GT(films[1]->support_mm.at(20, 20), 0.0F);
    EXPECT_GT(films[1]->support_mm.at(59, 59), 0.0F);
    EXPECT_EQ(films[1]->support_mm.at(60, 60), 0.0F);
}

TEST_F(ImportOpenRaster, HonoursProfiles) {
    const auto first_pixel = [&](const std::string& png) {
        Entries entries = small_file();
        for (auto& [name, content] : entries)
            if (name == "data/red.png") content = png;
        const LoadedProject project = import(archive_of(entries));
        for (const document::Event& event : project.strokes.events)
            if (const auto* paint = std::get_if<document::PaintPicture>(&event.action))
                if (paint->name == "Red") return paint->picture->rgba;
        return std::vector<std::uint8_t>{};
    };
    const std::string wide =
        files::png_file(pigment::Image8{1, 1, {200, 60, 50}, pigment::WorkingSpace::DisplayP3});
    EXPECT_EQ(first_pixel(wide), files::decode_png_to_srgb(wide).rgba);
    EXPECT_NE(first_pixel(wide), files::decode_png(wide).rgba);
}

TEST_F(ImportOpenRaster, IsRecordedSoThatItCanBePaintedAgain) {
    const LoadedProject project = import(archive_of(small_file()));
    document::Painting painting(project.strokes.canvas, pool);
    document::Player player(painting, project.strokes);
    while (!player.finished())
        player.play_tick();
    EXPECT_EQ(painting.state_hash(), document::state_hash(project.painting));
    EXPECT_LT(painting.account().volume_error_rel(), 1e-9);
    EXPECT_LT(painting.account().pigment_error_rel(), 1e-9);
}

TEST_F(ImportOpenRaster, BringsOurOwnPaintingsBackAsTheyLook) {
    const Project before = busy_project(pool);
    Entries entries = entries_of(file_of(before, folder.path(), pool));
    std::erase_if(entries, [](const auto& entry) { return entry.first.starts_with("pastoso/"); });
    ImportSettings settings;
    settings.px_per_mm = before.painting.value.bare->settings.px_per_mm;
    settings.support = "panel";
    const LoadedProject after = import(archive_of(entries), settings);
    const auto picture = [&](const document::PaintingState& painting) {
        const film::FilmState film = document::view_of(
            painting.value.film, painting.value.bare->support_mm, painting.value.layers, pool);
        return shade::render(film, document::kPrimedGround, film.shape.cells(), {}, pool);
    };
    const pigment::LinearImage a = picture(before.painting), b = picture(after.painting);
    ASSERT_EQ(a.rgb.size(), b.rgb.size());
    std::vector<double> differences;
    for (std::size_t i = 0; i < a.rgb.size(); i += 3)
        differences.push_back(
            pigment::ciede2000(pigment::lab(pigment::LinearRgb{a.rgb[i], a.rgb[i + 1], a.rgb[i + 2]}),
                               pigment::lab(pigment::LinearRgb{b.rgb[i], b.rgb[i + 1], b.rgb[i + 2]})));
    std::sort(differences.begin(), differences.end());
    // White of the screen becomes the white of paint, 0.955 of it, which is about 1; the sheen of dry
    // paint lies over darks besides.
    EXPECT_LT(differences[differences.size() / 2], 2.0);
    EXPECT_LT(differences[differences.size() * 95 / 100], 6.0);
}

TEST_F(ImportOpenRaster, LoadsWhatIsOurOwn) {
    const Project before = busy_project(pool);
    const auto path = folder.path() / "mine.ora";
    save_project(path, before, pool);
    EXPECT_EQ(document::state_hash(import_open_raster(path, {}, pool).painting),
              document::state_hash(before.painting));
}

TEST_F(ImportOpenRaster, WithoutLayersIsABareCanvas) {
    const LoadedProject project =
        import(archive_of({{"stack.xml", "<image w='30' h='20'><stack/></image>"}}));
    EXPECT_EQ(project.painting.value.layers.layers.size(), 1U);
    EXPECT_EQ(project.painting.value.bare->settings.width_mm, kImportedSide_mm);
    EXPECT_EQ(project.painting.value.bare->settings.height_mm, 200.0);
}

TEST_F(ImportOpenRaster, RefusesDamagedAndHostileFilesInASentence) {
    EXPECT_EQ(error_of({{"a.txt", "hello"}}),
              "a.ora: is no OpenRaster file, which would hold stack.xml.");
    Entries entries = small_file();
    entries[2].second = "no picture";
    EXPECT_THAT(error_of(entries), HasSubstr("a.ora, data/red.png: the picture is no PNG picture"));
    entries = small_file();
    entries[2].second = entries[2].second.substr(0, 60);
    EXPECT_THAT(error_of(entries), HasSubstr("a.ora, data/red.png: the picture "));
    entries = small_file();
    entries.pop_back();
    EXPECT_EQ(error_of(entries), "a.ora, data/grey.png: is missing.");
    entries = small_file();
    entries[1].second = replaced(entries[1].second, "data/red.png", "../../etc/passwd");
    EXPECT_EQ(error_of(entries), "a.ora, ../../etc/passwd: is missing.");
    entries = small_file();
    entries[1].second = replaced(entries[1].second, "xres='25.4' yres='25.4'", "xres='1' yres='25400'");
    EXPECT_THAT(error_of(entries), HasSubstr("mm"));
}

TEST_F(ImportOpenRaster, RefusesBombs) {
    Entries entries = small_file();
    entries[1].second.append(kMostStackBytes, ' ');
    EXPECT_THAT(error_of(entries), HasSubstr("but at most"));
}

}  // namespace
}  // namespace pastoso::project
