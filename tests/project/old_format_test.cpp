// Files that earlier versions of the program wrote.
#include "document/layered_canvas.hpp"
#include "document/player.hpp"
#include "files/temporary_folder.hpp"
#include "project/project.hpp"
#include "shade/render.hpp"
#include "source_file.hpp"

#include <gmock/gmock.h>

namespace pastoso::project {
namespace {

class OldFormat : public files::TemporaryFolder {
  protected:
    pigment::Image8 picture(const film::FilmState& film) {
        return pigment::encode_srgb8(
            shade::render(film, document::kPrimedGround, film.shape.cells(), {}, pool));
    }
    /// Mean difference of the pixels' values.
    static double difference(const pigment::Image8& a, const pigment::Image8& b) {
        double sum = 0.0;
        for (std::size_t i = 0; i < a.rgb.size(); ++i)
            sum += std::abs(static_cast<double>(a.rgb[i]) - static_cast<double>(b.rgb[i]));
        return sum / static_cast<double>(a.rgb.size());
    }
    void expect_looks_as_painted(const LoadedProject& old) {
        EXPECT_THAT(old.notes, testing::IsEmpty());
        const film::FilmState& film = old.painting.value.film;
        document::Painting again(old.strokes.canvas, pool);
        document::Player player(again, old.strokes);
        while (!player.finished())
            player.play_tick();
        ASSERT_EQ(film.shape, again.film().shape);
        // A half of 255 steps: the solver may have changed since, red under blue may not have become
        // another.
        EXPECT_LT(difference(picture(film), picture(again.film())), 0.5);
    }
    core::ThreadPool pool{1};
};

TEST_F(OldFormat, OneShowsThePaintingThatWasSaved) {
    const LoadedProject old = load_project(tests::source_file("tests/project/format-1.pastoso"), pool);
    EXPECT_FALSE(old.painting.value.film.strata.optics.is_background(0));
    expect_looks_as_painted(old);
}

TEST_F(OldFormat, ThreeShowsThePaintingThatWasSaved) {
    const LoadedProject old = load_project(tests::source_file("tests/project/format-3.pastoso"), pool);
    EXPECT_TRUE(film::has_wet_paint(old.painting.value.film));
    EXPECT_TRUE(old.painting.value.selection);
    expect_looks_as_painted(old);
    EXPECT_LT(document::Painting(old.painting, pool).account().volume_error_rel(), 1e-9);
}

class OldFormatTwo : public OldFormat {
  protected:
    LoadedProject loaded() {
        return load_project(tests::source_file("tests/project/format-2.pastoso"), pool);
    }
};

TEST_F(OldFormatTwo, LiesOnTheClothThatItWasPaintedOn) {
    const LoadedProject old = loaded();
    EXPECT_THAT(old.notes, testing::IsEmpty());
    const document::PaintingState& painting = old.painting;
    const document::LayerFilms films = document::layers_apart(
        painting.value.film, painting.value.bare->support_mm, painting.value.layers);
    ASSERT_EQ(films.size(), 2U);
    EXPECT_FALSE(films[0]->support_mm.is_background(0)) << "the dry red";
    EXPECT_TRUE(films[1]->support_mm.is_background(0)) << "wet paint alone has no relief";
}

TEST_F(OldFormatTwo, WetPaintRunsTogetherWhenItIsMerged) {
    document::Painting painting(loaded().painting, pool);
    const document::Account before = painting.account();
    painting.apply(document::MergeDown{2});
    EXPECT_EQ(painting.account().dried.volume_mm3, before.dried.volume_mm3);
    EXPECT_EQ(painting.account().canvas.volume_mm3, before.canvas.volume_mm3);
    EXPECT_GT(before.dried.volume_mm3, 0.0);
}

TEST_F(OldFormatTwo, IsTheSameWhenItIsSavedAnewAndOpened) {
    const LoadedProject old = loaded();
    save_project(folder / "new.pastoso", {old.painting, old.strokes}, pool);
    const LoadedProject again = load_project(folder / "new.pastoso", pool);
    EXPECT_THAT(again.notes, testing::IsEmpty());
    EXPECT_EQ(document::state_hash(again.painting), document::state_hash(old.painting));
    for (int tile = 0; tile < old.painting.value.bare->support_mm.tile_count(); ++tile)
        for (int cell = 0; cell < grid::kTileCells; ++cell)
            ASSERT_EQ(again.painting.value.bare->support_mm.read(tile)[cell],
                      old.painting.value.bare->support_mm.read(tile)[cell]);
}

/// Its upper layer is of the medium in hand; that of the lower one, oil, no entry tells.
TEST_F(OldFormat, FourTellsByThePaintInWhichMediumALayerIs) {
    const LoadedProject old = load_project(tests::source_file("tests/project/format-4.pastoso"), pool);
    const auto acrylic = film::consistency_of(film::find_medium("fluid acrylic"));
    EXPECT_EQ(old.painting.value.film.consistencies.uniform(), acrylic);
    EXPECT_EQ(old.painting.value.brush->brush.consistencies.uniform(), acrylic);
    const film::FilmState oil = *old.painting.value.layers.layers[0].inactive;
    EXPECT_TRUE(oil.consistencies.are_several());
    document::Painting painting(old.painting, pool);
    painting.apply(document::SelectLayer{1});
    for (int i = 0; i < 60; ++i)
        painting.advance_tick();
    EXPECT_EQ(film::totals(painting.film()).thickness, film::totals(oil).thickness)
        << "oil does not run off";
}

}  // namespace
}  // namespace pastoso::project
