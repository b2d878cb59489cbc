// The colours that dry paint has, and would have after it is adjusted.
#include "tools/dry_colours.hpp"

#include "document/actions/actions.hpp"
#include "document/paint_mixing.hpp"

#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

using document::PaintRecipe;

class DryColoursTest : public testing::Test {
  protected:
    static document::CanvasSettings small_panel() {
        document::CanvasSettings canvas;
        canvas.width_mm = 40.0;
        canvas.height_mm = 30.0;
        canvas.px_per_mm = 4.0;
        canvas.support = "panel";
        return canvas;
    }
    void SetUp() override {
        painting.apply(document::UseMedium{"soft-body acrylic"});
        spot.ground = painting.snapshot().ground;
    }
    void lay_dry(const PaintRecipe& paint) {
        painting.apply(document::FillWithPaint{.paint = paint, .thickness_mm = 0.2});
        painting.apply(document::DryNow{});
    }
    AdjustedColours foretold(const PaintRecipe& paint, const layers::Adjustment& adjustment) {
        return DryColours(painting.snapshot())
            .adjusted(document::mixed_paint(paint, film::find_medium("soft-body acrylic")), adjustment,
                      spot);
    }

    core::ThreadPool pool{1};
    document::Painting painting{small_panel(), pool};
    shade::Spot spot;
    const PaintRecipe blue{{{"PB29", 1.0}}}, white{{{"PW6", 1.0}}};
};

TEST_F(DryColoursTest, ABareLayerHasNone) {
    EXPECT_FALSE(DryColours(painting.snapshot()).any());
    painting.apply(document::FillWithPaint{.paint = blue});
    EXPECT_FALSE(DryColours(painting.snapshot()).any()) << "it is wet";
    painting.apply(document::DryNow{});
    EXPECT_TRUE(DryColours(painting.snapshot()).any());
}

TEST_F(DryColoursTest, OnlyWhatIsSelectedOnTheActiveLayerCounts) {
    painting.apply(document::SelectArea{{{0, 0}, {20, 0}, {20, 30}, {0, 30}}});
    lay_dry(blue);
    painting.apply(document::InvertSelection{});
    EXPECT_FALSE(DryColours(painting.snapshot()).any());
    painting.apply(document::SelectAll{});
    EXPECT_TRUE(DryColours(painting.snapshot()).any());
    painting.apply(document::AddLayer{"Above"});
    EXPECT_FALSE(DryColours(painting.snapshot()).any());
}

TEST_F(DryColoursTest, WhatIsForetoldIsWhatComes) {
    lay_dry(blue);
    for (const layers::Adjustment& adjustment :
         {layers::Adjustment(layers::Glaze{0.01}), layers::Adjustment(layers::PaintExchange{0.4})}) {
        const AdjustedColours colours = foretold(white, adjustment);
        EXPECT_GT(colours.after[0], colours.before[0] + 5) << "white is brighter";
        painting.apply(document::AdjustDryPaint{white, adjustment});
        EXPECT_EQ(foretold(white, layers::PaintExchange{0.0}).before, colours.after);
    }
}

TEST_F(DryColoursTest, NothingExchangedAndNothingThatStaysLookTheSame) {
    lay_dry(blue);
    const AdjustedColours none = foretold(white, layers::PaintExchange{0.0});
    EXPECT_EQ(none.before, none.after);
    const AdjustedColours thinner =
        DryColours(painting.snapshot())
            .adjusted(document::mixed_paint(white, film::find_medium("thinner")), layers::Glaze{}, spot);
    EXPECT_EQ(thinner.before, thinner.after);
}

}  // namespace
}  // namespace pastoso::tools
