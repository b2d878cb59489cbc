// All that the pointer can do over the canvas, or over the mixing well.
#pragma once

#include "interactions/areas.hpp"
#include "interactions/buttons.hpp"
#include "interactions/colour_wand.hpp"
#include "interactions/frame.hpp"
#include "interactions/gradient_line.hpp"
#include "interactions/guides.hpp"
#include "interactions/lamp.hpp"
#include "interactions/masking_nib.hpp"
#include "interactions/navigate.hpp"
#include "interactions/paint.hpp"
#include "interactions/pick.hpp"

namespace pastoso::interactions {

/// Goes with its view, and before the easel. A press is offered to them in the order in which they stand
/// here; on the well there is no lamp, no frame, no area, no wand, no gradient, no
/// masking and no guide.
class OnCanvas : public QObject {
    Q_OBJECT
  public:
    OnCanvas(view::CanvasView* canvas, tools::Easel& easel, document::Surface surface);

    Navigate navigate;
    Lamp lamp;
    PickNext pick_next;
    Frame frame;
    Areas areas;
    ColourWand wand;
    GradientLine gradient;
    MaskingNib masking;
    Buttons buttons;
    PickByKeys pick_by_keys;
    Guides guides;
    Paint paint;
    FingerMove finger_move;
};

}  // namespace pastoso::interactions
