// The parts of the evening by a river, and the shapes that they share.
#pragma once

#include "area.hpp"

#include <vector>

namespace pastoso::examples::evening {

inline constexpr double kWidth_mm = 120, kHeight_mm = 90;
inline constexpr double kShore_y = 55;  ///< where the far bank meets the water
inline constexpr Point kSun{75, 47.5};

/// From 0 to 1, the same for every number of a kind.
double chance(int number, unsigned kind);

/// 1 in the middle, falling off over `width`.
double bell(double at, double middle, double width);

/// Strokes may run over the edges.
double on_canvas_mm(Point at);

/// Distance to the outline of the round trees on the left, negative outside.
double crowns_mm(Point at);

/// The same with the two poplars beside them.
double trees_mm(Point at);

/// The same of their image in the water.
double mirrored_trees_mm(Point at);

/// The same of all that stands on the far bank.
double far_bank_mm(Point at);

/// The same of the near bank, in the lower left corner.
double near_bank_mm(Point at);

/// How warm and light the sky is, 0 to 1; the water has the same, mirrored.
double glow(Point at);

/// Every tone half-mixed with the next.
std::vector<document::LoadPaint> half_mixed(const std::vector<const char*>& tones, double share = 0.3);

/// Steps, in the order in which they are painted.
void tone_the_ground(Painter& painter);
void draw_with_a_wash(Painter& painter);
void block_in(Painter& painter);
void paint_wet_in_wet(Painter& painter);
void set_lights_with_the_knife(Painter& painter);
void scumble(Painter& painter);
void glaze(Painter& painter);

}  // namespace pastoso::examples::evening
