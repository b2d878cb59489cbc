#include "scenes.hpp"
#include "still_life_parts.hpp"
#include "still_life_things.hpp"

namespace pastoso::examples {

document::Recording still_life() {
    document::CanvasSettings canvas;
    canvas.width_mm = kStillLifeWidth_mm;
    canvas.height_mm = kStillLifeHeight_mm;
    canvas.px_per_mm = 4;
    canvas.support = "linen";
    Painter painter(canvas);
    painter.use_medium("heavy-body oil");
    tone_the_ground(painter);
    paint_wall(painter);
    paint_cloth(painter);
    paint_cast_shadows(painter);
    paint_bowl_inside(painter);
    paint_pears(painter);
    paint_bowl_front(painter);
    paint_lemon_and_apple(painter);
    paint_contact_shadows(painter);
    paint_kitchen_knife(painter);
    paint_highlights(painter);
    painter.tilt_canvas(75);
    return painter.finish(3.0);
}

}  // namespace pastoso::examples
