#include "main/liquids/tea_mode.hpp"

#include "glass/glass_chooser.hpp"
#include "main/queued_refresh.hpp"

namespace pastoso::main {

using commands::Command;

TeaMode::TeaMode(Studio& studio, PictureLayers& pictures, CanvasPlace& place)
    : GlassMode(studio, pictures, place, {commands::Mode::Tea, Command::MilkTea, Command::TeaRender},
                words()) {
    connect_commands();
}

GlassWords TeaMode::words() {
    return {
        .name = tr("Milk tea"),
        .picture = {.name = QStringLiteral("tea_picture"),
                    .title = tr("Picture of the glass"),
                    .hint = tr("The glass as it is seen in the window, traced along the light's ways "
                               "through glass, tea and milk. Choose a size and press Render."),
                    .file = QStringLiteral("milk_tea.png")},
        .export_title = tr("Export the milk's surface"),
        .export_file = QStringLiteral("milk_0001.pbrt"),
        .exported = tr("The milk's surface is in %1."),
    };
}

void TeaMode::make_ready() {
    if (page_ != nullptr) return;
    make_page();
    session_ = std::make_unique<session::TeaSession>(page_->panel().settings(), false,
                                                     queued_refresh(this, [this] { show_published(); }));
    use_force(session_->status().force);
}

void TeaMode::make_page() {
    page_ = new glass::TeaPage({.glass = page_actions(),
                                .pour = action(Command::TeaPour),
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
                                .export_mesh = action(Command::LiquidExportMesh)});
    add_page({Command::TeaAxisLeft, Command::TeaAxisRight, Command::TeaAxisAway, Command::TeaAxisNear});
    page_->panel().chooser().show_choice(glass::GlassChooser::tea_key());
    connect(&page_->panel().chooser(), &glass::GlassChooser::chosen, this, [this](const QString& key) {
        if (key == glass::GlassChooser::tea_key()) return;
        page_->panel().chooser().show_choice(glass::GlassChooser::tea_key());
        Q_EMIT other_wanted(key);
    });
    connect(&page_->view(), &glass::TeaView::poured, this, [this](const glm::vec2& at_m) {
        go_on();
        session_->pour(at_m);
    });
    connect(&page_->view(), &glass::TeaView::pouring_ended, this,
            [this] { session_->pour(std::nullopt); });
    connect(&page_->panel(), &glass::TeaPanel::recipe_chosen, this, &TeaMode::try_to_open);
    connect(&page_->panel(), &glass::TeaPanel::force_changed, this, &TeaMode::use_force);
    connect(&page_->panel(), &glass::TeaPanel::numbers_changed, this,
            [this](const liquid::TeaSettings& settings) {
                // What only the next glass can have is none of this one's.
                const auto snapshot = session_->snapshot();
                if (snapshot == nullptr) return;
                liquid::TeaSettings numbers = settings;
                numbers.cells = snapshot->settings.cells;
                numbers.parcels = snapshot->settings.parcels;
                numbers.milk_m3 = snapshot->settings.milk_m3;
                numbers.step_s = snapshot->settings.step_s;
                session_->set_numbers(numbers);
            });
}

void TeaMode::put_away() {
    session_->pour(std::nullopt);
    GlassMode::put_away();
}

void TeaMode::show_published() {
    const bool refused = tell_refusals();
    const auto [status, snapshot] = session_->published();
    if (refused) {
        // What was refused is not to be read as if it held.
        force_ = status.force;
        page_->panel().show_force(force_);
        if (snapshot) page_->panel().show_settings(snapshot->settings);
    }
    if (snapshot) page_->view().show_moment(snapshot);
    page_->show_status(status);
    action(Command::TeaPour)->setChecked(status.recipe_flows);
    show_running(status);
}

session::LiquidPictureOrder TeaMode::picture_order() const {
    session::LiquidPictureOrder order;
    if (const auto snapshot = session_->snapshot())
        order.scene = [snapshot, camera = page_->view().camera().traced()](core::ThreadPool& pool,
                                                                           trace::MilkBody body) {
            return session::traced_tea(*snapshot, camera, body, pool);
        };
    return order;
}

}  // namespace pastoso::main
