#include "document/cloth.hpp"

#include "core/error.hpp"
#include "core/units.hpp"
#include "document/canvas.hpp"
#include "layers/resampling.hpp"
#include "layers/turning.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::document {
namespace {

/// Differences so small come of rounding.
constexpr double kRounding = 1e-9;

bool lies_straight(const CanvasSettings& settings) {
    return settings.support_map == ClothMap{};
}

/// The cells of the turned cloth that a canvas is of; of one that has a map, the nearest.
grid::Rect cells_of_cloth(const CanvasSettings& settings) {
    const grid::Shape shape = canvas_shape(settings);
    const int x0 = cells_from_origin(settings.support_x_mm, settings.px_per_mm);
    const int y0 = cells_from_origin(settings.support_y_mm, settings.px_per_mm);
    return {x0, y0, x0 + shape.width, y0 + shape.height};
}

/// Cells of a cloth that has been turned by quarters alone.
film::SupportHeights woven(const CanvasSettings& settings, const grid::Rect& cells_of_turned,
                           core::ThreadPool& pool, film::SupportForm form) {
    const core::Orientation& turn = settings.support_turn;
    const grid::Rect cells = core::turned_rectangle(cells_of_turned, core::reversed(turn));
    film::SupportHeights heights =
        film::named_support(settings.support, {cells.width(), cells.height()}, 1.0 / settings.px_per_mm,
                            settings.support_relief_mm, pool, form, {cells.x0, cells.y0});
    return turn == core::Orientation{} ? heights : layers::turned(heights, turn, pool);
}

/// More cells than the canvas has need not be woven many times over. Throws InputError.
void check_can_be_woven(double width, double height, const grid::Shape& canvas) {
    constexpr double kMostTimes = 64.0, kMostSide = 1e9, kSmall = 64.0;
    const double most = kMostTimes * (canvas.width + kSmall) * (canvas.height + kSmall);
    if (width < kMostSide && height < kMostSide && width * height <= most) return;
    throw core::InputError(
        "The cloth has been drawn out too unevenly: for a canvas of %1 x %2 cells, "
        "%3 x %4 would have to be woven.",
        canvas.width, canvas.height, width, height);
}

/// Those that the map brings onto a canvas, and some around them. Throws InputError where they are far
/// too many.
grid::Rect cells_before(const layers::Projective& map, const grid::Shape& canvas) {
    constexpr double kAround = 2.0;
    const layers::Projective back = layers::inverse(map);
    double x0 = HUGE_VAL, y0 = HUGE_VAL, x1 = -HUGE_VAL, y1 = -HUGE_VAL;
    for (const double x : {0.0, 1.0 * canvas.width})
        for (const double y : {0.0, 1.0 * canvas.height}) {
            const grid::Point corner = back(x, y);
            x0 = std::min(x0, corner.x - kAround);
            y0 = std::min(y0, corner.y - kAround);
            x1 = std::max(x1, corner.x + kAround);
            y1 = std::max(y1, corner.y + kAround);
        }
    check_can_be_woven(std::ceil(x1 - x0), std::ceil(y1 - y0), canvas);
    return {static_cast<int>(std::floor(x0)), static_cast<int>(std::floor(y0)),
            static_cast<int>(std::ceil(x1)), static_cast<int>(std::ceil(y1))};
}

layers::Projective about_origin(const ClothMap& map) {
    return {.a = map.xx, .b = map.xy, .d = map.yx, .e = map.yy};
}

/// Of a map that leaves the origin where it is.
ClothMap cloth_map(const layers::Projective& map) {
    return {map.a, map.b, map.d, map.e};
}

ClothMap followed_by(const ClothMap& first, const ClothMap& then) {
    return cloth_map(layers::followed_by(about_origin(first), about_origin(then)));
}

ClothMap map_of(const core::Orientation& turn) {
    const auto right = core::turned(core::PlanePoint{1.0, 0.0}, turn);
    const auto down = core::turned(core::PlanePoint{0.0, 1.0}, turn);
    return {right.x, down.x, right.y, down.y};
}

/// A map that is no more than rounding is none.
ClothMap without_rounding(const ClothMap& map) {
    const bool is_none = std::abs(map.xx - 1.0) < kRounding && std::abs(map.xy) < kRounding &&
                         std::abs(map.yx) < kRounding && std::abs(map.yy - 1.0) < kRounding;
    return is_none ? ClothMap{} : map;
}

/// By how much the map turns, clockwise, apart from what it draws out.
double angle_deg(const ClothMap& map) {
    return core::degrees(std::atan2(map.yx - map.xy, map.xx + map.yy));
}

/// How many of the canvas's cells are as long as one of those that a cloth is woven of before it is
/// drawn: as many as the cell becomes long, so that means are of few, but at least one. No more than
/// 16 woven cells come to lie in one of the canvas.
double length_of_woven(const ClothMap& map) {
    constexpr double kMostCells = 16.0;
    const DrawnOut drawn = drawn_out(map);
    const double fewest = std::sqrt(kMostCells * drawn.most * drawn.least);
    return 1.0 / std::min({1.0, drawn.most, fewest});
}

/// Means over the canvas's cells of a cloth that is woven straight; in levels, since means do not tell
/// in which form they were woven.
film::SupportHeights woven_and_drawn(const CanvasSettings& settings, core::ThreadPool& pool) {
    const double px_per_mm = settings.px_per_mm, cells = length_of_woven(settings.support_map);
    CanvasSettings straight = settings;
    straight.px_per_mm = px_per_mm / cells;
    const layers::Projective onto_canvas = layers::followed_by(
        layers::followed_by({.a = cells, .e = cells}, about_origin(settings.support_map)),
        {.c = -settings.support_x_mm * px_per_mm, .f = -settings.support_y_mm * px_per_mm});
    const grid::Shape shape = canvas_shape(settings);
    const grid::Rect before = cells_before(onto_canvas, shape);
    const layers::Projective from_before =
        layers::followed_by({.c = 1.0 * before.x0, .f = 1.0 * before.y0}, onto_canvas);
    return layers::resampled(woven(straight, before, pool, film::SupportForm::Levels),
                             {from_before, shape, 1.0 / px_per_mm, layers::Beyond::GoesOn}, pool);
}

/// What a place is beside whole cells of a cloth that has a map.
double beside_cells(double place_mm, const CanvasSettings& settings) {
    if (lies_straight(settings)) return 0.0;
    return place_mm - on_whole_cells(place_mm, settings.px_per_mm);
}

}  // namespace

int cells_from_origin(double place_mm, double px_per_mm) {
    return static_cast<int>(std::lround(place_mm * px_per_mm));
}

double on_whole_cells(double place_mm, double px_per_mm) {
    return cells_from_origin(place_mm, px_per_mm) / px_per_mm;
}

DrawnOut drawn_out(const ClothMap& map) {
    const double sum = map.xx * map.xx + map.xy * map.xy + map.yx * map.yx + map.yy * map.yy;
    const double area = std::abs(map.xx * map.yy - map.xy * map.yx);
    const double most = std::sqrt(0.5 * (sum + std::sqrt(std::max(0.0, sum * sum - 4.0 * area * area))));
    return {most, most > 0.0 ? area / most : 0.0};
}

ClothMap cloth_turned_by(double angle_deg) {
    return cloth_map(layers::turn_by(angle_deg));
}

film::SupportHeights heights_of_cloth(const CanvasSettings& settings, core::ThreadPool& pool,
                                      film::SupportForm form) {
    return lies_straight(settings) ? woven(settings, cells_of_cloth(settings), pool, form)
                                   : woven_and_drawn(settings, pool);
}

CanvasSettings with_turned_cloth(const core::Orientation& turn, CanvasSettings settings) {
    const grid::Rect cells = core::turned_rectangle(cells_of_cloth(settings), turn);
    const auto beside = core::turned(core::PlanePoint{beside_cells(settings.support_x_mm, settings),
                                                      beside_cells(settings.support_y_mm, settings)},
                                     turn);
    settings.support_x_mm = cells.x0 / settings.px_per_mm + beside.x;
    settings.support_y_mm = cells.y0 / settings.px_per_mm + beside.y;
    settings.support_turn = core::followed_by(settings.support_turn, turn);
    settings.support_map =
        followed_by(followed_by(map_of(core::reversed(turn)), settings.support_map), map_of(turn));
    return settings;
}

CanvasSettings with_drawn_out_cloth(double scale_x, double scale_y, CanvasSettings settings) {
    if (settings.support != "image")
        settings.support_map =
            without_rounding(followed_by(settings.support_map, {.xx = scale_x, .yy = scale_y}));
    settings.support_x_mm *= scale_x;
    settings.support_y_mm *= scale_y;
    if (lies_straight(settings)) {
        settings.support_x_mm = on_whole_cells(settings.support_x_mm, settings.px_per_mm);
        settings.support_y_mm = on_whole_cells(settings.support_y_mm, settings.px_per_mm);
    }
    return settings;
}

CanvasSettings with_rotated_cloth(double turn_deg, const layers::Place& middle_before,
                                  const layers::Place& middle_after, CanvasSettings settings) {
    constexpr double kQuarter_deg = 90.0;
    const grid::Point middle = layers::turn_by(turn_deg)(middle_before.x_mm + settings.support_x_mm,
                                                         middle_before.y_mm + settings.support_y_mm);
    settings.support_x_mm = middle.x - middle_after.x_mm;
    settings.support_y_mm = middle.y - middle_after.y_mm;
    const ClothMap map = followed_by(settings.support_map, cloth_turned_by(turn_deg));
    const auto quarters = static_cast<int>(std::lround(angle_deg(map) / kQuarter_deg));
    const core::Orientation whole{false, (quarters + 4) % 4};
    settings.support_turn = core::followed_by(settings.support_turn, whole);
    settings.support_map = without_rounding(followed_by(map_of(core::reversed(whole)), map));
    return settings;
}

}  // namespace pastoso::document
