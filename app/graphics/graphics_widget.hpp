// A widget that OpenGL draws, in 10 bits a colour where windows have them, and that outlives its
// context: Qt takes that away when the widget comes to another window, and gives it a new one.
#pragma once

#include <QOpenGLExtraFunctions>
#include <QOpenGLWidget>

namespace pastoso::graphics {

/// Whoever derives from it overrides paintGL(), which does nothing until graphics_ready(), and calls
/// release_graphics() in the destructor.
class GraphicsWidget : public QOpenGLWidget {
    Q_OBJECT
  public:
    explicit GraphicsWidget(QWidget* parent = nullptr);
    ~GraphicsWidget() override;

  Q_SIGNALS:
    /// Nothing can be shown on this machine; one sentence.
    void failed(const QString& sentence);

  protected:
    /// Makes what is drawn with, in a new context. Throws core::InputError where it cannot be made.
    virtual void make_graphics() = 0;

    /// Gives it back, while its context is still there; what was shown is to be shown anew.
    virtual void free_graphics() = 0;

    bool graphics_ready() const { return ready_; }
    QOpenGLExtraFunctions& gl() { return gl_; }

    void release_graphics();

    /// Nothing more is drawn.
    void fail(const QString& sentence);

    void initializeGL() override;

  private:
    QOpenGLExtraFunctions gl_;
    bool ready_ = false;
};

}  // namespace pastoso::graphics
