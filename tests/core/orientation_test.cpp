#include "core/orientation.hpp"

#include <gtest/gtest.h>

namespace pastoso::core {
namespace {

constexpr Orientation kMirror{true, 0}, kRight{false, 1}, kLeft{false, 3}, kAround{false, 2};

template <class Visit>
void for_all(const Visit& visit) {
    for (const bool mirrored : {false, true})
        for (int quarter_turns = 0; quarter_turns < 4; ++quarter_turns)
            visit(Orientation{mirrored, quarter_turns});
}

TEST(Orientations, AQuarterTurnIsClockwiseWhereYRunsDown) {
    EXPECT_EQ(turned(PlanePoint{1, 0}, kRight), (PlanePoint{0, 1}));
    EXPECT_EQ(turned(PlanePoint{0, 1}, kRight), (PlanePoint{-1, 0}));
    EXPECT_EQ(turned(PlanePoint{2, 5}, kMirror), (PlanePoint{-2, 5}));
    EXPECT_EQ(turned(PlanePoint{2, 5}, Orientation{true, 1}), (PlanePoint{-5, -2}))
        << "mirrored, then turned";
}

TEST(Orientations, OneAfterTheOtherIsWhatBothDoToAPoint) {
    constexpr PlanePoint kPoint{3, 7};
    for_all([&](const Orientation& first) {
        for_all([&](const Orientation& second) {
            EXPECT_EQ(turned(kPoint, followed_by(first, second)), turned(turned(kPoint, first), second));
        });
        EXPECT_EQ(followed_by(first, reversed(first)), Orientation{});
    });
    EXPECT_EQ(followed_by(kRight, kLeft), Orientation{});
    EXPECT_EQ(followed_by(kRight, kRight), kAround);
}

TEST(Orientations, CellsComeFromWhereTheyWere) {
    const auto expect_corner = [](const Orientation& turn, PlanePoint<int> first, PlanePoint<int> last) {
        const CellsBefore before(turn, 5, 3);
        const int width = turn.swaps_sides() ? 3 : 5, height = turn.swaps_sides() ? 5 : 3;
        EXPECT_EQ(before(0, 0), first);
        EXPECT_EQ(before(width - 1, height - 1), last);
    };
    expect_corner({}, {0, 0}, {4, 2});
    expect_corner(kMirror, {4, 0}, {0, 2});
    expect_corner({true, 2}, {0, 2}, {4, 0});
    expect_corner(kRight, {0, 2}, {4, 0});
    expect_corner(kLeft, {4, 0}, {0, 2});
    expect_corner(kAround, {4, 2}, {0, 0});
    expect_corner({true, 3}, {0, 0}, {4, 2});
    expect_corner({true, 1}, {4, 2}, {0, 0});
    EXPECT_EQ(CellsBefore(kRight, 5, 3)(1, 0), (PlanePoint{0, 1}));
}

TEST(Orientations, RectanglesKeepTheirCornersInOrder) {
    struct Rect {
        int x0, y0, x1, y1;
        bool operator==(const Rect&) const = default;
    };
    EXPECT_EQ(turned_rectangle(Rect{1, 2, 4, 8}, kMirror), (Rect{-4, 2, -1, 8}));
    EXPECT_EQ(turned_rectangle(Rect{1, 2, 4, 8}, kRight), (Rect{-8, 1, -2, 4}));
}

}  // namespace
}  // namespace pastoso::core
