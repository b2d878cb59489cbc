// What of a painting a change of the paint on its active layer reaches.
#pragma once

#include "document/painting.hpp"

#include <memory>

namespace pastoso::main {

struct ActivePart {
    document::LayerId layer = 0;
    document::Selection selection;
    document::Masking masking;
    std::shared_ptr<const document::BareCanvas> bare;
    friend bool operator==(const ActivePart&, const ActivePart&) = default;
};

inline ActivePart active_part(const document::Snapshot& painting) {
    const document::LayerStack& stack = *painting.layers;
    return {stack.layers[stack.active].id, painting.selection, painting.masking, painting.bare};
}

}  // namespace pastoso::main
