#include "document/actions/aid_actions.hpp"

#include "document/actions/field_checks.hpp"
#include "document/painting_value.hpp"

#include <cmath>
#include <variant>

namespace pastoso::document {

void check_whole(const SetGuide& set) {
    const auto* ruler = std::get_if<brush::Ruler>(&set.guide.form);
    if (ruler == nullptr) return;
    constexpr double kFarthest_mm = 4.0 * kMaxPenPosition_mm;
    const double length_mm = std::hypot(ruler->x2_mm - ruler->x1_mm, ruler->y2_mm - ruler->y1_mm);
    check_between(core::message("distance of the ruler's points"), "mm", length_mm, kShortestGuide_mm,
                  kFarthest_mm);
}

void put_in_hand(const SetStabiliser& set, PaintingValue& painting) {
    painting.aids.stabiliser = set.stabiliser;
}

void put_in_hand(const SetGuide& set, PaintingValue& painting) {
    painting.aids.guide = set.guide;
}

void put_in_hand(const SetSymmetry& set, PaintingValue& painting) {
    painting.symmetry = set.symmetry;
}

SetStabiliser in_hand(std::type_identity<SetStabiliser>, const PaintingValue& painting) {
    return {painting.aids.stabiliser};
}

SetGuide in_hand(std::type_identity<SetGuide>, const PaintingValue& painting) {
    return {painting.aids.guide};
}

SetSymmetry in_hand(std::type_identity<SetSymmetry>, const PaintingValue& painting) {
    return {painting.symmetry};
}

}  // namespace pastoso::document
