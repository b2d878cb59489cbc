#include "main/files/watched_window.hpp"

#include "help/topic.hpp"

#include <QVBoxLayout>

namespace pastoso::main {

WatchedWindow::WatchedWindow(const QString& title, const view::CanvasView& like, QWidget* parent)
    : QDialog(parent, Qt::Window),
      canvas_(new view::CanvasView),
      navigate_(*canvas_, true),
      finger_move_(*canvas_, navigate_) {
    canvas_->add(navigate_);
    canvas_->add(finger_move_);
    setWindowTitle(title);
    setAttribute(Qt::WA_DeleteOnClose);
    canvas_->set_lighting(like.lighting());
    canvas_->set_viewing(like.viewing());
    // Nothing is painted here: what the manual says of canvases is about brushes.
    help::set_topic(*canvas_, help::topic_of(this).toLatin1().constData());
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 8);
    column->setSpacing(8);
    column->addWidget(canvas_, 1);
    resize(960, 680);
    connect(canvas_, &view::CanvasView::escaped, this, &QDialog::close);
}

/// The view goes before what the pointer does over it.
WatchedWindow::~WatchedWindow() {
    delete canvas_;
}

void WatchedWindow::add_controls(QWidget* controls) {
    layout()->addWidget(controls);
}

}  // namespace pastoso::main
