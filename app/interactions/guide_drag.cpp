#include "interactions/guide_drag.hpp"

#include <algorithm>

namespace pastoso::interactions {

bool GuideDrag::press(const tools::Hand& hand, const glm::dvec2& place_mm, const glm::dvec2& canvas_mm,
                      double reach_mm) {
    const auto found = tools::handle_at(tools::guide_handles(hand, canvas_mm), place_mm, reach_mm);
    if (!found) return false;
    handle_ = found->handle;
    canvas_mm_ = canvas_mm;
    offset_mm_ = found->point_mm - place_mm;
    return true;
}

std::optional<tools::Guide> GuideDrag::move(const tools::Hand& hand, const glm::dvec2& place_mm,
                                            bool square) const {
    if (!handle_) return std::nullopt;
    const auto handles = tools::guide_handles(hand, canvas_mm_);
    const bool still_there = std::any_of(handles.begin(), handles.end(),
                                         [&](const auto& there) { return there.handle == *handle_; });
    if (!still_there) return std::nullopt;
    return tools::dragged(hand, *handle_, place_mm + offset_mm_, square);
}

}  // namespace pastoso::interactions
