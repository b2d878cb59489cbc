// Copies in layers for other programs.
#include "project/layered_copy.hpp"

#include "core/error.hpp"
#include "core/text_file.hpp"
#include "document/layered_canvas.hpp"
#include "document/scenes.hpp"
#include "files/image.hpp"
#include "files/temporary_folder.hpp"
#include "project/archives.hpp"
#include "project/import_open_raster.hpp"
#include "project/paintings.hpp"
#include "project/pictures.hpp"

#include <gmock/gmock.h>

namespace pastoso::project {
namespace {

using testing::HasSubstr;

class LayeredCopies : public files::TemporaryFolder {
  protected:
    LayeredCopies() {
        using namespace document;
        painting->apply(AddLayer{"Upper"});
        painting->apply(TakeBrush{"flat", 8, 1});
        painting->apply(load_of("PB29"));
        painting->apply(PenDown{{9.0, 10, 12, 0.6}});
        painting->apply(PenMove{{9.2, 40, 16, 0.6}});
        painting->apply(PenUp{});
        painting->apply(AddLayer{"Hidden"});
        painting->apply(SetLayer{3, {.name = "Hidden", .visible = false}});
    }
    LayeredCopyReport copied(
        const char* name, const files::KeepGoing& keep_going = [](double) { return true; }) {
        return save_layered_copy({folder / name}, painting->state(), pool, keep_going);
    }
    /// What the painting's own file shows others.
    pigment::Image8 seen() { return pigment::encode_srgb8(pictures_of(painting->state(), pool).merged); }

    core::ThreadPool pool{2};
    std::unique_ptr<document::Painting> painting = played(busy_session(), 85, pool);
};

TEST_F(LayeredCopies, AreThePaintingAsOpenRaster) {
    const LayeredCopyReport report = copied("a.ora");
    EXPECT_EQ(report.status, files::ExportStatus::Written);
    EXPECT_EQ(report.layers, 4U) << "the canvas below them";
    const std::vector<std::byte> file = bytes_in(folder / "a.ora");
    const Entries entries = entries_of(file);
    EXPECT_EQ(entries.front().first, "mimetype");
    for (const auto& [name, content] : entries)
        EXPECT_THAT(name, testing::Not(HasSubstr("pastoso/"))) << "other programs need none of it";
    const LoadedProject read = import_open_raster(folder / "a.ora", {}, pool);
    const document::LayerStack& layers = read.painting.value.layers;
    ASSERT_EQ(layers.layers.size(), 4U);
    EXPECT_EQ(layers.layers[2].look.name, "Upper");
    EXPECT_FALSE(layers.layers[3].look.visible);
}

TEST_F(LayeredCopies, AreThePaintingAsPhotoshop) {
    EXPECT_EQ(copied("a.psd").width_px, painting->snapshot().film.shape.width);
    EXPECT_EQ(pigment::encode_srgb8(files::read_colour_image(folder / "a.psd")).rgb, seen().rgb);
    EXPECT_THAT(core::read_text_file(folder / "a.psd"), HasSubstr("Upper"));
}

TEST_F(LayeredCopies, LeaveThePaintingAsItIs) {
    const std::uint64_t before = painting->state_hash();
    copied("a.ora");
    copied("a.psd");
    EXPECT_EQ(painting->state_hash(), before);
}

TEST_F(LayeredCopies, StoppedLeaveTheOldFile) {
    core::write_text_file(folder / "a.psd", "old");
    for (int steps = 0; steps < 6; ++steps) {
        int asked = 0;
        const auto report = copied("a.psd", [&](double) { return asked++ < steps; });
        if (report.status == files::ExportStatus::Written) {
            EXPECT_GE(steps, 5);
            break;
        }
        EXPECT_EQ(core::read_text_file(folder / "a.psd"), "old") << steps;
    }
}

TEST_F(LayeredCopies, RefuseOtherNames) {
    for (const char* name : {"a.xcf", "a", "a.PSD.png"})
        EXPECT_THROW(check_layered_copy({folder / name}), core::InputError) << name;
    EXPECT_THROW(copied("missing/a.ora"), core::InputError);
}

}  // namespace
}  // namespace pastoso::project
