// The passages of the still life, in the order in which they are painted.
#pragma once

#include "area.hpp"
#include "still_life_tones.hpp"

namespace pastoso::examples {

void tone_the_ground(Painter& painter);
void paint_wall(Painter& painter);
void paint_cloth(Painter& painter);
void paint_cast_shadows(Painter& painter);

void paint_bowl_inside(Painter& painter);
void paint_pears(Painter& painter);
void paint_bowl_front(Painter& painter);
void paint_lemon_and_apple(Painter& painter);

/// The darkest lines, where things touch the cloth.
void paint_contact_shadows(Painter& painter);
void paint_kitchen_knife(Painter& painter);
void paint_highlights(Painter& painter);

/// The same area with its strokes laid along its outline.
Area along_its_outline(Area area);

/// The smallest strokes, for what the larger ones left bare along the outline.
void mend_the_edge(Painter& painter, const Area& area, const Paints& paints, unsigned seed);

}  // namespace pastoso::examples
