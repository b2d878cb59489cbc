#include "graphics/graphics_widget.hpp"

#include "appearance/shown_message.hpp"
#include "core/error.hpp"
#include "graphics/opengl_support.hpp"

#include <QOpenGLContext>

namespace pastoso::graphics {

GraphicsWidget::GraphicsWidget(QWidget* parent) : QOpenGLWidget(parent) {
    if (deep_colour()) setTextureFormat(GL_RGB10_A2);
}

GraphicsWidget::~GraphicsWidget() {
    // The context outlives this part of the object: its end must not call back into it.
    if (context() != nullptr) context()->disconnect(this);
}

void GraphicsWidget::initializeGL() {
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &GraphicsWidget::release_graphics);
    gl_.initializeOpenGLFunctions();
    try {
        make_graphics();
        ready_ = true;
    } catch (const core::InputError& error) {
        fail(appearance::shown_message(error.message()));
    }
}

void GraphicsWidget::release_graphics() {
    if (!ready_) return;
    makeCurrent();
    free_graphics();
    doneCurrent();
    ready_ = false;
}

void GraphicsWidget::fail(const QString& sentence) {
    ready_ = false;
    Q_EMIT failed(sentence);
}

}  // namespace pastoso::graphics
