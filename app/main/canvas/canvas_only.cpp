#include "main/canvas/canvas_only.hpp"

#include <utility>

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QStatusBar>
#include <QToolBar>

namespace pastoso::main {
namespace {

constexpr int kNoteMargin_px = 12;

}  // namespace

CanvasOnly::CanvasOnly(QMainWindow* window, QWidget* canvas)
    : QObject(window), window_(window), canvas_(canvas), note_(new QLabel(canvas)) {
    note_->setObjectName(QStringLiteral("canvas_note"));
    note_->setAttribute(Qt::WA_TransparentForMouseEvents);
    note_->hide();
    connect(window->statusBar(), &QStatusBar::messageChanged, this, &CanvasOnly::tell);
}

std::vector<QWidget*> CanvasOnly::around_canvas() const {
    std::vector<QWidget*> around{window_->menuBar(), window_->statusBar()};
    for (QWidget* beside :
         canvas_->parentWidget()->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
        if (beside != canvas_) around.push_back(beside);
    for (QToolBar* bar : window_->findChildren<QToolBar*>(QString(), Qt::FindDirectChildrenOnly))
        around.push_back(bar);
    for (QDockWidget* dock : window_->findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly))
        around.push_back(dock);
    return around;
}

void CanvasOnly::enter() {
    if (active_) return;
    active_ = true;
    panels_ = window_->saveState();
    // Actions whose menu is hidden would lose their keys.
    for (QAction* menu : window_->menuBar()->actions())
        window_->addActions(menu->menu()->actions());
    for (QWidget* widget : around_canvas()) {
        if (widget->isHidden()) continue;
        hidden_.emplace_back(widget);
        widget->hide();
    }
    canvas_->setFocus();
}

void CanvasOnly::leave() {
    if (!active_) return;
    active_ = false;
    note_->hide();
    for (const QPointer<QWidget>& widget : std::exchange(hidden_, {}))
        if (widget != nullptr) widget->show();
    window_->restoreState(panels_);
    canvas_->setFocus();
}

void CanvasOnly::tell(const QString& sentence) {
    note_->setVisible(active_ && !sentence.isEmpty());
    note_->setText(sentence);
    note_->adjustSize();
    note_->move(kNoteMargin_px, canvas_->height() - note_->height() - kNoteMargin_px);
}

}  // namespace pastoso::main
