#include "document/cloth.hpp"

#include "core/units.hpp"
#include "document/canvas.hpp"
#include "layers/resampling.hpp"
#include "layers/turning.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::document {
namespace {

/// The cells of the turned cloth that a canvas is of; of one that lies askew, the nearest.
grid::Rect cells_of_cloth(const CanvasSettings& settings) {
    const grid::Shape shape = canvas_shape(settings);
    const int x0 = cells_from_origin(settings.support_x_mm, settings.px_per_mm);
    const int y0 = cells_from_origin(settings.support_y_mm, settings.px_per_mm);
    return {x0, y0, x0 + shape.width, y0 + shape.height};
}

/// Cells of a cloth that does not lie askew.
film::SupportHeights woven(const CanvasSettings& settings, const grid::Rect& cells_of_turned,
                           core::ThreadPool& pool, film::SupportForm form) {
    const core::Orientation& turn = settings.support_turn;
    const grid::Rect cells = core::turned_rectangle(cells_of_turned, core::reversed(turn));
    film::SupportHeights heights =
        film::named_support(settings.support, {cells.width(), cells.height()}, 1.0 / settings.px_per_mm,
                            settings.support_relief_mm, pool, form, {cells.x0, cells.y0});
    return turn == core::Orientation{} ? heights : layers::turned(heights, turn, pool);
}

/// Those that the map brings onto a canvas, and some around them.
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
    return {static_cast<int>(std::floor(x0)), static_cast<int>(std::floor(y0)),
            static_cast<int>(std::ceil(x1)), static_cast<int>(std::ceil(y1))};
}

/// Means over the canvas's cells of a cloth that is woven upright; in levels, since means do not tell in
/// which form they were woven.
film::SupportHeights woven_askew(const CanvasSettings& settings, core::ThreadPool& pool) {
    const double px_per_mm = settings.px_per_mm;
    const layers::Projective onto_canvas = layers::followed_by(
        layers::turn_by(settings.support_askew_deg),
        {.c = -settings.support_x_mm * px_per_mm, .f = -settings.support_y_mm * px_per_mm});
    const grid::Shape shape = canvas_shape(settings);
    const grid::Rect cells = cells_before(onto_canvas, shape);
    const layers::Projective from_cells =
        layers::followed_by({.c = 1.0 * cells.x0, .f = 1.0 * cells.y0}, onto_canvas);
    return layers::resampled(woven(settings, cells, pool, film::SupportForm::Levels),
                             {from_cells, shape, 1.0 / px_per_mm, layers::Beyond::GoesOn}, pool);
}

/// What a place is beside whole cells of a cloth that lies askew.
double beside_cells(double place_mm, const CanvasSettings& settings) {
    if (settings.support_askew_deg == 0.0) return 0.0;
    return place_mm - on_whole_cells(place_mm, settings.px_per_mm);
}

}  // namespace

int cells_from_origin(double place_mm, double px_per_mm) {
    return static_cast<int>(std::lround(place_mm * px_per_mm));
}

double on_whole_cells(double place_mm, double px_per_mm) {
    return cells_from_origin(place_mm, px_per_mm) / px_per_mm;
}

film::SupportHeights heights_of_cloth(const CanvasSettings& settings, core::ThreadPool& pool,
                                      film::SupportForm form) {
    return settings.support_askew_deg == 0.0 ? woven(settings, cells_of_cloth(settings), pool, form)
                                             : woven_askew(settings, pool);
}

CanvasSettings with_turned_cloth(const core::Orientation& turn, CanvasSettings settings) {
    const grid::Rect cells = core::turned_rectangle(cells_of_cloth(settings), turn);
    const auto beside = core::turned(core::PlanePoint{beside_cells(settings.support_x_mm, settings),
                                                      beside_cells(settings.support_y_mm, settings)},
                                     turn);
    settings.support_x_mm = cells.x0 / settings.px_per_mm + beside.x;
    settings.support_y_mm = cells.y0 / settings.px_per_mm + beside.y;
    settings.support_turn = core::followed_by(settings.support_turn, turn);
    if (turn.mirrored) settings.support_askew_deg = 0.0 - settings.support_askew_deg;
    return settings;
}

CanvasSettings with_rotated_cloth(double turn_deg, const layers::Place& middle_before,
                                  const layers::Place& middle_after, CanvasSettings settings) {
    constexpr double kQuarter_deg = 90.0;
    const grid::Point middle = layers::turn_by(turn_deg)(middle_before.x_mm + settings.support_x_mm,
                                                         middle_before.y_mm + settings.support_y_mm);
    settings.support_x_mm = middle.x - middle_after.x_mm;
    settings.support_y_mm = middle.y - middle_after.y_mm;
    const double askew_deg = settings.support_askew_deg + turn_deg;
    settings.support_askew_deg = std::remainder(askew_deg, kQuarter_deg);
    const auto quarters =
        static_cast<int>(std::lround((askew_deg - settings.support_askew_deg) / kQuarter_deg) % 4);
    settings.support_turn = core::followed_by(settings.support_turn, {false, (quarters + 4) % 4});
    return settings;
}

}  // namespace pastoso::document
