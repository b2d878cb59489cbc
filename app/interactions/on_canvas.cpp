#include "interactions/on_canvas.hpp"

namespace pastoso::interactions {

OnCanvas::OnCanvas(view::CanvasView* canvas, tools::Easel& easel, document::Surface surface)
    : QObject(canvas),
      navigate(*canvas, surface == document::Surface::Canvas),
      lamp(*canvas),
      pick_next(*canvas),
      frame(*canvas),
      areas(*canvas),
      wand(*canvas),
      gradient(*canvas),
      masking(*canvas, easel),
      buttons(*canvas),
      pick_by_keys(surface),
      guides(*canvas, easel),
      paint(*canvas, easel, surface),
      finger_move(*canvas, navigate) {
    for (view::Interaction* one :
         std::initializer_list<view::Interaction*>{&navigate, &lamp, &pick_next, &frame, &areas, &wand,
                                                   &gradient, &masking, &buttons, &pick_by_keys})
        canvas->add(*one);
    if (surface == document::Surface::Canvas) canvas->add(guides);
    canvas->add(paint);
    canvas->add(finger_move);
}

}  // namespace pastoso::interactions
