// The figures of a replay, for people and for measuring scripts.
#pragma once

#include "document/painting.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace pastoso::recordings {

struct ReplayStats {
    double wall_s = 0.0;   ///< from the start of the program's work to the last file written
    double brush_s = 0.0;  ///< of that: moving paint between brush and canvas
    double film_s = 0.0;   ///< letting the paint run
    double shade_s = 0.0;  ///< rendering
    double io_s = 0.0;     ///< reading the recording, writing pictures
    film::AdvanceReport film;
    std::int64_t wet_cells = 0;
    document::Account account;
    std::uint64_t state_hash = 0;
    std::uint64_t image_hash = 0;  ///< of the final picture's size and 8-bit values; 0 without a picture
    int threads = 0;
    std::string version;
};

/// One flat JSON object of numbers and texts; the hashes as 16 hexadecimal digits.
std::string stats_json(const ReplayStats& stats);

/// stats_json() written aside and renamed.
void write_stats(const std::filesystem::path& path, const ReplayStats& stats);

}  // namespace pastoso::recordings
