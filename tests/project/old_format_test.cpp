// Files that earlier versions of the program wrote.
#include "core/message_text.hpp"
#include "document/layered_canvas.hpp"
#include "document/painting.hpp"
#include "files/image.hpp"
#include "files/temporary_folder.hpp"
#include "project/pictures.hpp"
#include "project/project.hpp"
#include "source_file.hpp"

#include <gmock/gmock.h>

namespace pastoso::project {
namespace {

constexpr const char* kOne = "tests/project/format-1.pastoso";
constexpr const char* kThree = "tests/project/format-3.pastoso";

class OldFormat : public files::TemporaryFolder {
  protected:
    static LoadedProject load(const char* file, core::ThreadPool& pool) {
        LoadedProject old = load_project(tests::source_file(file), pool);
        EXPECT_THAT(core::texts_of(old.notes),
                    testing::ElementsAre(testing::HasSubstr(
                        "as it was saved, but its strokes were painted with an earlier")));
        EXPECT_EQ(old.strokes.arithmetic, 1);
        return old;
    }
    /// Against the picture that was saved with it: two of 255 steps, since it was lit without the filter
    /// of docs/decisions/0060; red under blue may not have become another.
    void expect_looks_as_saved(const char* file, const LoadedProject& old) {
        const pigment::Picture saved = files::decode_png(load_thumbnail(tests::source_file(file)));
        const pigment::Picture now = files::decode_png(thumbnail_file(old.painting, pool));
        ASSERT_EQ(now.width, saved.width);
        ASSERT_EQ(now.rgba.size(), saved.rgba.size());
        double sum = 0.0;
        for (std::size_t i = 0; i < now.rgba.size(); ++i)
            sum += std::abs(static_cast<double>(now.rgba[i]) - static_cast<double>(saved.rgba[i]));
        EXPECT_LT(sum / static_cast<double>(now.rgba.size()), 2.0);
    }
    core::ThreadPool pool{1};
};

TEST_F(OldFormat, OneShowsThePaintingThatWasSaved) {
    const LoadedProject old = load(kOne, pool);
    EXPECT_FALSE(old.painting.value.film.strata.optics.is_background(0));
    expect_looks_as_saved(kOne, old);
}

TEST_F(OldFormat, ThreeShowsThePaintingThatWasSaved) {
    const LoadedProject old = load(kThree, pool);
    EXPECT_TRUE(film::has_wet_paint(old.painting.value.film));
    EXPECT_TRUE(old.painting.value.selection);
    expect_looks_as_saved(kThree, old);
    EXPECT_LT(document::Painting(old.painting, pool).account().volume_error_rel(), 1e-9);
}

class OldFormatTwo : public OldFormat {
  protected:
    LoadedProject loaded() { return load("tests/project/format-2.pastoso", pool); }
};

TEST_F(OldFormatTwo, LiesOnTheClothThatItWasPaintedOn) {
    const LoadedProject old = loaded();
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
    EXPECT_EQ(again.notes, old.notes);
    EXPECT_EQ(document::state_hash(again.painting), document::state_hash(old.painting));
    for (int tile = 0; tile < old.painting.value.bare->support_mm.tile_count(); ++tile)
        for (int cell = 0; cell < grid::kTileCells; ++cell)
            ASSERT_EQ(again.painting.value.bare->support_mm.read(tile)[cell],
                      old.painting.value.bare->support_mm.read(tile)[cell]);
}

/// White was painted into wet blue when a cell had one mixture.
TEST_F(OldFormat, SixHasPaintInOneStratum) {
    const LoadedProject old = load_project(tests::source_file("tests/project/format-6.pastoso"), pool);
    const film::FilmState& film = old.painting.value.film;
    for (int tile = 0; tile < film.shape.tile_count(); ++tile)
        EXPECT_FALSE(film.lower.is_in(tile));
    EXPECT_TRUE(film::has_wet_paint(film));
    EXPECT_EQ(document::state_hash(old.painting), 0xbba2e920dbb1e10fU);
}

/// White was painted onto wet blue when paint had no structure.
TEST_F(OldFormat, SevenHasPaintThatHasRested) {
    const LoadedProject old = load_project(tests::source_file("tests/project/format-7.pastoso"), pool);
    EXPECT_FALSE(old.painting.value.film.worked.is_anywhere());
    EXPECT_TRUE(old.painting.value.film.lower.is_in(0));
    EXPECT_EQ(document::state_hash(old.painting), 0x0597aa1cd8a02b99U);
}

/// Ink was painted into wet oil when the film had the numbers of the medium in hand.
TEST_F(OldFormat, EightHasPaintOfTheMediumInHand) {
    const LoadedProject old = load_project(tests::source_file("tests/project/format-8.pastoso"), pool);
    EXPECT_TRUE(old.painting.value.film.media.numbers.empty());
    EXPECT_TRUE(old.painting.value.film.lower.is_in(0));
    const document::Painting painting(old.painting, pool);
    EXPECT_EQ(painting.film().media.numbers,
              std::vector{film::film_numbers_of(film::find_medium("ink glaze"))});
    EXPECT_EQ(document::state_hash(old.painting), 0xb670b9405b933726U);
}

/// A pen has erased since when a brush can lie aside.
TEST_F(OldFormat, NineHasNoBrushAside) {
    const LoadedProject old = load_project(tests::source_file("tests/project/format-9.pastoso"), pool);
    EXPECT_EQ(old.painting.value.brush_aside, nullptr);
    EXPECT_TRUE(old.painting.value.brush->brush.holds_paint());
    EXPECT_THAT(core::texts_of(old.notes),
                testing::ElementsAre(testing::HasSubstr("(arithmetic 5, now ")));
    EXPECT_EQ(document::state_hash(old.painting), 0x4b576c071a99a065U);
}

TEST_F(OldFormat, TenHasNothingCopied) {
    const LoadedProject old = load_project(tests::source_file("tests/project/format-10.pastoso"), pool);
    EXPECT_EQ(old.painting.value.copied, nullptr);
    ASSERT_NE(old.painting.value.brush_aside, nullptr);
    EXPECT_TRUE(old.painting.value.brush_aside->brush.holds_paint());
    EXPECT_EQ(document::state_hash(old.painting), 0xfe38c0fb5154b002U);
}

/// A stroke was copied before a second one was painted.
TEST_F(OldFormat, ElevenHasWhatWasCopiedAndNothingMasked) {
    const LoadedProject old = load_project(tests::source_file("tests/project/format-11.pastoso"), pool);
    ASSERT_NE(old.painting.value.copied, nullptr);
    EXPECT_EQ(film::totals(*old.painting.value.copied).thickness, 6516500468);
    EXPECT_EQ(old.painting.value.masking, document::Masking{});
    EXPECT_EQ(old.painting.value.references, nullptr);
    EXPECT_FALSE(old.painting.value.layers.layers[0].look.bare_locked);
    EXPECT_EQ(document::state_hash(old.painting), 0xf91419c9afe237ecU);
}

/// A stripe of 3 mm was masked from edge to edge, 12 by 40 cells, when there was no telling of what.
TEST_F(OldFormat, TwelveIsMaskedByFluidAndNotClipped) {
    const LoadedProject old = load_project(tests::source_file("tests/project/format-12.pastoso"), pool);
    const document::PaintingValue& value = old.painting.value;
    ASSERT_TRUE(value.masking.cells);
    EXPECT_EQ(grid::chosen_cells(*value.masking.cells), 480);
    EXPECT_FALSE(value.masking.tape);
    EXPECT_TRUE(value.layers.layers[0].look.bare_locked);
    EXPECT_FALSE(value.layers.layers[0].look.clipped);
    ASSERT_NE(value.references, nullptr);
    ASSERT_EQ(value.references->references.size(), 1U);
    const document::Reference& red = value.references->references.front();
    EXPECT_EQ(red.place, (document::ReferencePlace{40.0, 30.0, 60.0, 15.0, true}));
    EXPECT_EQ(red.look, (document::ReferenceLook{0.5, true}));
    EXPECT_EQ(film::state_hash(value.film), 0x01d1850b9af4a24eU);
}

/// Its brush was dipped before dips gathered hairs, and tells a tool of those days.
TEST_F(OldFormat, FiveHasABrushThatIsAsItWasMade) {
    const LoadedProject old = load_project(tests::source_file("tests/project/format-5.pastoso"), pool);
    const brush::Brush& brush = old.painting.value.brush->brush;
    EXPECT_EQ(brush.gathering, brush::Gathering{});
    EXPECT_EQ(brush.preset.paint.gather, 0.0);
    EXPECT_EQ(brush.tip.hairs, brush::make_tip(brush.preset, 3).hairs);
    EXPECT_EQ(document::state_hash(old.painting), 0xcd826fbe242e536bU);
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
