#include "panels/references/reference_places.hpp"

#include "document/actions/reference_actions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pastoso::panels {
namespace {

/// Of the longer side of a picture that comes to the board.
constexpr double kNewSide_mm = 100.0;
constexpr double kGap_mm = 5.0;
constexpr double kStep_deg = 15.0;

QSizeF new_size_mm(double proportion) {
    const double width_mm = kNewSide_mm / std::max(1.0, proportion);
    return {width_mm, proportion * width_mm};
}

document::ReferencePlace upright_at(const QPointF& middle_mm, const QSizeF& size) {
    return in_range({.x_mm = middle_mm.x(), .y_mm = middle_mm.y(), .width_mm = size.width()});
}

/// Of the frame, which a mirror leaves as it is.
QTransform frame_on_board(const document::ReferencePlace& place) {
    QTransform frame;
    frame.translate(place.x_mm, place.y_mm);
    frame.rotate(place.turn_deg);
    return frame;
}

QRectF about_middle(const QSizeF& size) {
    return {-0.5 * size.width(), -0.5 * size.height(), size.width(), size.height()};
}

double dot(const QPointF& a, const QPointF& b) {
    return QPointF::dotProduct(a, b);
}

}  // namespace

double proportion_of(const pigment::Picture& picture) {
    return 1.0 * picture.height / picture.width;
}

QSizeF size_mm(const document::Reference& reference) {
    const double width_mm = reference.place.width_mm;
    return {width_mm, proportion_of(reference.picture->pixels) * width_mm};
}

QTransform on_board(const document::ReferencePlace& place) {
    QTransform picture = frame_on_board(place);
    if (place.mirrored) picture.scale(-1.0, 1.0);
    return picture;
}

std::array<QPointF, 4> corners_mm(const document::Reference& reference) {
    const QTransform frame = frame_on_board(reference.place);
    const QRectF area = about_middle(size_mm(reference));
    return {frame.map(area.topLeft()), frame.map(area.topRight()), frame.map(area.bottomRight()),
            frame.map(area.bottomLeft())};
}

QRectF extent_mm(const document::Reference& reference) {
    return frame_on_board(reference.place).mapRect(about_middle(size_mm(reference)));
}

QRectF extent_mm(const document::ReferenceBoard& board) {
    QRectF extent;
    for (const document::Reference& reference : board.references)
        extent |= extent_mm(reference);
    return extent;
}

const document::Reference* reference_at(const document::ReferenceBoard& board, const QPointF& point_mm) {
    const auto lies_there = [&](const document::Reference& reference) {
        const QPointF own = frame_on_board(reference.place).inverted().map(point_mm);
        return about_middle(size_mm(reference)).contains(own);
    };
    const auto found = std::find_if(board.references.rbegin(), board.references.rend(), lies_there);
    return found == board.references.rend() ? nullptr : &*found;
}

QPointF pixel_at(const document::Reference& reference, const QPointF& point_mm) {
    const QSizeF size = size_mm(reference);
    const QPointF own = on_board(reference.place).inverted().map(point_mm);
    return pixels_per_mm(reference) * (own + 0.5 * QPointF(size.width(), size.height()));
}

double pixels_per_mm(const document::Reference& reference) {
    return reference.picture->pixels.width / reference.place.width_mm;
}

document::ReferencePlace in_range(document::ReferencePlace place) {
    constexpr double kFar_mm = document::kMaxPenPosition_mm;
    place.x_mm = std::clamp(place.x_mm, -kFar_mm, kFar_mm);
    place.y_mm = std::clamp(place.y_mm, -kFar_mm, kFar_mm);
    place.width_mm = std::clamp(place.width_mm, document::kLeastReference_mm, kFar_mm);
    place.turn_deg = std::remainder(place.turn_deg, 360.0);
    return place;
}

document::ReferencePlace with_corner_at(const document::Reference& reference, std::size_t corner,
                                        const QPointF& point_mm) {
    const std::array<QPointF, 4> corners = corners_mm(reference);
    const QPointF opposite = corners[(corner + 2) % corners.size()];
    const QPointF diagonal = corners[corner] - opposite;
    const double wanted = dot(point_mm - opposite, diagonal) / dot(diagonal, diagonal);
    document::ReferencePlace place = reference.place;
    place.width_mm = in_range({.width_mm = wanted * place.width_mm}).width_mm;
    const QPointF middle = opposite + 0.5 * place.width_mm / reference.place.width_mm * diagonal;
    place.x_mm = middle.x();
    place.y_mm = middle.y();
    return in_range(place);
}

document::ReferencePlace facing(const document::ReferencePlace& place, const QPointF& point_mm,
                                bool in_steps) {
    const QPointF way = point_mm - QPointF(place.x_mm, place.y_mm);
    const double turn_deg = 180.0 / std::numbers::pi * std::atan2(way.x(), -way.y());
    document::ReferencePlace turned = place;
    turned.turn_deg = in_steps ? kStep_deg * std::round(turn_deg / kStep_deg) : turn_deg;
    return in_range(turned);
}

document::ReferencePlace place_about(const QPointF& middle_mm, double proportion) {
    return upright_at(middle_mm, new_size_mm(proportion));
}

document::ReferencePlace place_beside(const QRectF& taken_mm, double proportion) {
    const QSizeF size = new_size_mm(proportion);
    if (taken_mm.isNull()) return upright_at({}, size);
    const QPointF corner = taken_mm.topRight() + QPointF(kGap_mm, 0.0);
    return upright_at(corner + 0.5 * QPointF(size.width(), size.height()), size);
}

}  // namespace pastoso::panels
