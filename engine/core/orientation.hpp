// The eight ways in which a rectangle of cells can lie on its grid. x runs right, y down.
#pragma once

#include <algorithm>
#include <utility>

namespace pastoso::core {

/// Mirrored left for right first, where it is, then turned clockwise.
struct Orientation {
    bool mirrored = false;
    int quarter_turns = 0;  ///< 0 to 3

    constexpr bool swaps_sides() const { return quarter_turns % 2 != 0; }
    friend bool operator==(const Orientation&, const Orientation&) = default;
};

/// As by one after the other.
constexpr Orientation followed_by(const Orientation& first, const Orientation& second) {
    const int turned = second.mirrored ? 4 - first.quarter_turns : first.quarter_turns;
    return {first.mirrored != second.mirrored, (turned + second.quarter_turns) % 4};
}

/// What takes it back.
constexpr Orientation reversed(const Orientation& orientation) {
    if (orientation.mirrored) return orientation;
    return {false, (4 - orientation.quarter_turns) % 4};
}

/// A point, a direction or a cell by its corner.
template <class T>
struct PlanePoint {
    T x, y;
    friend bool operator==(const PlanePoint&, const PlanePoint&) = default;
};

/// About the origin.
template <class T>
constexpr PlanePoint<T> turned(PlanePoint<T> point, const Orientation& turn) {
    if (turn.mirrored) point.x = -point.x;
    for (int quarter = 0; quarter < turn.quarter_turns; ++quarter)
        point = {-point.y, point.x};
    return point;
}

/// A rectangle about the origin; x0 <= x1, y0 <= y1.
template <class Rect>
constexpr Rect turned_rectangle(const Rect& rectangle, const Orientation& turn) {
    const auto a = turned(PlanePoint{rectangle.x0, rectangle.y0}, turn);
    const auto b = turned(PlanePoint{rectangle.x1, rectangle.y1}, turn);
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
}

/// Where the cells of a rectangle were before it was turned so that its corner lies at (0, 0) again.
class CellsBefore {
  public:
    /// `width` and `height` are those before.
    constexpr CellsBefore(const Orientation& turn, int width, int height)
        : right_(turned(PlanePoint{1, 0}, reversed(turn))),
          down_(turned(PlanePoint{0, 1}, reversed(turn))),
          first_{right_.x + down_.x > 0 ? 0 : width - 1, right_.y + down_.y > 0 ? 0 : height - 1} {}

    constexpr PlanePoint<int> operator()(int x, int y) const {
        return {first_.x + x * right_.x + y * down_.x, first_.y + x * right_.y + y * down_.y};
    }
    /// What was the step to the next cell on the right, and to the one below.
    constexpr PlanePoint<int> right() const { return right_; }
    constexpr PlanePoint<int> down() const { return down_; }

  private:
    PlanePoint<int> right_, down_, first_;
};

}  // namespace pastoso::core
