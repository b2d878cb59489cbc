// A recording painted to its end.
#pragma once

#include "document/painting.hpp"
#include "document/player.hpp"

#include <memory>

namespace pastoso::document {

inline std::unique_ptr<Painting> played(const Recording& recording, core::ThreadPool& pool) {
    auto painting = std::make_unique<Painting>(recording.canvas, pool);
    Player player(*painting, recording);
    while (!player.finished())
        player.play_tick();
    return painting;
}

}  // namespace pastoso::document
