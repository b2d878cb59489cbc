#include "interactions/buttons.hpp"

#include "tools/pen_device_of.hpp"

namespace pastoso::interactions {

using tools::PenButtonDoes;
using view::Took;

Took Buttons::press(const input::PointerEvent& event) {
    if (event.button == Qt::LeftButton) return Took::Nothing;
    const bool calls = event.button == Qt::RightButton && event.buttons == Qt::RightButton;
    const tools::PenAction of_mouse{calls ? PenButtonDoes::PopupPalette : PenButtonDoes::Nothing};
    const tools::PenAction action =
        event.is_pen() ? tools::action_of(canvas_.pen(), event.button) : of_mouse;
    switch (action.does) {
        case PenButtonDoes::PickPaint:
            Q_EMIT picked({event.pointer.x_mm, event.pointer.y_mm}, tools::Pick::Paint);
            break;
        case PenButtonDoes::PickColour:
            Q_EMIT picked({event.pointer.x_mm, event.pointer.y_mm}, tools::Pick::Seen);
            break;
        case PenButtonDoes::PopupPalette:
            Q_EMIT palette_wanted(event.desktop);
            break;
        case PenButtonDoes::Command:
            Q_EMIT command_wanted(QString::fromStdString(action.command));
            break;
        case PenButtonDoes::MoveCanvas:  // Navigate does
        case PenButtonDoes::Nothing:
            break;
    }
    return Took::Press;
}

}  // namespace pastoso::interactions
