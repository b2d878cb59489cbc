#include "tools/transform_frame.hpp"

#include "core/error.hpp"
#include "core/units.hpp"
#include "document/actions/actions.hpp"
#include "document/masking.hpp"

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

/// Signs of the corners from the centre, clockwise from the upper left one.
constexpr std::array<glm::dvec2, 4> kCorners = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

/// From its centre, where the box's corner is pulled.
glm::dvec2 corner_of_box(const TransformFrame& frame, std::size_t k) {
    return 0.5 * kCorners[k] * frame.size_mm + frame.pull_mm[k];
}

/// Where a place of the box is pulled, both from its centre. What is no area (problem_of()) stays as it
/// was.
glm::dvec2 pulled(const TransformFrame& frame, const glm::dvec2& from_centre_mm) {
    if (!frame.is_distorted()) return from_centre_mm;
    const glm::dvec2 half = 0.5 * frame.size_mm;
    layers::Corners corners;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const glm::dvec2 corner = corner_of_box(frame, k);
        corners[k] = {corner.x, corner.y};
    }
    if (!layers::bends_outwards(corners)) return from_centre_mm;
    const grid::Point place = layers::onto_corners({-half.x, -half.y}, frame.size_mm.x, frame.size_mm.y,
                                                   corners)(from_centre_mm.x, from_centre_mm.y);
    return {place.x, place.y};
}

/// A handle from the centre, before the frame is scaled and turned.
glm::dvec2 handle_of_box(const TransformFrame& frame, const glm::ivec2& side) {
    return pulled(frame, 0.5 * glm::dvec2(side) * frame.size_mm);
}

std::array<glm::dvec2, 4> corners_mm(const TransformFrame& frame) {
    std::array<glm::dvec2, 4> corners;
    for (std::size_t k = 0; k < corners.size(); ++k)
        corners[k] = middle_mm(frame) + turned(frame.scale * corner_of_box(frame, k), frame.turn_deg);
    return corners;
}

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// On one side of all its edges, which go round it one way or the other.
bool is_inside(const TransformFrame& frame, const glm::dvec2& place_mm) {
    const std::array<glm::dvec2, 4> corners = corners_mm(frame);
    int right = 0, left = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const glm::dvec2& from = corners[k];
        const double beside = cross(corners[(k + 1) % corners.size()] - from, place_mm - from);
        right += beside >= 0.0;
        left += beside <= 0.0;
    }
    return right == 4 || left == 4;
}

/// As far as it goes along the axis along which it goes farther.
glm::dvec2 along_one_axis(const glm::dvec2& way) {
    return std::abs(way.x) >= std::abs(way.y) ? glm::dvec2(way.x, 0.0) : glm::dvec2(0.0, way.y);
}

TransformFrame moved(TransformFrame frame, glm::dvec2 way_mm, bool constrained, double cell_mm) {
    if (constrained) way_mm = along_one_axis(way_mm);
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
    const glm::dvec2 spans = handle_of_box(frame, side) - handle_of_box(frame, -side);
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

TransformFrame distorted(TransformFrame frame, const glm::ivec2& side, const glm::dvec2& way_mm,
                         bool constrained) {
    glm::dvec2 way = turned(way_mm, -frame.turn_deg) / frame.scale;
    if (constrained) way = along_one_axis(way);
    for (std::size_t k = 0; k < kCorners.size(); ++k) {
        const glm::ivec2 corner(kCorners[k]);
        const bool taken = (side.x == 0 || side.x == corner.x) && (side.y == 0 || side.y == corner.y);
        if (taken) frame.pull_mm[k] += way;
    }
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
    const document::Selection moved = document::without_masked(painting.selection, painting.masking);
    grid::Rect found{};
    for (int tile = 0; tile < film.shape.tile_count(); ++tile) {
        if (is_bare(film, tile) || (moved != nullptr && grid::chooses_none(*moved, tile))) continue;
        const grid::Rect cells = film.shape.tile_cells(tile);
        for (int y = cells.y0; y < cells.y1; ++y)
            for (int x = cells.x0; x < cells.x1; ++x) {
                const bool chosen = moved == nullptr || moved->at(x, y) != 0;
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
    return middle_mm(frame) +
           turned(frame.scale * pulled(frame, place_mm - frame.centre_mm()), frame.turn_deg);
}

glm::dvec2 handle_mm(const TransformFrame& frame, const glm::ivec2& side) {
    return middle_mm(frame) + turned(frame.scale * handle_of_box(frame, side), frame.turn_deg);
}

FrameHold hold_at(const TransformFrame& frame, const glm::dvec2& place_mm, double reach_mm,
                  bool distort) {
    // In a frame that is small on the screen its middle still moves it.
    double nearest_mm = std::min(reach_mm, glm::distance(middle_mm(frame), place_mm));
    FrameHold hold;
    for (const glm::ivec2& side : kFrameHandles) {
        const double away_mm = glm::distance(handle_mm(frame, side), place_mm);
        if (away_mm > nearest_mm) continue;
        nearest_mm = away_mm;
        hold = {distort ? FrameHold::Kind::Distort : FrameHold::Kind::Scale, side};
    }
    if (hold.kind != FrameHold::Kind::Move) return hold;
    return {is_inside(frame, place_mm) ? FrameHold::Kind::Move : FrameHold::Kind::Turn, {}};
}

TransformFrame dragged(const TransformFrame& frame, const FrameHold& hold, const glm::dvec2& from_mm,
                       const glm::dvec2& to_mm, bool constrained, double cell_mm) {
    switch (hold.kind) {
        case FrameHold::Kind::Move:
            return moved(frame, to_mm - from_mm, constrained, cell_mm);
        case FrameHold::Kind::Scale:
            return scaled(frame, hold.side, to_mm - from_mm, constrained);
        case FrameHold::Kind::Distort:
            return distorted(frame, hold.side, to_mm - from_mm, constrained);
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

layers::Distortion distortion_of(const TransformFrame& frame) {
    const auto place = [](const glm::dvec2& place_mm) { return layers::Place{place_mm.x, place_mm.y}; };
    const std::array<glm::dvec2, 4> corners = corners_mm(frame);
    return {place(frame.corner_mm), frame.size_mm.x,   frame.size_mm.y,  place(corners[0]),
            place(corners[1]),      place(corners[2]), place(corners[3])};
}

core::Message problem_of(const TransformFrame& frame) {
    if (!frame.is_distorted()) return {};
    try {
        document::check_action(document::DistortLayer{1, distortion_of(frame)});
        return {};
    } catch (const core::InputError& error) {
        return error.message();
    }
}

double area_growth(const TransformFrame& frame) {
    const double scaled = std::abs(frame.scale.x * frame.scale.y);
    if (!frame.is_distorted()) return scaled;
    const std::array<glm::dvec2, 4> corners = corners_mm(frame);
    const double area = 0.5 * std::abs(cross(corners[2] - corners[0], corners[3] - corners[1]));
    return area / (frame.size_mm.x * frame.size_mm.y);
}

}  // namespace pastoso::tools
