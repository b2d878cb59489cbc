// What the painting was told of a pen.
#pragma once

#include "document/actions/actions.hpp"
#include "session/paint_session.hpp"

#include <vector>

namespace pastoso::tests {

/// The samples of the latest stroke, once all that was posted is applied.
inline std::vector<brush::PenSample> latest_stroke(session::PaintSession& session) {
    session.wait_until_applied();
    std::vector<brush::PenSample> samples;
    for (const document::Event& event : session.recording().events) {
        if (const auto* down = std::get_if<document::PenDown>(&event.action)) samples = {down->sample};
        if (const auto* move = std::get_if<document::PenMove>(&event.action))
            samples.push_back(move->sample);
    }
    return samples;
}

}  // namespace pastoso::tests
