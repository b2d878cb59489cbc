// Pen recordings as plain text: a line for every moment, "seconds x y pressure".
#pragma once

#include "document/events.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pastoso::recordings {

/// The strokes of a text recording, in the units of the file: runs of moments with a pressure above 0.
/// Tilt and rotation are 0.
struct PenTrace {
    std::vector<std::vector<brush::PenSample>> strokes;
};

/// Reads lines of four numbers, seconds x y pressure, separated by blanks; empty lines and what follows
/// a '#' are skipped. Pressure 0 is a pen in the air. Throws InputError with the line and the value for
/// anything that is not a finite number, a pressure outside 0 to 1, a time that runs backwards, too few
/// or too many columns, and for a file without a stroke. `name` stands for the file in errors.
PenTrace parse_pen_trace(std::string_view text, const std::string& name);

/// parse_pen_trace() of a file.
PenTrace read_pen_trace(const std::filesystem::path& path);

/// The largest similar picture that leaves `margin_mm` free on all sides, centred.
/// The margin is at most 0.45 of the shorter side.
PenTrace fitted(const PenTrace& trace, double width_mm, double height_mm, double margin_mm);

/// Whether any moment of any stroke lies on a canvas of this size.
bool touches_canvas(const PenTrace& trace, double width_mm, double height_mm);

/// What a text recording does not say.
struct TraceSetup {
    document::CanvasSettings canvas;
    std::string medium;
    document::TiltCanvas tilt;
    document::TakeBrush brush;
    std::vector<document::PaintRecipe> paints;  ///< taken in turn, one a stroke; at least one
    double seconds_after = 2.0;                 ///< how long the paint runs after the last moment
};

/// The recording in which every stroke is painted with the brush cleaned and loaded afresh.
/// `trace` is in millimetres.
document::Recording recording_from_trace(const PenTrace& trace, const TraceSetup& setup);

}  // namespace pastoso::recordings
