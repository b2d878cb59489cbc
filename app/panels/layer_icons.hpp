// The icons of layers: drawn by lines, so that they are sharp on every screen.
#pragma once

#include <QIcon>

class QPainter;
class QRectF;
class QColor;

namespace pastoso::panels {

enum class LayerIcon {
    Eye,
    ClosedEye,
    Lock,
    OpenLock,
    New,
    Duplicate,
    MergeDown,
    Group,
    Remove,
    Folded,
    Unfolded,
};

/// Draws an icon into the middle of a place, 16 pixels of the layout wide.
void draw_icon(QPainter& painter, const QRectF& place, LayerIcon icon, const QColor& colour);

/// For buttons and menus, faint where it is disabled.
QIcon layer_icon(LayerIcon icon, double pixel_ratio);

}  // namespace pastoso::panels
