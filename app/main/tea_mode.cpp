#include "main/tea_mode.hpp"

#include "main/picture_layers.hpp"
#include "main/queued_refresh.hpp"
#include "tea/glass_chooser.hpp"
#include "tea/liquid_picture_dialog.hpp"
#include "tea/tea_page.hpp"

#include <utility>

#include <QAction>
#include <QMainWindow>

namespace pastoso::main {

using commands::Command;

TeaMode::TeaMode(Studio& studio, PictureLayers& pictures, CanvasPlace& place)
    : studio_(studio), pictures_(pictures), place_(place), export_(studio) {
    connect_commands();
}

TeaMode::~TeaMode() {
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
    place_.add(page_);
    page_->panel().chooser().show_choice(tea::GlassChooser::tea_key());
    connect(&page_->panel().chooser(), &tea::GlassChooser::chosen, this, [this](const QString& key) {
        if (key == tea::GlassChooser::tea_key()) return;
        page_->panel().chooser().show_choice(tea::GlassChooser::tea_key());
        Q_EMIT other_wanted(key);
    });
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
    if (page_ == nullptr) make_page();
    place_.take(page_, commands::Mode::Tea, [this] { put_away(); });
    active_ = true;
    studio_.commands().action(Command::MilkTea)->setChecked(true);
    studio_.commands().action(Command::TeaPause)->setChecked(paused_);
    if (session_ == nullptr) {
        session_ = std::make_unique<session::TeaSession>(
            page_->panel().settings(), paused_, queued_refresh(this, [this] { show_published(); }));
        force_ = session_->status().force;
        use_force(force_);
    } else {
        session_->set_paused(paused_);
    }
    page_->view().setFocus();
}

void TeaMode::leave() {
    if (active_) place_.give_back();
}

/// The hand finds the pause as it left it; only time stands still while nobody looks.
void TeaMode::put_away() {
    active_ = false;
    session_->pour(std::nullopt);
    paused_ = studio_.commands().action(Command::TeaPause)->isChecked();
    session_->set_paused(true);
    if (picture_ != nullptr) picture_->hide();
    studio_.commands().action(Command::MilkTea)->setChecked(false);
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
    if (!active_) return;
    // Scrubbing pauses.
    studio_.commands().action(Command::TeaPause)->setChecked(status.paused);
    studio_.commands().action(Command::TeaFullSpeed)->setChecked(status.full_speed);
}

tea::LiquidPictureDialog& TeaMode::picture() {
    if (picture_ != nullptr) return *picture_;
    picture_ = new tea::LiquidPictureDialog(
        {.name = QStringLiteral("tea_picture"),
         .title = tr("Picture of the glass"),
         .hint = tr("The glass as it is seen in the window, traced along the light's ways through "
                    "glass, tea and milk. Choose a size and press Render."),
         .file = QStringLiteral("milk_tea.png")},
        [this] {
            session::LiquidPictureOrder order;
            if (const auto moment = session_->moment())
                order.scene = [moment,
                               camera = page_->view().camera().traced()](core::ThreadPool& pool) {
                    return session::traced_tea(*moment, camera, pool);
                };
            return order;
        },
        &studio_.window());
    connect(picture_, &tea::LiquidPictureDialog::rendering_begins, this,
            [this] { session_->set_paused(true); });
    connect(picture_, &tea::LiquidPictureDialog::wanted_on_canvas, this,
            [this](const layers::Picture& picture) {
                leave();
                pictures_.paint_picture(picture, tr("Milk tea"));
            });
    return *picture_;
}

}  // namespace pastoso::main
