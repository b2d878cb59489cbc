// What a mouse, a pen or a finger does over a view, told alike.
#pragma once

#include "tools/easel.hpp"

#include <optional>

#include <QPoint>
#include <QPointF>
#include <Qt>

namespace pastoso::input {

enum class Device { Mouse, Pen, Eraser, Finger };

/// Cancel: the press was not meant, what it began is cancelled.
enum class Kind { Move, Press, Release, Cancel };

struct PointerEvent {
    Kind kind = Kind::Move;
    Device device = Device::Mouse;
    int contact = 0;                          ///< which of the fingers that are down, by its number
    QPointF place;                            ///< on the view, in pixels of the layout
    QPoint desktop;                           ///< the same place on the desktop
    Qt::MouseButton button = Qt::NoButton;    ///< that is pressed or released
    Qt::MouseButtons buttons = Qt::NoButton;  ///< that are down afterwards
    Qt::KeyboardModifiers modifiers = Qt::NoModifier;
    tools::Pointer pointer;  ///< where that is on the canvas, and how the tip is held

    std::optional<double> wheel;  ///< of an airbrush that has one, from -1 to 1

    bool is_pen() const { return device == Device::Pen || device == Device::Eraser; }
};

}  // namespace pastoso::input
