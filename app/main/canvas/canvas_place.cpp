#include "main/canvas/canvas_place.hpp"

#include "panels/parts/status_readings.hpp"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QMainWindow>
#include <QToolBar>

namespace pastoso::main {

using commands::Command;

CanvasPlace::CanvasPlace(Studio& studio, panels::StatusReadings* readings)
    : studio_(studio), readings_(readings) {
    // Another painting comes to be seen.
    connect(&studio_, &Studio::session_begun, this, &CanvasPlace::give_back);
}

void CanvasPlace::add(QWidget* page) {
    page->hide();
    auto* row = qobject_cast<QHBoxLayout*>(studio_.canvas().parentWidget()->layout());
    row->addWidget(page, 1);
    pages_.emplace_back(page);
}

void CanvasPlace::take(QWidget* page, commands::Mode mode, const QString& name,
                       std::function<void()> put_away) {
    if (page_ == page) return;
    if (page_ == nullptr) {
        Q_EMIT taking();
        put_panels_away();
        studio_.session().set_paused(true);
    } else {
        put_away_();
        page_->hide();
    }
    page_ = page;
    put_away_ = std::move(put_away);
    page_->show();
    studio_.commands().set_mode(mode);
    Q_EMIT taken_by(name);
}

void CanvasPlace::give_back() {
    if (page_ == nullptr) return;
    QWidget* page = std::exchange(page_, nullptr);
    put_away_();
    page->hide();
    studio_.commands().set_mode(commands::Mode::Painting);
    bring_panels_back();
    studio_.session().set_paused(studio_.commands().action(Command::Pause)->isChecked());
    studio_.canvas().setFocus();
    Q_EMIT taken_by({});
}

/// The menus and the status line stay.
void CanvasPlace::put_panels_away() {
    QMainWindow& window = studio_.window();
    panels_ = window.saveState();
    std::vector<QWidget*> around{readings_};
    for (QWidget* beside :
         studio_.canvas().parentWidget()->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
        if (std::ranges::none_of(pages_, [&](const auto& page) { return page == beside; }))
            around.push_back(beside);
    for (QToolBar* bar : window.findChildren<QToolBar*>(QString(), Qt::FindDirectChildrenOnly))
        around.push_back(bar);
    for (QDockWidget* dock : window.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly))
        around.push_back(dock);
    for (QWidget* widget : around) {
        if (widget->isHidden()) continue;
        hidden_.emplace_back(widget);
        widget->hide();
    }
}

void CanvasPlace::bring_panels_back() {
    for (const QPointer<QWidget>& widget : std::exchange(hidden_, {}))
        if (widget != nullptr) widget->show();
    studio_.window().restoreState(panels_);
}

}  // namespace pastoso::main
