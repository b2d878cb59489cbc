#include "screen/canvas_layers.hpp"

#include "core/random.hpp"
#include "film/support/support.hpp"
#include "screen/outline_squares.hpp"
#include "shade/cell_layers.hpp"
#include "shade/outline_layers.hpp"

#include <algorithm>
#include <cmath>

#include <QRectF>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::screen {
namespace {

using ::testing::ElementsAre;

constexpr grid::Shape kShape{200, 150};
constexpr double kCell_mm = 0.25;

document::Snapshot bare_canvas() {
    document::Snapshot snapshot;
    snapshot.film = film::FilmState(kShape, kCell_mm);
    core::ThreadPool pool(1);
    snapshot.film.support_mm = film::named_support("linen", kShape, kCell_mm, 0.0, pool);
    snapshot.ground.fill(0.8F);
    return snapshot;
}

/// A lump of paint up to a millimetre thick.
void add_lump(document::Snapshot& snapshot, int x0, int y0, int size) {
    film::FilmState& film = snapshot.film;
    for (int y = y0; y < y0 + size; ++y) {
        for (int x = x0; x < x0 + size; ++x) {
            const auto cell = static_cast<std::uint32_t>(y * kShape.width + x);
            const double thickness_mm = 0.2 + 0.8 * core::uniform_noise(cell, 7);
            film.thickness.set(x, y,
                               static_cast<std::int32_t>(thickness_mm / film::kThicknessQuantum_mm));
            film::PaintCell pigment{};
            pigment.fill(static_cast<std::int32_t>(2.0 / film::kPaintQuantum));
            film.paint.set(x, y, pigment);
        }
    }
}

void expect_equal_to_reference(const CanvasLayers& layers, const document::Snapshot& snapshot,
                               const shade::Lighting& lighting) {
    core::ThreadPool pool(2);
    const grid::Rect cells = layers.cells_with_border();
    const shade::CellLayers reference =
        shade::cell_layers(snapshot.film, snapshot.ground, cells, lighting, pool);
    int different = 0;
    for (int y = cells.y0; y < cells.y1; ++y) {
        for (int x = cells.x0; x < cells.x1; ++x) {
            const SurfaceTexel& texel = *layers.surface(x, y);
            const std::ptrdiff_t i = reference.index(x, y);
            different += texel.height_mm != reference.height_mm[i] || texel.sky != reference.sky[i] ||
                         texel.shadow_mm != reference.shadow_mm[i];
        }
    }
    EXPECT_EQ(different, 0);
}

TEST(ChangedTiles, AreThoseThatWereWritten) {
    const document::Snapshot before = bare_canvas();
    document::Snapshot after = before;
    EXPECT_TRUE(changed_tiles(&before, after).empty());
    EXPECT_EQ(changed_tiles(nullptr, after).size(), 12U);
    add_lump(after, 60, 10, 8);  // over the seam of the first two tiles
    EXPECT_THAT(changed_tiles(&before, after), ElementsAre(0, 1));
}

TEST(CanvasLayers, AreThoseOfTheReferenceRenderer) {
    document::Snapshot snapshot = bare_canvas();
    add_lump(snapshot, 90, 60, 20);
    CanvasLayers layers;
    core::ThreadPool pool(2);
    const shade::Lighting lighting;
    layers.update(nullptr, snapshot, lighting, pool);
    expect_equal_to_reference(layers, snapshot, lighting);
}

TEST(CanvasLayers, AnotherLightRecoloursEveryTile) {
    document::Snapshot snapshot = bare_canvas();
    add_lump(snapshot, 90, 60, 20);
    CanvasLayers layers;
    core::ThreadPool pool(2);
    const pigment::BandsToRgb lamp = pigment::viewing_under(pigment::find_illuminant("A")).to_rgb;
    const LayerChanges anew = layers.update(nullptr, snapshot, {}, pool, lamp);
    const std::vector<ColourPatch> recoloured = CanvasLayers::recolour(snapshot, lamp, pool);
    ASSERT_EQ(recoloured.size(), anew.colours.size());
    for (std::size_t tile = 0; tile < recoloured.size(); ++tile) {
        ASSERT_EQ(recoloured[tile].cells, anew.colours[tile].cells);
        for (std::size_t i = 0; i < recoloured[tile].colours.size(); ++i) {
            ASSERT_EQ(recoloured[tile].colours[i].red, anew.colours[tile].colours[i].red);
            ASSERT_EQ(recoloured[tile].colours[i].blue, anew.colours[tile].colours[i].blue);
        }
    }
}

TEST(CanvasLayers, UpdatesReachAsFarAsShadowsAndSkyDo) {
    // A low light casts long shadows over neighbouring tiles; the lump is then taken away again. It
    // leaves the lowest place of the canvas bare, below which no shadow is counted.
    shade::Lighting lighting;
    lighting.elevation_deg = 12.0;
    for (const double azimuth_deg : {135.0, 20.0, 250.0, 300.0}) {
        lighting.azimuth_deg = azimuth_deg;
        const document::Snapshot bare = bare_canvas();
        document::Snapshot painted = bare;
        add_lump(painted, 66, 66, 12);
        CanvasLayers layers;
        core::ThreadPool pool(2);
        layers.update(nullptr, bare, lighting, pool);
        layers.update(&bare, painted, lighting, pool);
        expect_equal_to_reference(layers, painted, lighting);
        layers.update(&painted, bare, lighting, pool);
        expect_equal_to_reference(layers, bare, lighting);
    }
}

TEST(CanvasLayers, AnotherLightMovesTheShadows) {
    document::Snapshot snapshot = bare_canvas();
    add_lump(snapshot, 90, 60, 20);
    CanvasLayers layers;
    core::ThreadPool pool(2);
    shade::Lighting lighting;
    layers.update(nullptr, snapshot, lighting, pool);
    lighting.azimuth_deg = -30.0;
    lighting.elevation_deg = 15.0;
    layers.relight(snapshot, lighting, pool);
    expect_equal_to_reference(layers, snapshot, lighting);
}

TEST(CanvasLayers, ColoursCoverTheChangedTilesAndTheirBorder) {
    const document::Snapshot bare = bare_canvas();
    document::Snapshot painted = bare;
    add_lump(painted, 5, 5, 10);
    CanvasLayers layers;
    core::ThreadPool pool(2);
    layers.update(nullptr, bare, {}, pool);
    const LayerChanges changes = layers.update(&bare, painted, {}, pool);
    ASSERT_EQ(changes.colours.size(), 1U);
    EXPECT_EQ(changes.colours[0].cells, (grid::Rect{-2, -2, 64, 64}));
    const shade::CellColour& paint = changes.colours[0].colours[(7 + 2) * 66 + (7 + 2)];
    const shade::CellColour& ground = changes.colours[0].colours[(40 + 2) * 66 + (40 + 2)];
    EXPECT_FLOAT_EQ(paint.wetness, 1.0F);
    EXPECT_FLOAT_EQ(ground.wetness, 0.0F);
    EXPECT_LT(paint.green, ground.green);
}

/// Puts patches into a picture of the whole canvas and its border.
class KnownOutlines {
  public:
    void put(const std::vector<OutlinePatch>& patches) {
        for (const OutlinePatch& patch : patches) {
            std::size_t from = 0;
            for (int y = patch.cells.y0; y < patch.cells.y1; ++y)
                for (int x = patch.cells.x0; x < patch.cells.x1; ++x, ++from) {
                    texels_[index(x, y)] = patch.outline[from];
                    dry_[index(x, y)] = patch.dry[from];
                }
        }
    }

    void expect_equal_to_reference(const document::Snapshot& snapshot) const {
        core::ThreadPool pool(2);
        const shade::CellLayers layers =
            shade::cell_layers(snapshot.film, snapshot.ground, cells_, {}, pool);
        const shade::OutlineLayers reference =
            shade::outline_layers(snapshot.film, snapshot.ground, layers, pool);
        int different = 0;
        for (std::size_t i = 0; i < texels_.size(); ++i) {
            different += texels_[i].cover != reference.cover[i] ||
                         texels_[i].share != reference.share[i] ||
                         texels_[i].support_mm != reference.support_mm[i] ||
                         texels_[i].near != static_cast<float>(reference.near[i]) ||
                         dry_[i].green != reference.dry[i].green || dry_[i].sharp != reference.sharp[i];
        }
        EXPECT_EQ(different, 0);
    }

    /// Whether a sample may be near an outline.
    bool near(double x, double y) const {
        const auto first = [](double place) { return static_cast<int>(std::floor(place - 0.5)) - 1; };
        return texels_[index(first(x), first(y))].near > 0.0F;
    }

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - cells_.y0) * cells_.width() + x - cells_.x0;
    }

    grid::Rect cells_{-kLayerBorder, -kLayerBorder, kShape.width + kLayerBorder,
                      kShape.height + kLayerBorder};
    std::vector<OutlineTexel> texels_ =
        std::vector<OutlineTexel>(static_cast<std::size_t>(cells_.width()) * cells_.height());
    std::vector<DryTexel> dry_ = std::vector<DryTexel>(texels_.size());
};

TEST(CanvasOutlines, AreThoseOfTheReferenceRenderer) {
    core::ThreadPool pool(2);
    document::Snapshot snapshot = bare_canvas();
    add_lump(snapshot, 90, 60, 20);
    CanvasOutlines outlines;
    KnownOutlines known;
    outlines.reset(kShape);
    const auto update = [&](const grid::Rect& cells) {
        const auto patches = outlines.update(snapshot, cells, pigment::kBandsToLinearSrgb, pool);
        known.put(patches);
        return patches.size();
    };
    EXPECT_GT(update({0, 0, 90, 90}), 0U);
    EXPECT_GT(update(kShape.cells()), 0U);
    EXPECT_EQ(update(kShape.cells()), 0U) << "all is known";
    known.expect_equal_to_reference(snapshot);

    const document::Snapshot before = snapshot;
    add_lump(snapshot, 0, 0, 5);
    add_lump(snapshot, 126, 126, 6);  // over a corner of tiles
    outlines.forget(changed_tiles(&before, snapshot));
    EXPECT_GT(update(kShape.cells()), 0U);
    known.expect_equal_to_reference(snapshot);

    snapshot.ground.fill(0.5F);
    outlines.forget_all();
    update(kShape.cells());
    known.expect_equal_to_reference(snapshot);
}

TEST(OutlineSquares, TellWhereSamplesAreNearOutlines) {
    core::ThreadPool pool(2);
    document::Snapshot snapshot = bare_canvas();
    add_lump(snapshot, 30, 60, 70);
    add_lump(snapshot, 195, 145, 5);
    CanvasOutlines outlines;
    OutlineSquares squares;
    KnownOutlines known;
    outlines.reset(kShape);
    squares.reset(kShape);
    const auto patches = outlines.update(snapshot, kShape.cells(), pigment::kBandsToLinearSrgb, pool);
    known.put(patches);
    for (const OutlinePatch& patch : patches)
        squares.note(patch);
    const std::vector<QRect> runs = squares.cells_near(kShape.cells());
    const auto told = [&](double x, double y) {
        return std::any_of(runs.begin(), runs.end(), [&](const QRect& run) {
            return QRectF(run).adjusted(-0.5, -0.5, 0.5, 0.5).contains(x, y);
        });
    };
    for (double y = 0.1; y < kShape.height; y += 0.4)
        for (double x = 0.1; x < kShape.width; x += 0.4)
            ASSERT_TRUE(told(x, y) || !known.near(x, y)) << x << " " << y;
    EXPECT_FALSE(told(65.0, 95.0)) << "within the paint";
    EXPECT_FALSE(told(150.0, 40.0)) << "on the bare canvas";
}

}  // namespace
}  // namespace pastoso::screen
