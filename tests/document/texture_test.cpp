// Texture paste on a painting: as much as the relief says, dry, and caught by what is brushed over it.
#include "document/error_of.hpp"
#include "document/painting.hpp"
#include "document/painting_state.hpp"
#include "document/scenes.hpp"
#include "layers/texture/texture_relief.hpp"

#include <algorithm>
#include <numeric>

#include <gmock/gmock.h>

namespace pastoso::document {
namespace {

using testing::HasSubstr;

/// As in painting_test.cpp.
constexpr double kRounding = 1e-9;

CanvasSettings smooth_canvas(double px_per_mm) {
    CanvasSettings canvas = small_canvas();
    canvas.support = "panel";
    canvas.px_per_mm = px_per_mm;
    return canvas;
}

std::shared_ptr<const pigment::Picture> grey_ramp() {
    auto picture = std::make_shared<pigment::Picture>(pigment::Picture{16, 4, {}});
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 16; ++x) {
            const auto level = static_cast<std::uint8_t>(17 * x);
            picture->rgba.insert(picture->rgba.end(), {level, level, level, 255});
        }
    return picture;
}

LayTexture white(const layers::Texture& texture) {
    return {{{{"PW6", 1.0}}}, texture};
}

/// Dry paint, quanta: what binds and what can be dissolved again.
std::int64_t all_of(const film::Strata& strata) {
    std::int64_t sum = strata.fixed.thickness;
    for (int tile = 0; tile < strata.soluble_thickness.tile_count(); ++tile)
        sum = std::accumulate(strata.soluble_thickness.read(tile),
                              strata.soluble_thickness.read(tile) + grid::kTileCells, sum);
    return sum;
}

class TextureTest : public testing::Test {
  protected:
    void SetUp() override { painting.apply(UseMedium{"soft-body acrylic"}); }
    void expect_balance() const {
        EXPECT_LT(painting.account().volume_error_rel(), kRounding);
        EXPECT_LT(painting.account().pigment_error_rel(), kRounding);
    }
    double bare_mm(int x, int y) const { return painting.snapshot().bare->support_mm.at(x, y); }
    double paste_mm(int x, int y) const { return painting.film().support_mm.at(x, y) - bare_mm(x, y); }
    std::string error(const layers::Texture& texture) {
        return error_of([&] { painting.apply(white(texture)); });
    }

    core::ThreadPool pool{2};
    Painting painting{smooth_canvas(4.0), pool};
    const layers::SandTexture sand{0.8, 3};
    const layers::KnifedTexture knifed{1.0, 3.0, 20.0, 3};
    const layers::PressedTexture ramp{{4.0, 3.0, 32.0, 8.0}, 0.5, false, grey_ramp()};
};

TEST_F(TextureTest, IsAsThickAsTheReliefToTheQuantum) {
    for (const layers::Texture& texture :
         {layers::Texture(sand), layers::Texture(knifed), layers::Texture(ramp)}) {
        const film::Strata before = painting.film().strata;
        const double taken_before = painting.account().taken.volume_mm3;
        painting.apply(white(texture));
        const film::FilmState& film = painting.film();
        const auto relief = layers::texture_relief(texture, film.shape, film.cell_mm, nullptr, pool);
        std::int64_t quanta = 0;
        for (int y = 0; y < 120; ++y)
            for (int x = 0; x < 160; ++x)
                quanta += relief.at(x, y);
        EXPECT_EQ(all_of(film.strata) - all_of(before), quanta) << "none of it evaporates";
        EXPECT_EQ(film.strata.evaporated, before.evaporated);
        EXPECT_NEAR(painting.account().taken.volume_mm3 - taken_before,
                    film::volume_mm3(quanta, film.cell_mm), 1e-9);
        expect_balance();
    }
    EXPECT_EQ(film::totals(painting.film()).thickness, 0);
    EXPECT_EQ(painting.undo_steps().back().step.name, "Texture laid");
}

TEST_F(TextureTest, ItsReliefLiesOnTheSupport) {
    painting.apply(white(sand));
    const auto relief = layers::texture_relief(sand, painting.film().shape, 0.25, nullptr, pool);
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x)
            ASSERT_NEAR(paste_mm(x, y), relief.at(x, y) * film::kThicknessQuantum_mm, 1e-6);
}

TEST_F(TextureTest, KeepsToTheSelection) {
    painting.apply(SelectArea{{{0, 0}, {20, 0}, {20, 30}, {0, 30}}});
    painting.apply(white(knifed));
    EXPECT_GT(paste_mm(79, 60), 0.03);
    EXPECT_EQ(paste_mm(80, 60), 0.0);
    expect_balance();
}

TEST_F(TextureTest, KeepsOffWhatIsMaskedAndLockedBare) {
    const auto most_beside_mm = [&] {
        double most_mm = 0.0;
        for (int x = 50; x < 160; ++x)
            most_mm = std::max(most_mm, paste_mm(x, 60));
        return most_mm;
    };
    painting.apply(MaskStripe{{{10, 0}, {10, 30}}, 4.0, true});
    painting.apply(white(knifed));
    EXPECT_EQ(paste_mm(40, 60), 0.0);
    const double once_mm = most_beside_mm();
    EXPECT_GT(once_mm, 0.03);
    painting.apply(PeelMasking{});
    painting.apply(SetLayer{1, {.name = "Paint", .bare_locked = true}});
    painting.apply(white(knifed));
    EXPECT_EQ(paste_mm(40, 60), 0.0);
    EXPECT_GT(most_beside_mm(), once_mm);
    expect_balance();
}

TEST_F(TextureTest, APictureRisesWhereItIsBright) {
    painting.apply(white(ramp));
    EXPECT_EQ(paste_mm(10, 28), 0.0);
    EXPECT_EQ(paste_mm(80, 60), 0.0) << "below the picture";
    EXPECT_GT(paste_mm(80, 28), paste_mm(50, 28) + 0.05);
    EXPECT_NEAR(paste_mm(140, 28), 0.5, 0.002);
}

TEST_F(TextureTest, WetPaintBelowItIsDry) {
    painting.apply(TakeBrush{"flat", 8, 1});
    painting.apply(load_of("PB29"));
    paint_wave(painting, 0.0, 10.0);
    ASSERT_TRUE(film::has_wet_paint(painting.film()));
    painting.apply(SelectArea{{{0, 0}, {20, 0}, {20, 30}, {0, 30}}});
    painting.apply(white(sand));
    const auto wet = [&](int from, int to) {
        std::int64_t sum = 0;
        for (int y = 0; y < 120; ++y)
            for (int x = from; x < to; ++x)
                sum += painting.film().thickness.at(x, y);
        return sum;
    };
    EXPECT_EQ(wet(0, 80), 0);
    EXPECT_GT(wet(80, 160), 0) << "beside it stays wet";
    for (int tick = 0; tick < 10; ++tick)
        painting.advance_tick();
    expect_balance();
}

TEST_F(TextureTest, IsUndoneAndDoneAgainToTheBit) {
    for (const layers::Texture& texture :
         {layers::Texture(sand), layers::Texture(knifed), layers::Texture(ramp)}) {
        const std::uint64_t before = painting.state_hash();
        painting.apply(white(texture));
        const std::uint64_t after = painting.state_hash();
        EXPECT_NE(after, before);
        painting.apply(Undo{});
        EXPECT_EQ(painting.state_hash(), before);
        painting.apply(Redo{});
        EXPECT_EQ(painting.state_hash(), after);
        expect_balance();
    }
}

TEST_F(TextureTest, AnyNumberOfThreadsGivesTheSame) {
    core::ThreadPool alone(1);
    Painting other(smooth_canvas(4.0), alone);
    other.apply(UseMedium{"soft-body acrylic"});
    for (Painting* one : {&painting, &other})
        for (const layers::Texture& texture :
             {layers::Texture(sand), layers::Texture(knifed), layers::Texture(ramp)})
            one->apply(white(texture));
    EXPECT_EQ(painting.state_hash(), other.state_hash());
}

TEST_F(TextureTest, IsAsMuchPaintAtAnotherResolution) {
    for (const layers::Texture& texture :
         {layers::Texture(sand), layers::Texture(knifed), layers::Texture(ramp)}) {
        Painting coarse(smooth_canvas(4.0), pool), fine(smooth_canvas(7.0), pool);
        coarse.apply(white(texture));
        fine.apply(white(texture));
        const Account::Amount little = coarse.account().dried, much = fine.account().dried;
        EXPECT_NEAR(much.volume_mm3, little.volume_mm3, 0.01 * little.volume_mm3);
    }
}

TEST_F(TextureTest, ADryBrushCatchesItsCrests) {
    painting.apply(white(sand));
    TakeBrush brush{"Dry scumbler 22", 20, 1};
    painting.apply(brush);
    painting.apply(load_of("PB29", 0.3));
    painting.apply(PenDown{{0.0, 4.0, 15.0, 0.25}});
    for (int i = 1; i <= 60; ++i)
        painting.apply(PenMove{{0.01 * i, 4.0 + 0.5 * i, 15.0, 0.25}});
    painting.apply(PenUp{});
    std::vector<double> heights;
    for (int y = 40; y < 80; ++y)
        for (int x = 40; x < 120; ++x)
            heights.push_back(paste_mm(x, y));
    std::nth_element(heights.begin(), heights.begin() + static_cast<long>(heights.size() / 2),
                     heights.end());
    const double middle_mm = heights[heights.size() / 2];
    double on_crests = 0.0, in_hollows = 0.0;
    for (int y = 40; y < 80; ++y)
        for (int x = 40; x < 120; ++x)
            (paste_mm(x, y) > middle_mm ? on_crests : in_hollows) += painting.film().thickness.at(x, y);
    EXPECT_GT(on_crests, 0.0);
    EXPECT_GT(on_crests, 3.0 * in_hollows);
}

TEST_F(TextureTest, WhatCannotBeLaidIsRefused) {
    const std::uint64_t before = painting.state_hash();
    EXPECT_EQ(error(layers::SandTexture{5.0, 1}),
              "the diameter of the grains in mm is 5, but must lie between 0.1 and 2.");
    EXPECT_THAT(error(layers::KnifedTexture{9.0, 3.0, 0.0, 1}),
                HasSubstr("height of the texture in mm is 9"));
    EXPECT_THAT(error(layers::KnifedTexture{1.0, 0.0, 0.0, 1}),
                HasSubstr("spacing of the ridges in mm is 0"));
    EXPECT_THAT(error(layers::KnifedTexture{1.0, 3.0, 1e9, 1}), HasSubstr("direction of the knife"));
    layers::PressedTexture wrong = ramp;
    wrong.place.width_mm = 0.0;
    EXPECT_THAT(error(wrong), HasSubstr("width of the picture in mm is 0"));
    EXPECT_THAT(error_of([&] {
                    painting.apply(LayTexture{{{{"no such", 1.0}}}, sand});
                }),
                HasSubstr("no such"));
    EXPECT_EQ(painting.state_hash(), before);
    painting.apply(SetLayer{1, {.name = "Sky", .locked = true}});
    EXPECT_THAT(error(sand), HasSubstr("\"Sky\" is locked"));
    EXPECT_EQ(painting.account().taken.volume_mm3, 0.0);
}

}  // namespace
}  // namespace pastoso::document
