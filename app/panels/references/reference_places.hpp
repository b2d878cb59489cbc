// Where pictures lie on the board of references, and how a hand changes that.
#pragma once

#include "document/references.hpp"

#include <array>

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <QTransform>

namespace pastoso::panels {

/// Height over width of a picture.
double proportion_of(const pigment::Picture& picture);

/// Width and height on the board, before it is turned.
QSizeF size_mm(const document::Reference& reference);

/// From millimetres about the picture's middle, x right and y down in the picture, to the board.
QTransform on_board(const document::ReferencePlace& place);

/// On the board, from the one at the upper left before it is turned, clockwise.
std::array<QPointF, 4> corners_mm(const document::Reference& reference);

/// What a picture takes on the board, upright.
QRectF extent_mm(const document::Reference& reference);

/// The same of all together; null where there is none.
QRectF extent_mm(const document::ReferenceBoard& board);

/// The uppermost at a point; null where there is none.
const document::Reference* reference_at(const document::ReferenceBoard& board, const QPointF& point_mm);

/// A point of the board in the picture's pixels, from its upper left.
QPointF pixel_at(const document::Reference& reference, const QPointF& point_mm);

/// Pixels of the picture in a millimetre of the board.
double pixels_per_mm(const document::Reference& reference);

/// Brought into the range that actions have; the turn to -180 to 180.
document::ReferencePlace in_range(document::ReferencePlace place);

/// As large as it takes for the corner to come as near as it can to a point, while the opposite one
/// stays.
document::ReferencePlace with_corner_at(const document::Reference& reference, std::size_t corner,
                                        const QPointF& point_mm);

/// Turned such that its upper edge faces a point; in steps of 15 degrees, or freely.
document::ReferencePlace facing(const document::ReferencePlace& place, const QPointF& point_mm,
                                bool in_steps);

/// Of a new picture of that proportion: about a point, or to the right of what is taken, level with its
/// upper edge.
document::ReferencePlace place_about(const QPointF& middle_mm, double proportion);
document::ReferencePlace place_beside(const QRectF& taken_mm, double proportion);

}  // namespace pastoso::panels
