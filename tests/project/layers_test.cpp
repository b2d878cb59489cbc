// Paintings of several layers, saved and opened again.
#include "document/layered_canvas.hpp"
#include "document/scenes.hpp"
#include "files/image.hpp"
#include "files/temporary_folder.hpp"
#include "layers/clipping.hpp"
#include "pigment/colour.hpp"
#include "project/archives.hpp"
#include "project/paintings.hpp"
#include "project/pictures.hpp"

#include <gmock/gmock.h>

namespace pastoso::project {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class LayeredProject : public files::TemporaryFolder {
  protected:
    LayeredProject() {
        using namespace document;
        painting->apply(AddLayer{"Wet & new"});
        painting->apply(TakeBrush{"flat", 8, 1});
        painting->apply(UseMedium{"fluid acrylic"});
        painting->apply(load_of("PB29"));
        painting->apply(PenDown{{9.0, 10, 12, 0.6}});
        painting->apply(PenMove{{9.2, 40, 16, 0.6}});
        painting->apply(PenUp{});
        painting->apply(AddLayer{"Hidden"});
        painting->apply(SetLayer{3, {.name = "Hidden", .visible = false, .locked = true}});
        painting->apply(GroupLayers{"Both", {1, 2}});
        painting->apply(SetGroup{1, {.name = "Both", .opacity = 0.75}});
        painting->apply(SelectLayer{2});
        for (int i = 0; i < 5; ++i)
            painting->advance_tick();
    }
    Project project() const { return {painting->state(), {painting->settings(), {}, painting->tick()}}; }
    core::ThreadPool pool{2};
    std::unique_ptr<document::Painting> painting = played(busy_session(), 85, pool);
};

TEST_F(LayeredProject, ComesBackAndGoesOnToTheSameBits) {
    save_project(folder / "a.pastoso", project(), pool);
    const LoadedProject loaded = load_project(folder / "a.pastoso", pool);
    EXPECT_THAT(loaded.notes, IsEmpty());
    EXPECT_EQ(document::state_hash(loaded.painting), painting->state_hash());
    document::Painting again(loaded.painting, pool);
    EXPECT_EQ(film::state_hash(again.snapshot().film), film::state_hash(painting->snapshot().film));
    for (document::Painting* one : {painting.get(), &again}) {
        for (int i = 0; i < 20; ++i)
            one->advance_tick();
        one->apply(document::SelectLayer{1});
        one->apply(document::AddLayer{"Later"});
        one->advance_tick();
        one->apply(document::FlattenLayers{});
        one->advance_tick();
    }
    EXPECT_EQ(again.state_hash(), painting->state_hash());
    const document::LayerStack stack = again.state().value.layers,
                               before = painting->state().value.layers;
    EXPECT_EQ(stack.next_layer, before.next_layer);
    EXPECT_EQ(stack.layers[0].look, before.layers[0].look);
}

TEST_F(LayeredProject, IsAStackOfPicturesToOtherPrograms) {
    const Entries entries = entries_of(file_of(project(), folder, pool));
    const auto content = [&](const std::string& name) -> std::string {
        for (const auto& [entry, bytes] : entries)
            if (entry == name) return bytes;
        return "";
    };
    const std::string stack = content("stack.xml");
    const auto hidden = stack.find("name=\"Hidden\" src=\"data/layer2.png\"");
    const auto wet = stack.find("name=\"Wet &amp; new\" src=\"data/layer1.png\"");
    const auto canvas = stack.find("name=\"Canvas\" src=\"data/canvas.png\"");
    ASSERT_NE(canvas, std::string::npos);
    EXPECT_LT(hidden, wet);
    EXPECT_LT(wet, canvas);
    EXPECT_THAT(stack.substr(hidden, wet - hidden), HasSubstr("visibility=\"hidden\""));
    for (const char* entry :
         {"data/canvas.png", "data/layer0.png", "data/layer1.png", "data/layer2.png"})
        EXPECT_THAT(content(entry), HasSubstr("PNG")) << entry;
}

TEST_F(LayeredProject, ItsPicturesLaidOverOneAnotherAreThePainting) {
    const Pictures pictures = pictures_of(painting->state(), pool);
    ASSERT_EQ(pictures.layers.size(), 4U);
    pigment::Image8 sum = pictures.layers[0].picture;
    for (const LayerPicture& layer : pictures.layers) {
        if (!layer.visible) continue;
        for (std::size_t i = 0; i < layer.covered.size(); ++i)
            if (layer.covered[i] == 255) std::copy_n(&layer.picture.rgb[3 * i], 3, &sum.rgb[3 * i]);
    }
    const pigment::Image8 merged = pigment::encode_srgb8(pictures.merged);
    const auto light = [](std::uint8_t level) { return pigment::decode_srgb(level / 255.0); };
    double difference = 0.0;
    for (std::size_t i = 0; i < sum.rgb.size(); ++i)
        difference += std::abs(light(sum.rgb[i]) - light(merged.rgb[i]));
    // Shadows fall beyond the paint's edge.
    EXPECT_LT(difference / static_cast<double>(sum.rgb.size()), 2e-3);
}

TEST_F(LayeredProject, ThePictureOfAClippedLayerHoldsWhatShows) {
    painting->apply(document::AddLayer{"Clipped"});
    painting->apply(document::FillWithPaint{.paint = {{{"PY35", 1.0}}}});
    painting->apply(document::SetLayer{4, {.name = "Clipped", .clipped = true}});
    const document::PaintingState state = painting->state();
    const Pictures pictures = pictures_of(state, pool);
    ASSERT_EQ(pictures.layers[3].name, "Clipped");
    const film::FilmState seen = painting->snapshot().film;
    EXPECT_EQ(
        pigment::encode_srgb8(pictures.merged).rgb,
        pigment::encode_srgb8(shade::render(seen, document::kPrimedGround, seen.shape.cells(), {}, pool))
            .rgb);
    const document::LayerFilms films =
        document::layers_apart(state.value.film, state.value.bare->support_mm, state.value.layers);
    const grid::Mask painted = layers::painted_cells(*films[1]);
    const std::vector<std::uint8_t>& covered = pictures.layers[3].covered;
    std::int64_t shown = 0;
    for (int y = 0; y < seen.shape.height; ++y)
        for (int x = 0; x < seen.shape.width; ++x) {
            const bool shows = covered[static_cast<std::size_t>(y * seen.shape.width + x)] == 255;
            ASSERT_EQ(shows, painted.at(x, y) != 0) << x << ", " << y;
            shown += shows ? 1 : 0;
        }
    EXPECT_GT(shown, 100);
    EXPECT_LT(shown, std::int64_t{seen.shape.width} * seen.shape.height - 100);
}

/// Bit by bit: every layer is shown over the view of those below it alone, whichever were looked at
/// before.
TEST_F(LayeredProject, EachPictureIsTheOneOfItsLayersAlone) {
    for (const bool top_is_visible : {false, true}) {
        painting->apply(
            document::SetLayer{3, {.name = "Top", .visible = top_is_visible, .opacity = 0.7}});
        const document::PaintingState state = painting->state();
        const Pictures pictures = pictures_of(state, pool);
        const auto picture_of = [&](document::LayerStack stack) {
            const auto seen =
                document::view_of(state.value.film, state.value.bare->support_mm, stack, pool);
            return pigment::encode_srgb8(
                       shade::render(seen, document::kPrimedGround, seen.shape.cells(), {}, pool))
                .rgb;
        };
        EXPECT_EQ(pigment::encode_srgb8(pictures.merged).rgb, picture_of(state.value.layers));
        for (std::size_t shown = 0; shown < state.value.layers.layers.size(); ++shown) {
            document::LayerStack stack = state.value.layers;
            for (std::size_t place = 0; place < stack.layers.size(); ++place) {
                document::LayerLook& look = stack.layers[place].look;
                look.visible = place == shown || (place < shown && look.visible);
            }
            EXPECT_EQ(pictures.layers[shown + 1].picture.rgb, picture_of(stack)) << shown;
        }
    }
}

TEST_F(LayeredProject, AFullyPaintedCanvasKeepsItsBareSupport) {
    document::CanvasSettings settings = document::small_canvas();
    settings.width_mm = settings.height_mm = 20.0;
    document::Painting other(settings, pool);
    other.apply(document::TakeBrush{"flat", 8, 1});
    other.apply(document::load_of("PB29"));
    other.apply(document::PenDown{{0.0, 5, 12, 0.6}});
    other.apply(document::PenMove{{0.2, 15, 16, 0.6}});
    other.apply(document::PenUp{});
    other.apply(document::DryNow{});
    save_project(folder / "c.pastoso", {other.state(), {settings, {}, 0}}, pool);
    const LoadedProject loaded = load_project(folder / "c.pastoso", pool);
    document::Painting again(loaded.painting, pool);
    for (document::Painting* one : {&other, &again})
        one->apply(document::SetLayer{1, {.name = "Paint", .visible = false}});
    EXPECT_EQ(film::state_hash(again.snapshot().film), film::state_hash(other.snapshot().film));
}

TEST_F(LayeredProject, AnImageAsSupportNeedNotBeThere) {
    document::CanvasSettings settings = document::small_canvas();
    settings.support = "image";
    settings.support_image = "gone.png";
    const grid::Shape shape = painting->film().shape;
    settings.width_mm = 60.0;
    film::SupportHeights hills(shape);
    for (int y = 0; y < shape.height; ++y)
        for (int x = 0; x < shape.width; ++x)
            hills.set(x, y, 0.125F * static_cast<float>(x % 5));
    document::Painting other(settings, hills, pool);
    other.apply(document::TakeBrush{"flat", 8, 1});
    other.apply(document::load_of("PB29"));
    other.apply(document::PenDown{{0.0, 10, 12, 0.6}});
    other.apply(document::PenMove{{0.2, 40, 16, 0.6}});
    other.apply(document::PenUp{});
    other.apply(document::DryNow{});
    save_project(folder / "b.pastoso", {other.state(), {settings, {}, 0}}, pool);
    const LoadedProject loaded = load_project(folder / "b.pastoso", pool);
    document::Painting again(loaded.painting, pool);
    for (document::Painting* one : {&other, &again})
        one->apply(document::SetLayer{1, {.name = "Paint", .visible = false}});
    EXPECT_EQ(film::state_hash(again.snapshot().film), film::state_hash(other.snapshot().film));
    EXPECT_EQ(again.snapshot().film.support_mm.at(3, 3), hills.at(3, 3));
}

}  // namespace
}  // namespace pastoso::project
