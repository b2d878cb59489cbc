// What the still life shows, where it stands and where its shadows fall, in millimetres on the canvas.
#pragma once

#include "forms.hpp"

namespace pastoso::examples {

inline constexpr double kStillLifeWidth_mm = 160.0;
inline constexpr double kStillLifeHeight_mm = 120.0;

extern const Turned kGreenPear, kRipePear, kLemon, kApple, kBowl;

/// The bowl's opening, an ellipse.
inline constexpr Point kRim{99, 66};
inline constexpr double kRimHalfWidth_mm = 39.5;
inline constexpr double kRimHalfHeight_mm = 7.5;

/// Wall and cloth go on a little behind the outlines, so that no ground shows between them.
inline constexpr double kTuckedUnder_mm = 0.8;

/// Depths are distances to an outline, negative outside.
double opening_depth_mm(Point at);
double bowl_depth_mm(Point at);         ///< the outside of the bowl, below the front edge of its opening
double cast_shadow_depth_mm(Point at);  ///< the shadows that the things cast on the cloth
double free_of_things_mm(Point at);     ///< wall and cloth, where nothing stands before them
double canvas_depth_mm(Point at);       ///< strokes may run out over the edges of the canvas

double table_edge_y(double x);

}  // namespace pastoso::examples
