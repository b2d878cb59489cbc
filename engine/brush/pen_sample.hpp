// What a pen, a mouse or a recording tells about the hand at one moment.
#pragma once

namespace pastoso::brush {

struct PenSample {
    double time_s = 0.0;        ///< since the start of the session, not decreasing within a stroke
    double x_mm = 0.0;          ///< on the canvas, right
    double y_mm = 0.0;          ///< on the canvas, down
    double pressure = 0.5;      ///< 0 to 1
    double tilt_x_deg = 0.0;    ///< lean of the pen to the right, -90 to 90, 0 upright
    double tilt_y_deg = 0.0;    ///< lean of the pen down the canvas, -90 to 90
    double rotation_deg = 0.0;  ///< about the pen's own axis, clockwise on the canvas
    double wheel = 0.0;         ///< of an airbrush, -1 to 1

    friend bool operator==(const PenSample&, const PenSample&) = default;
};

}  // namespace pastoso::brush
