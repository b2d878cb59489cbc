// Where a QPainter draws over a frame that OpenGL has drawn.
#pragma once

#include <QOpenGLPaintDevice>
#include <QOpenGLWidget>

namespace pastoso::view {

/// The framebuffer that is bound, in paintGL(). Not the widget: while that is grabbed as a part of its
/// window, a painter on it draws into what is grabbed, and the frame comes over it.
class FrameDevice : public QOpenGLPaintDevice {
  public:
    explicit FrameDevice(const QOpenGLWidget& widget)
        : QOpenGLPaintDevice(widget.size() * widget.devicePixelRatioF()) {
        setDevicePixelRatio(widget.devicePixelRatioF());
    }
};

}  // namespace pastoso::view
