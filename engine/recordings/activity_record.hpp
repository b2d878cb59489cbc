// What a solver knows of a tile that is awake, as a record of words.
#pragma once

#include "film/tile_activity.hpp"

#include <array>
#include <cstdint>

namespace pastoso::recordings {

/// Little-endian words: flags (1 measured, 2 changed from outside); the time it waits (a double); the
/// window's time; its motion, largest and near the four sides; the speeds across and beside the four
/// sides; mobility, thickness and speed at most; the speed seen. Earlier programs told a count of faces
/// in its place, which reads as next to none: such paint waits for a second at most, as slow paint does.
using ActivityRecord = std::array<std::uint32_t, 17>;

ActivityRecord activity_record(const film::TileActivity& activity);
film::TileActivity activity_of(const ActivityRecord& record);

/// Whether all numbers are finite and within what paint can do: a step then has a length.
bool is_possible(const film::TileActivity& activity);

}  // namespace pastoso::recordings
