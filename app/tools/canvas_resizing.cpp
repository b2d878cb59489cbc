#include "tools/canvas_resizing.hpp"

#include "core/units.hpp"
#include "tools/selecting.hpp"

#include <cmath>
#include <utility>
#include <variant>

namespace pastoso::tools {
namespace {

/// Half for the middle.
double share_before(int anchor) {
    return 0.5 * anchor;
}

void move_point(const CanvasMove& move, double& x_mm, double& y_mm) {
    const glm::dvec2 place_mm = move({x_mm, y_mm});
    x_mm = place_mm.x;
    y_mm = place_mm.y;
}

double turned_deg(double angle_deg, const CanvasMove& move) {
    const core::Orientation& turn = move.turn;
    if (turn == core::Orientation{} && move.rotated_deg == 0.0) return angle_deg;
    constexpr double kQuarter_deg = 90.0, kWhole_deg = 360.0;
    const double mirrored_deg = turn.mirrored ? -angle_deg : angle_deg;
    return std::remainder(mirrored_deg + kQuarter_deg * turn.quarter_turns + move.rotated_deg,
                          kWhole_deg);
}

glm::dvec2 rotated(const glm::dvec2& place_mm, double angle_deg) {
    if (angle_deg == 0.0) return place_mm;
    const grid::Point there = layers::turn_by(angle_deg)(place_mm.x, place_mm.y);
    return {there.x, there.y};
}

/// Of its cells.
glm::dvec2 middle_mm(const document::CanvasSettings& settings) {
    const grid::Shape shape = document::canvas_shape(settings);
    return 0.5 / settings.px_per_mm * glm::dvec2(shape.width, shape.height);
}

/// About the middle.
CanvasMove rotation_between(const document::BareCanvas& before, const document::BareCanvas& after) {
    CanvasMove move;
    move.rotated_deg = after.rotated_deg - before.rotated_deg;
    move.shift_mm = middle_mm(after.settings) - rotated(middle_mm(before.settings), move.rotated_deg);
    return move;
}

/// A direction, or that of an axis.
double moved_deg(double angle_deg, const CanvasMove& move) {
    const double turned = turned_deg(angle_deg, move);
    if (move.scale.x == move.scale.y) return turned;
    const double angle = core::radians(turned);
    return core::degrees(std::atan2(move.scale.y * std::sin(angle), move.scale.x * std::cos(angle)));
}

brush::Ruler moved(brush::Ruler ruler, const CanvasMove& move) {
    move_point(move, ruler.x1_mm, ruler.y1_mm);
    move_point(move, ruler.x2_mm, ruler.y2_mm);
    return ruler;
}

/// The points A u, |u| = 1, of an ellipse are at its half axes where they are longest and shortest: the
/// eigenvectors of A A^T.
brush::EllipseCurve drawn_out(brush::EllipseCurve ellipse, const glm::dvec2& scale) {
    if (scale == glm::dvec2(1.0)) return ellipse;
    const double turn = core::radians(ellipse.turn_deg);
    const glm::dvec2 along(std::cos(turn), std::sin(turn)), across(-along.y, along.x);
    const glm::dvec2 a = ellipse.half_width_mm * scale * along,
                     b = ellipse.half_height_mm * scale * across;
    const double xx = a.x * a.x + b.x * b.x, yy = a.y * a.y + b.y * b.y, xy = a.x * a.y + b.x * b.y;
    const double middle = 0.5 * (xx + yy), apart = std::hypot(0.5 * (xx - yy), xy);
    const bool longer_along = ellipse.half_width_mm >= ellipse.half_height_mm;
    const double longer_deg = core::degrees(0.5 * std::atan2(2.0 * xy, xx - yy));
    ellipse.half_width_mm = std::sqrt(longer_along ? middle + apart : middle - apart);
    ellipse.half_height_mm = std::sqrt(longer_along ? middle - apart : middle + apart);
    ellipse.turn_deg = longer_along ? longer_deg : longer_deg - 90.0;
    return ellipse;
}

brush::EllipseCurve moved(brush::EllipseCurve ellipse, const CanvasMove& move) {
    move_point(move, ellipse.centre_x_mm, ellipse.centre_y_mm);
    ellipse.turn_deg = turned_deg(ellipse.turn_deg, move);
    return drawn_out(ellipse, move.scale);
}

brush::Symmetry moved(brush::Symmetry symmetry, const CanvasMove& move) {
    move_point(move, symmetry.centre_x_mm, symmetry.centre_y_mm);
    symmetry.axis_deg = moved_deg(symmetry.axis_deg, move);
    return symmetry;
}

brush::VanishingPoints moved(brush::VanishingPoints points, const CanvasMove& move) {
    move_point(move, points.x1_mm, points.y1_mm);
    move_point(move, points.x2_mm, points.y2_mm);
    move_point(move, points.x3_mm, points.y3_mm);
    points.level_deg = moved_deg(points.level_deg, move);
    points.upright_deg = moved_deg(points.upright_deg, move);
    return points;
}

/// Of lines that have come to run in that direction: a strip between two becomes as much wider as its
/// area does, and narrower as it becomes longer.
double moved_spacing_mm(double spacing_mm, double direction_deg, const CanvasMove& move) {
    if (move.scale == glm::dvec2(1.0)) return spacing_mm;
    const double angle = core::radians(direction_deg);
    return spacing_mm * std::hypot(move.scale.y * std::cos(angle), move.scale.x * std::sin(angle));
}

brush::Grid moved(brush::Grid grid, const CanvasMove& move) {
    move_point(move, grid.x_mm, grid.y_mm);
    grid.direction_deg = moved_deg(grid.direction_deg, move);
    grid.other_direction_deg = moved_deg(grid.other_direction_deg, move);
    grid.spacing_mm = moved_spacing_mm(grid.spacing_mm, grid.direction_deg, move);
    grid.other_spacing_mm = moved_spacing_mm(grid.other_spacing_mm, grid.other_direction_deg, move);
    return grid;
}

/// What lies nowhere stays as it is.
template <class Form>
Form moved(Form form, const CanvasMove&) {
    return form;
}

brush::PenGuide moved(brush::PenGuide guide, const CanvasMove& move) {
    std::visit([&](const auto& form) { guide.form = moved(form, move); },
               decltype(guide.form)(guide.form));
    return guide;
}

}  // namespace

document::ResizeCanvas anchored(const document::CanvasSettings& canvas, double width_mm,
                                double height_mm, const Anchor& anchor) {
    return {share_before(anchor.column) * (canvas.width_mm - width_mm),
            share_before(anchor.row) * (canvas.height_mm - height_mm), width_mm, height_mm};
}

Margins margins_of(const document::ResizeCanvas& resize, const document::CanvasSettings& canvas) {
    const grid::Shape before = document::canvas_shape(canvas);
    const grid::Extent after = document::extent_of(resize, canvas);
    const auto mm = [&](int cells) { return cells / canvas.px_per_mm; };
    return {mm(-after.x0), mm(-after.y0), mm(after.x0 + after.shape.width - before.width),
            mm(after.y0 + after.shape.height - before.height)};
}

std::optional<document::ResizeCanvas> cropped_to(const document::Selection& selection,
                                                 const document::CanvasSettings& canvas) {
    if (selection == nullptr) return std::nullopt;
    const grid::Rect cells = outlined_area(selection);
    if (cells.empty() || cells == document::canvas_shape(canvas).cells()) return std::nullopt;
    const auto mm = [&](int count) { return count / canvas.px_per_mm; };
    return document::ResizeCanvas{mm(cells.x0), mm(cells.y0), mm(cells.width()), mm(cells.height())};
}

glm::dvec2 CanvasMove::operator()(const glm::dvec2& place_mm) const {
    const auto turned = core::turned(core::PlanePoint{place_mm.x, place_mm.y}, turn);
    return scale * rotated({turned.x, turned.y}, rotated_deg) + shift_mm;
}

/// Both canvases lie on the same cloth.
CanvasMove move_between(const document::CanvasSettings& before, const document::CanvasSettings& after) {
    CanvasMove move{core::followed_by(core::reversed(before.support_turn), after.support_turn)};
    move.shift_mm = move({before.support_x_mm, before.support_y_mm}) -
                    glm::dvec2(after.support_x_mm, after.support_y_mm);
    return move;
}

CanvasMove move_between(const document::BareCanvas& before, const document::BareCanvas& after) {
    if (after.rotated_deg != before.rotated_deg) return rotation_between(before, after);
    CanvasMove move = move_between(before.settings, after.settings);
    glm::dvec2 drawn_out(before.drawn_out_x, before.drawn_out_y);
    if (move.turn.swaps_sides()) drawn_out = {drawn_out.y, drawn_out.x};
    move.scale = glm::dvec2(after.drawn_out_x, after.drawn_out_y) / drawn_out;
    if (move.scale != glm::dvec2(1.0)) move.shift_mm = {};
    return move;
}

glm::dvec2 shift_of_middle_mm(const document::CanvasSettings& before, const CanvasMove& move) {
    const glm::dvec2 middle_mm = 0.5 * glm::dvec2(before.width_mm, before.height_mm);
    return move(middle_mm) - middle_mm;
}

double straightening_deg(const brush::Ruler& ruler) {
    const double angle = std::atan2(ruler.y2_mm - ruler.y1_mm, ruler.x2_mm - ruler.x1_mm);
    return -std::remainder(core::degrees(angle), 90.0);
}

Hand moved_along(Hand hand, const CanvasMove& move) {
    hand.symmetry = moved(hand.symmetry, move);
    hand.laid = moved(hand.laid, move);
    hand.guide = moved(hand.guide, move);
    move_point(move, hand.air.fan_x_mm, hand.air.fan_y_mm);
    hand.air.fan_radius_mm *= std::sqrt(move.scale.x * move.scale.y);
    return hand;
}

}  // namespace pastoso::tools
