#include "tools/transform_frame.hpp"

#include "core/units.hpp"
#include "document/actions/actions.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace pastoso::tools {
namespace {

constexpr double kAngleStep_deg = 15.0;
constexpr double kRightAngle_deg = 90.0;

glm::dvec2 turned(const glm::dvec2& vector, double angle_deg) {
    const double angle = core::radians(angle_deg);
    const double cosine = std::cos(angle), sine = std::sin(angle);
    return {cosine * vector.x - sine * vector.y, sine * vector.x + cosine * vector.y};
}

double angle_deg(const glm::dvec2& vector) {
    return core::degrees(std::atan2(vector.y, vector.x));
}

glm::dvec2 in_whole_cells(const glm::dvec2& vector_mm, double cell_mm) {
    return cell_mm * glm::round(vector_mm / cell_mm);
}

double possible_scale(double scale) {
    return std::copysign(std::clamp(std::abs(scale), document::kLeastScale, document::kMostScale),
                         scale);
}

/// Where the centre of the box is now.
glm::dvec2 middle_mm(const TransformFrame& frame) {
    return frame.centre_mm() + frame.move_mm;
}

/// A place as the frame sees it: from its middle, turned with it.
glm::dvec2 seen_from(const TransformFrame& frame, const glm::dvec2& place_mm) {
    return turned(place_mm - middle_mm(frame), -frame.turn_deg);
}

TransformFrame moved(TransformFrame frame, glm::dvec2 way_mm, bool constrained, double cell_mm) {
    if (constrained) {
        const bool level = std::abs(way_mm.x) >= std::abs(way_mm.y);
        way_mm = level ? glm::dvec2(way_mm.x, 0.0) : glm::dvec2(0.0, way_mm.y);
    }
    frame.move_mm += in_whole_cells(way_mm, cell_mm);
    return frame;
}

TransformFrame turned_by(TransformFrame frame, const glm::dvec2& from_mm, const glm::dvec2& to_mm,
                         bool constrained) {
    const glm::dvec2 middle = middle_mm(frame);
    double turn = frame.turn_deg + angle_deg(to_mm - middle) - angle_deg(from_mm - middle);
    if (constrained) turn = kAngleStep_deg * std::round(turn / kAngleStep_deg);
    frame.turn_deg = std::remainder(turn, 360.0);
    return frame;
}

/// Scales by which the handle comes to a place, seen from the opposite one in the frame's own axes.
glm::dvec2 wanted_scale(const TransformFrame& frame, const glm::ivec2& side, const glm::dvec2& reach_mm,
                        bool constrained) {
    const glm::dvec2 spans = glm::dvec2(side) * frame.size_mm;
    if (!constrained) {
        return {side.x != 0 ? reach_mm.x / spans.x : frame.scale.x,
                side.y != 0 ? reach_mm.y / spans.y : frame.scale.y};
    }
    const glm::dvec2 diagonal = spans * frame.scale;
    const double ratio = glm::dot(reach_mm, diagonal) / glm::dot(diagonal, diagonal);
    const glm::dvec2 same = ratio * frame.scale;
    // A side that is drawn across the opposite one mirrors, and does not turn what it mirrors.
    return {side.x != 0 ? same.x : std::copysign(same.x, frame.scale.x),
            side.y != 0 ? same.y : std::copysign(same.y, frame.scale.y)};
}

TransformFrame scaled(TransformFrame frame, const glm::ivec2& side, const glm::dvec2& way_mm,
                      bool constrained) {
    const glm::dvec2 opposite = handle_mm(frame, -side);
    const glm::dvec2 reach = turned(handle_mm(frame, side) + way_mm - opposite, -frame.turn_deg);
    const glm::dvec2 wanted = wanted_scale(frame, side, reach, constrained);
    frame.scale = {possible_scale(wanted.x), possible_scale(wanted.y)};
    frame.move_mm += opposite - handle_mm(frame, -side);
    return frame;
}

/// Whether the paint of that cell of a tile would be seen, were nothing around it.
bool holds_paint(const film::FilmState& film, int tile, int cell) {
    return film.thickness.read(tile)[cell] > 0 ||
           film.strata.optics.read(tile)[cell] != film::kClearStrata ||
           film.strata.soluble_thickness.read(tile)[cell] > 0;
}

bool is_bare(const film::FilmState& film, int tile) {
    return film.thickness.is_background(tile) && film.strata.optics.is_background(tile) &&
           film.strata.soluble_thickness.is_background(tile);
}

}  // namespace

grid::Rect painted_cells(const document::Snapshot& painting) {
    const film::FilmState& film = painting.active != nullptr ? *painting.active : painting.film;
    const grid::Mask* selection = painting.selection.get();
    grid::Rect found{};
    for (int tile = 0; tile < film.shape.tile_count(); ++tile) {
        if (is_bare(film, tile) || (selection != nullptr && grid::chooses_none(*selection, tile)))
            continue;
        const grid::Rect cells = film.shape.tile_cells(tile);
        for (int y = cells.y0; y < cells.y1; ++y)
            for (int x = cells.x0; x < cells.x1; ++x) {
                const bool chosen = selection == nullptr || selection->at(x, y) != 0;
                if (chosen && holds_paint(film, tile, grid::Shape::cell_in_tile(x, y)))
                    found = grid::bounding_box(found, {x, y, x + 1, y + 1});
            }
    }
    return found;
}

TransformFrame frame_around(const grid::Rect& cells, double cell_mm) {
    const int odd = (cells.width() + cells.height()) % 2;
    return {.corner_mm = cell_mm * glm::dvec2(cells.x0, cells.y0),
            .size_mm = cell_mm * glm::dvec2(cells.width() + odd, cells.height())};
}

glm::dvec2 placed(const TransformFrame& frame, const glm::dvec2& place_mm) {
    return middle_mm(frame) + turned(frame.scale * (place_mm - frame.centre_mm()), frame.turn_deg);
}

glm::dvec2 handle_mm(const TransformFrame& frame, const glm::ivec2& side) {
    return placed(frame, frame.centre_mm() + 0.5 * glm::dvec2(side) * frame.size_mm);
}

FrameHold hold_at(const TransformFrame& frame, const glm::dvec2& place_mm, double reach_mm) {
    // In a frame that is small on the screen its middle still moves it.
    double nearest_mm = std::min(reach_mm, glm::distance(middle_mm(frame), place_mm));
    FrameHold hold;
    for (const glm::ivec2& side : kFrameHandles) {
        const double away_mm = glm::distance(handle_mm(frame, side), place_mm);
        if (away_mm > nearest_mm) continue;
        nearest_mm = away_mm;
        hold = {FrameHold::Kind::Scale, side};
    }
    if (hold.kind == FrameHold::Kind::Scale) return hold;
    const glm::dvec2 half = 0.5 * glm::abs(frame.scale) * frame.size_mm;
    const glm::dvec2 seen = glm::abs(seen_from(frame, place_mm));
    const bool inside = seen.x <= half.x && seen.y <= half.y;
    return {inside ? FrameHold::Kind::Move : FrameHold::Kind::Turn, {}};
}

TransformFrame dragged(const TransformFrame& frame, const FrameHold& hold, const glm::dvec2& from_mm,
                       const glm::dvec2& to_mm, bool constrained, double cell_mm) {
    switch (hold.kind) {
        case FrameHold::Kind::Move:
            return moved(frame, to_mm - from_mm, constrained, cell_mm);
        case FrameHold::Kind::Scale:
            return scaled(frame, hold.side, to_mm - from_mm, constrained);
        case FrameHold::Kind::Turn:
            break;
    }
    return turned_by(frame, from_mm, to_mm, constrained);
}

std::optional<layers::Transform> transform_of(const TransformFrame& frame, double cell_mm) {
    const bool exact = std::remainder(frame.turn_deg, kRightAngle_deg) == 0.0 &&
                       glm::abs(frame.scale) == glm::dvec2(1.0);
    const glm::dvec2 move = exact ? in_whole_cells(frame.move_mm, cell_mm) : frame.move_mm;
    if (move == glm::dvec2(0.0) && frame.turn_deg == 0.0 && frame.scale == glm::dvec2(1.0))
        return std::nullopt;
    const glm::dvec2 centre = frame.centre_mm();
    return layers::Transform{.centre_x_mm = centre.x,
                             .centre_y_mm = centre.y,
                             .move_x_mm = move.x,
                             .move_y_mm = move.y,
                             .turn_deg = frame.turn_deg,
                             .scale_x = frame.scale.x,
                             .scale_y = frame.scale.y};
}

}  // namespace pastoso::tools
