// Where pictures lie on the board of references, in exact cases.
#include "panels/references/reference_places.hpp"

#include <memory>

#include <gtest/gtest.h>

namespace pastoso::panels {
namespace {

/// Twice as wide as high, 40 x 20 mm about (100, 50).
document::Reference wide(double turn_deg = 0.0, bool mirrored = false) {
    document::ReferencePicture picture{{80, 40, {}}, {}};
    return {.id = 1,
            .picture = std::make_shared<const document::ReferencePicture>(std::move(picture)),
            .place = {100, 50, 40, turn_deg, mirrored}};
}

void expect_near(const QPointF& a, const QPointF& b) {
    constexpr double kRounding = 1e-9;
    EXPECT_NEAR(a.x(), b.x(), kRounding);
    EXPECT_NEAR(a.y(), b.y(), kRounding);
}

TEST(ReferencePlaces, CornersGoClockwiseAndTurnWithThePicture) {
    const auto upright = corners_mm(wide());
    expect_near(upright[0], {80, 40});
    expect_near(upright[1], {120, 40});
    expect_near(upright[2], {120, 60});
    expect_near(upright[3], {80, 60});
    const auto turned = corners_mm(wide(90));
    expect_near(turned[0], {110, 30});
    expect_near(turned[1], {110, 70});
    expect_near(extent_mm(wide(90)).topLeft(), {90, 30});
    expect_near(extent_mm(wide(90)).bottomRight(), {110, 70});
}

TEST(ReferencePlaces, PixelsFollowTurnAndMirror) {
    expect_near(pixel_at(wide(), {80, 40}), {0, 0});
    expect_near(pixel_at(wide(), {110, 55}), {60, 30});
    expect_near(pixel_at(wide(0, true), {80, 40}), {80, 0});
    expect_near(pixel_at(wide(90), {110, 30}), {0, 0});
    expect_near(pixel_at(wide(90, true), {110, 30}), {80, 0});
    EXPECT_EQ(pixels_per_mm(wide()), 2.0);
}

TEST(ReferencePlaces, TheUppermostIsFound) {
    document::ReferenceBoard board{{wide(), wide()}, 3};
    board.references[1].id = 2;
    board.references[1].place.x_mm = 110;
    const auto found = [&](double x_mm, double y_mm) {
        const document::Reference* one = reference_at(board, {x_mm, y_mm});
        return one == nullptr ? 0U : one->id;
    };
    EXPECT_EQ(found(85, 50), 1U);
    EXPECT_EQ(found(100, 50), 2U);
    EXPECT_EQ(found(125, 59), 2U);
    EXPECT_EQ(found(125, 61), 0U);
    board.references[1].place.turn_deg = 90;
    EXPECT_EQ(found(125, 59), 0U);
    EXPECT_EQ(found(110, 69), 2U);
}

TEST(ReferencePlaces, ACornerIsDraggedWhileTheOppositeOneStays) {
    for (const double turn_deg : {0.0, 30.0, -90.0}) {
        const document::Reference one = wide(turn_deg);
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const QPointF fixed = corners_mm(one)[(corner + 2) % 4];
            document::Reference scaled = one;
            scaled.place = with_corner_at(one, corner, fixed + 1.5 * (corners_mm(one)[corner] - fixed));
            EXPECT_NEAR(scaled.place.width_mm, 60.0, 1e-9);
            expect_near(corners_mm(scaled)[(corner + 2) % 4], fixed);
        }
    }
}

TEST(ReferencePlaces, APictureIsNeverScaledToNothing) {
    const document::ReferencePlace least = with_corner_at(wide(), 2, {-500, -500});
    EXPECT_EQ(least.width_mm, 1.0);
    expect_near(QPointF(least.x_mm, least.y_mm), {80.5, 40.25});
}

TEST(ReferencePlaces, TheUpperEdgeFacesThePoint) {
    const document::ReferencePlace place = wide().place;
    EXPECT_NEAR(facing(place, {100, 0}, false).turn_deg, 0.0, 1e-9);
    EXPECT_NEAR(facing(place, {200, 50}, false).turn_deg, 90.0, 1e-9);
    EXPECT_NEAR(facing(place, {0, 50}, false).turn_deg, -90.0, 1e-9);
    EXPECT_EQ(facing(place, {110, 0}, true).turn_deg, 15.0);
}

TEST(ReferencePlaces, ANewOneComesBesideTheOthers) {
    const document::ReferencePlace first = place_beside({}, 0.5);
    EXPECT_EQ(first, (document::ReferencePlace{0, 0, 100, 0, false}));
    const document::ReferencePlace upright = place_beside({-50, -25, 100, 50}, 2.0);
    EXPECT_EQ(upright, (document::ReferencePlace{80, 25, 50, 0, false}));
    EXPECT_EQ(place_about({7, 8}, 1.0), (document::ReferencePlace{7, 8, 100, 0, false}));
}

TEST(ReferencePlaces, AreBroughtIntoTheRangeOfActions) {
    const document::ReferencePlace place = in_range({1e6, -1e6, 1e9, 370, true});
    EXPECT_EQ(place, (document::ReferencePlace{20000, -20000, 20000, 10, true}));
    EXPECT_EQ(in_range({.turn_deg = -550}).turn_deg, 170.0);
}

}  // namespace
}  // namespace pastoso::panels
