#include "tools/gamut_mask.hpp"

#include "core/units.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

constexpr MaskShape kShapes[] = {MaskShape::Triad, MaskShape::AtmosphericTriad,
                                 MaskShape::SplitComplementary, MaskShape::Complementary,
                                 MaskShape::Circle};

glm::dvec2 turned(const glm::dvec2& place, double angle_deg) {
    const double angle = core::radians(angle_deg);
    return {place.x * std::cos(angle) - place.y * std::sin(angle),
            place.x * std::sin(angle) + place.y * std::cos(angle)};
}

TEST(HueDisc, HasColoursByHueAndSaturation) {
    const Channels red = channels_from(ColourModel::Oklch, {255, 0, 0});
    EXPECT_NEAR(glm::length(disc_place(red)), 1.0, 1e-3) << "a corner of sRGB lies on the rim";
    EXPECT_EQ(disc_place({50.0, 0.0, 30.0}), glm::dvec2(0.0));
    const Channels colour{60.0, 0.5 * most_chroma(60.0, 90.0), 90.0};
    EXPECT_NEAR(disc_place(colour).x, 0.0, 1e-9);
    EXPECT_NEAR(disc_place(colour).y, 0.5, 1e-9);
    const Channels back = colour_on_disc(60.0, disc_place(colour), 0.0);
    EXPECT_NEAR(back[1], colour[1], 1e-9);
    EXPECT_NEAR(back[2], 90.0, 1e-9);
}

TEST(HueDisc, EndsAtItsRimAndKeepsTheHueOfGrey) {
    EXPECT_EQ(colour_on_disc(60.0, {0.0, 0.0}, 123.0), (Channels{60.0, 0.0, 123.0}));
    EXPECT_NEAR(colour_on_disc(60.0, {0.0, -3.0}, 0.0)[1], most_chroma(60.0, 270.0), 1e-9);
    EXPECT_EQ(disc_place({0.0, 0.1, 20.0}), glm::dvec2(0.0)) << "black has no chroma";
}

TEST(GamutMasks, AreConvexOnTheDiscAndTurn) {
    for (const MaskShape shape : kShapes) {
        const auto outline = mask_outline({shape, 0.0});
        const auto turned_outline = mask_outline({shape, 70.0});
        for (std::size_t i = 0; i < outline.size(); ++i) {
            EXPECT_LE(glm::length(outline[i]), 1.0 + 1e-9);
            const glm::dvec2 first = outline[(i + 1) % outline.size()] - outline[i];
            const glm::dvec2 second =
                outline[(i + 2) % outline.size()] - outline[(i + 1) % outline.size()];
            EXPECT_GT(first.x * second.y - first.y * second.x, 0.0) << static_cast<int>(shape);
            EXPECT_LT(glm::distance(turned(outline[i], 70.0), turned_outline[i]), 1e-12);
        }
    }
    EXPECT_TRUE(mask_outline({MaskShape::None, 10.0}).empty());
}

TEST(GamutMasks, HaveCornersThatCanBeMovedAndTurnWithThem) {
    const GamutMask mask{MaskShape::Triad, 90.0};
    const GamutMask moved = with_corner(mask, 0, {0.2, 0.5});
    EXPECT_EQ(moved.shape, mask.shape);
    EXPECT_LT(glm::distance(mask_outline(moved)[0], {0.2, 0.5}), 1e-12);
    for (const std::size_t other : {std::size_t{1}, std::size_t{2}})
        EXPECT_LT(glm::distance(mask_outline(moved)[other], mask_outline(mask)[other]), 1e-12);
    GamutMask further = moved;
    further.turn_deg = 160.0;
    EXPECT_LT(glm::distance(mask_outline(further)[0], turned({0.2, 0.5}, 70.0)), 1e-12);
    EXPECT_NEAR(glm::length(mask_outline(with_corner(mask, 0, {0.0, 7.0}))[0]), 1.0, 1e-12);
    EXPECT_EQ(with_corner(mask, 0, {0.0, -0.9}), mask) << "the corners would go round the other way";
    EXPECT_EQ(with_corner(moved, 0, {0.0, -0.9}), moved);
}

TEST(GamutMasks, HaveAsManyCornersAsTheirShape) {
    EXPECT_EQ(movable_corners(MaskShape::None), 0U);
    EXPECT_EQ(movable_corners(MaskShape::Circle), 0U);
    EXPECT_EQ(movable_corners(MaskShape::SplitComplementary), 5U);
    const std::vector<glm::dvec2> triangle = {{0.5, 0.0}, {0.0, 0.5}, {-0.5, 0.0}};
    EXPECT_TRUE(are_corners(triangle, MaskShape::Triad));
    EXPECT_FALSE(are_corners(triangle, MaskShape::Complementary));
    EXPECT_FALSE(are_corners({}, MaskShape::None));
    EXPECT_FALSE(are_corners({triangle[2], triangle[1], triangle[0]}, MaskShape::Triad)) << "clockwise";
    EXPECT_FALSE(are_corners({{2.0, 0.0}, {0.0, 0.5}, {-0.5, 0.0}}, MaskShape::Triad)) << "off the disc";
    EXPECT_FALSE(are_corners({{0.5, 0.0}, {0.0, 0.0}, {-0.5, 0.0}}, MaskShape::Triad)) << "flat";
}

TEST(GamutMasks, HoldWhatIsOutsideToTheNearestPlace) {
    const std::vector<glm::dvec2> square = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};
    EXPECT_EQ(held_inside(square, {0.3, -0.9}), glm::dvec2(0.3, -0.9));
    EXPECT_EQ(held_inside(square, {3.0, 0.25}), glm::dvec2(1.0, 0.25));
    EXPECT_EQ(held_inside(square, {-2.0, 5.0}), glm::dvec2(-1.0, 1.0));
    EXPECT_EQ(held_inside({}, {-2.0, 5.0}), glm::dvec2(-2.0, 5.0));
}

TEST(GamutMasks, HoldAColourAtItsLightness) {
    const GamutMask triad{MaskShape::Triad, 30.0};
    const Channels outside{60.0, most_chroma(60.0, 90.0), 90.0};
    const Channels held = held_in_mask(triad, outside);
    EXPECT_EQ(held[0], 60.0);
    EXPECT_NEAR(held[2], 90.0, 1e-6) << "half way between two corners";
    EXPECT_NEAR(held[1], 0.5 * outside[1], 1e-6) << "an equilateral triangle is half as deep there";
    const Channels again = held_in_mask(triad, held);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(again[i], held[i], 1e-9) << "what is held stays";
    EXPECT_EQ(held_in_mask(triad, {60.0, 0.02, 200.0}), (Channels{60.0, 0.02, 200.0}));
    EXPECT_EQ(held_in_mask(GamutMask{}, outside), outside);
}

}  // namespace
}  // namespace pastoso::tools
