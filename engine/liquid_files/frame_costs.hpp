// What the files of a sequence of frames took to make: a part of the figures of a run.
#pragma once

#include <algorithm>
#include <cstdint>

namespace pastoso::liquid_files {

struct FrameCosts {
    double surface_s = 0.0;  ///< making the liquid's surface
    double trace_s = 0.0;    ///< following light
    double denoise_s = 0.0;
    double io_s = 0.0;               ///< reading and writing files
    std::int64_t frames = 0;         ///< written now, of any kind
    std::int64_t triangles = 0;      ///< in the last surface
    double surface_error_rel = 0.0;  ///< the largest, of the volume within the surface

    /// Adds later ones.
    FrameCosts& operator+=(const FrameCosts& later) {
        surface_s += later.surface_s;
        trace_s += later.trace_s;
        denoise_s += later.denoise_s;
        io_s += later.io_s;
        frames += later.frames;
        triangles = later.triangles;
        surface_error_rel = std::max(surface_error_rel, later.surface_error_rel);
        return *this;
    }
};

}  // namespace pastoso::liquid_files
