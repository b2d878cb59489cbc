// Where on the canvas the pointer is.
#pragma once

#include "input/pointer_event.hpp"

#include <glm/vec2.hpp>

namespace pastoso::interactions {

inline glm::dvec2 place_mm(const input::PointerEvent& event) {
    return {event.pointer.x_mm, event.pointer.y_mm};
}

}  // namespace pastoso::interactions
