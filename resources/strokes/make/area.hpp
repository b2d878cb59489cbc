// Fills an area with brush strokes that follow a direction, from the dark tones to the light ones.
#pragma once

#include "paths.hpp"

#include <functional>
#include <string>
#include <vector>

namespace pastoso::examples {

struct Area {
    std::function<double(Point)> depth_mm;  ///< distance to the outline, negative outside
    std::function<Point(Point)> direction;  ///< of the strokes; any length but 0
    std::function<double(Point)> tone;      ///< 0 darkest to 1 lightest
};

/// How an area is filled.
struct Handling {
    std::string brush;
    double size_mm = 10.0;
    double spacing_mm = 5.0;  ///< between the middles of strokes
    double length_mm = 14.0;
    double inset_mm = 2.0;  ///< strokes end that far inside the outline
    Press press;
    double speed_mm_s = 90.0;
    double fill = 0.8;
    int strokes_per_dip = 3;
    double scatter_deg = 12.0;                 ///< how much the directions differ
    double scatter_tone = 0.08;                ///< how much the tones differ
    double least_tone = 0.0, most_tone = 1.0;  ///< what lies outside is left out
    double most_depth_mm = 1e9;                ///< strokes whose middle lies deeper are left out
    double share_painted = 1.0;                ///< of the strokes; the others are left out by chance
    double scatter_press = 0.0;                ///< how much pressures differ, as a share
    double scatter_length = 0.0;               ///< how much lengths and speeds differ, as a share
    bool shuffled = false;                     ///< otherwise from the upper edge to the lower
    unsigned seed = 1;
};

/// Along the outline of an area.
Point along_outline(const std::function<double(Point)>& depth_mm, Point at);

/// `paints` from dark to light. Every stroke takes the paint of the tone at its middle; the brush is
/// wiped when the paint changes.
void paint_area(Painter& painter, const Area& area, const std::vector<document::LoadPaint>& paints,
                const Handling& handling);

}  // namespace pastoso::examples
