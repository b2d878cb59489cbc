#include "main/tea_mode.hpp"

#include "main/picture_layers.hpp"
#include "main/queued_refresh.hpp"
#include "panels/status_readings.hpp"
#include "tea/tea_page.hpp"
#include "tea/tea_picture_dialog.hpp"

#include <utility>

#include <QAction>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QMainWindow>
#include <QToolBar>

namespace pastoso::main {

using commands::Command;

TeaMode::TeaMode(Studio& studio, PictureLayers& pictures, panels::StatusReadings* readings)
    : studio_(studio), pictures_(pictures), readings_(readings) {
    connect_commands();
    // Another painting comes to be seen.
    connect(&studio_, &Studio::session_begun, this, &TeaMode::leave);
}

TeaMode::~TeaMode() {
    stops_export_ = true;
    if (export_.joinable()) export_.join();
    delete picture_;
}

void TeaMode::make_page() {
    const auto action = [&](Command command) { return studio_.commands().action(command); };
    page_ = new tea::TeaPage({.back = action(Command::MilkTea),
                              .new_glass = action(Command::TeaNewGlass),
                              .open = action(Command::TeaOpenScene),
                              .save = action(Command::TeaSaveScene),
                              .force = action(Command::TeaForce),
                              .recentre = action(Command::TeaRecentre),
                              .reverse = action(Command::TeaReverse),
                              .left = action(Command::TeaAxisLeft),
                              .right = action(Command::TeaAxisRight),
                              .away = action(Command::TeaAxisAway),
                              .near = action(Command::TeaAxisNear),
                              .render = action(Command::TeaRender),
                              .export_mesh = action(Command::TeaExportMesh),
                              .pause = action(Command::TeaPause),
                              .full_speed = action(Command::TeaFullSpeed),
                              .front = action(Command::TeaFrontView)});
    auto* row = qobject_cast<QHBoxLayout*>(studio_.canvas().parentWidget()->layout());
    row->addWidget(page_, 1);
    // Elsewhere the arrows go from value to value.
    for (const Command arrow :
         {Command::TeaAxisLeft, Command::TeaAxisRight, Command::TeaAxisAway, Command::TeaAxisNear})
        page_->view().addAction(action(arrow));
    connect(&page_->view(), &tea::TeaView::poured, this,
            [this](const glm::vec2& at_m) { session_->pour(at_m); });
    connect(&page_->view(), &tea::TeaView::pouring_ended, this,
            [this] { session_->pour(std::nullopt); });
    connect(&page_->view(), &tea::TeaView::failed, &studio_, &Studio::report);
    connect(page_, &tea::TeaPage::step_wanted, this, [this](int step) { session_->show(step); });
    connect(&page_->panel(), &tea::TeaPanel::force_changed, this, &TeaMode::use_force);
    connect(&page_->panel(), &tea::TeaPanel::numbers_changed, this,
            [this](const liquid::TeaSettings& settings) {
                // What only the next glass can have is none of this one's.
                const auto moment = session_->moment();
                if (moment == nullptr) return;
                liquid::TeaSettings numbers = settings;
                numbers.cells = moment->settings.cells;
                numbers.parcels = moment->settings.parcels;
                numbers.milk_m3 = moment->settings.milk_m3;
                session_->set_numbers(numbers);
            });
    page_->panel().show_settings({});
}

void TeaMode::enter() {
    if (active_) return;
    Q_EMIT entering();
    active_ = true;
    if (page_ == nullptr) make_page();
    put_panels_away();
    page_->show();
    studio_.commands().set_mode(commands::Mode::Tea);
    studio_.commands().action(Command::MilkTea)->setChecked(true);
    studio_.session().set_paused(true);
    if (session_ == nullptr) {
        session_ = std::make_unique<session::TeaSession>(
            page_->panel().settings(), false, queued_refresh(this, [this] { show_published(); }));
        force_ = session_->status().force;
        use_force(force_);
    } else {
        session_->set_paused(studio_.commands().action(Command::TeaPause)->isChecked());
    }
    page_->view().setFocus();
}

void TeaMode::leave() {
    if (!active_) return;
    active_ = false;
    session_->pour(std::nullopt);
    // The hand finds the pause as it left it; only time stands still while nobody looks.
    const bool paused = studio_.commands().action(Command::TeaPause)->isChecked();
    session_->set_paused(true);
    studio_.commands().action(Command::TeaPause)->setChecked(paused);
    if (picture_ != nullptr) picture_->hide();
    page_->hide();
    studio_.commands().set_mode(commands::Mode::Painting);
    studio_.commands().action(Command::MilkTea)->setChecked(false);
    bring_panels_back();
    studio_.session().set_paused(studio_.commands().action(Command::Pause)->isChecked());
    studio_.canvas().setFocus();
}

/// The menus and the status line stay.
void TeaMode::put_panels_away() {
    QMainWindow& window = studio_.window();
    panels_ = window.saveState();
    std::vector<QWidget*> around{readings_};
    for (QWidget* beside :
         studio_.canvas().parentWidget()->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
        if (beside != page_) around.push_back(beside);
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

void TeaMode::bring_panels_back() {
    for (const QPointer<QWidget>& widget : std::exchange(hidden_, {}))
        if (widget != nullptr) widget->show();
    studio_.window().restoreState(panels_);
}

void TeaMode::show_published() {
    for (const std::string& error : session_->take_errors()) {
        studio_.report_refusal(QString::fromStdString(error));
        // What was refused is not to be read as if it held.
        force_ = session_->status().force;
        page_->panel().show_force(force_);
        if (const auto moment = session_->moment()) page_->panel().show_settings(moment->settings);
    }
    const session::TeaStatus status = session_->status();
    if (const auto moment = session_->moment()) page_->view().show_moment(moment);
    page_->show_status(status);
    // Scrubbing pauses.
    if (active_) studio_.commands().action(Command::TeaPause)->setChecked(status.paused);
    studio_.commands().action(Command::TeaFullSpeed)->setChecked(status.full_speed);
}

tea::TeaPictureDialog& TeaMode::picture() {
    if (picture_ != nullptr) return *picture_;
    picture_ = new tea::TeaPictureDialog(
        [this] {
            session::TeaPictureOrder order;
            order.moment = session_->moment();
            order.camera = page_->view().camera().traced();
            return order;
        },
        &studio_.window());
    connect(picture_, &tea::TeaPictureDialog::rendering_begins, this,
            [this] { session_->set_paused(true); });
    connect(picture_, &tea::TeaPictureDialog::wanted_on_canvas, this,
            [this](const layers::Picture& picture) {
                leave();
                pictures_.paint_picture(picture, tr("Milk tea"));
            });
    return *picture_;
}

}  // namespace pastoso::main
