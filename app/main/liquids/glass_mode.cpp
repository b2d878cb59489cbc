#include "main/liquids/glass_mode.hpp"

#include "appearance/shown_message.hpp"
#include "core/error.hpp"
#include "glass/glass_view.hpp"
#include "graphics/opengl_support.hpp"
#include "main/layers/picture_layers.hpp"

#include <utility>

#include <QAction>
#include <QFileDialog>
#include <QMainWindow>

namespace pastoso::main {

using commands::Command;

GlassMode::GlassMode(Studio& studio, PictureLayers& pictures, CanvasPlace& place,
                     const GlassCommands& commands, GlassWords words)
    : studio_(studio),
      pictures_(pictures),
      place_(place),
      commands_(commands),
      words_(std::move(words)),
      export_(studio) {
    connect_commands();
}

GlassMode::~GlassMode() = default;

void GlassMode::connect_commands() {
    studio_.commands().on(commands_.enter, [this](bool here) { here ? enter() : leave(); });
    on_here(commands_.render, [this](bool) {
        picture().show();
        picture().raise();
    });
    on_here(Command::LiquidExportMesh, [this](bool) { ask_export(); });
    on_here(Command::LiquidPause, [this](bool paused) { session().set_paused(paused); });
    on_here(Command::LiquidFullSpeed, [this](bool full) { session().set_full_speed(full); });
    on_here(Command::LiquidFrontView, [this](bool) { page().view().look_from_front(); });
}

void GlassMode::on_here(Command command, std::function<void(bool)> what) {
    studio_.commands().on(command, [this, what = std::move(what)](bool on) {
        if (active_) what(on);
    });
}

glass::GlassActions GlassMode::page_actions() const {
    return {.back = action(commands_.enter),
            .pause = action(Command::LiquidPause),
            .full_speed = action(Command::LiquidFullSpeed),
            .front = action(Command::LiquidFrontView)};
}

void GlassMode::add_page(std::initializer_list<Command> arrows) {
    place_.add(&page());
    for (const Command arrow : arrows) {
        action(arrow)->setShortcutContext(Qt::WidgetShortcut);
        page().view().addAction(action(arrow));
    }
    connect(&page().view(), &glass::GlassView::failed, &studio_, &Studio::report);
    connect(&page(), &glass::GlassPage::step_wanted, this, [this](int step) { session().show(step); });
}

// ---- coming and going

void GlassMode::enter() {
    if (active_) return;
    const std::string& problem = graphics::opengl_support().problem;
    if (!problem.empty()) {
        action(commands_.enter)->setChecked(false);
        studio_.report(QString::fromStdString(problem));
        return;
    }
    make_ready();
    ready_ = true;
    place_.take(&page(), commands_.mode, words_.name, [this] { put_away(); });
    active_ = true;
    action(commands_.enter)->setChecked(true);
    action(Command::LiquidPause)->setChecked(paused_);
    session().set_paused(paused_);
    page().view().setFocus();
}

void GlassMode::leave() {
    if (active_) place_.give_back();
}

/// The hand finds the pause as it left it; only time stands still while nobody looks.
void GlassMode::put_away() {
    active_ = false;
    paused_ = action(Command::LiquidPause)->isChecked();
    session().set_paused(true);
    if (picture_ != nullptr) picture_->hide();
    action(commands_.enter)->setChecked(false);
}

void GlassMode::go_on() {
    if (!action(Command::LiquidPause)->isChecked()) return;
    action(Command::LiquidPause)->setChecked(false);
    session().set_paused(false);
}

// ---- what is published

bool GlassMode::tell_refusals() {
    const std::vector<core::Message> errors = session().take_errors();
    for (const core::Message& error : errors)
        studio_.report_refusal(appearance::shown_message(error));
    return !errors.empty();
}

void GlassMode::show_running(const session::LiquidStatus& status) {
    if (!active_) return;
    action(Command::LiquidPause)->setChecked(status.paused);
    action(Command::LiquidFullSpeed)->setChecked(status.full_speed);
}

// ---- pictures and surfaces

glass::LiquidPictureDialog& GlassMode::picture() {
    if (picture_ != nullptr) return *picture_;
    picture_ = std::make_unique<glass::LiquidPictureDialog>(
        words_.picture, [this] { return picture_order(); }, &studio_.window());
    connect(picture_.get(), &glass::LiquidPictureDialog::rendering_begins, this,
            [this] { session().set_paused(true); });
    connect(picture_.get(), &glass::LiquidPictureDialog::wanted_on_canvas, this,
            [this](const pigment::Picture& picture) {
                leave();
                pictures_.paint_picture(picture, words_.name);
            });
    return *picture_;
}

void GlassMode::ask_export() {
    const QString path =
        QFileDialog::getSaveFileName(&studio_.window(), words_.export_title, words_.export_file,
                                     tr("Surfaces (*.pbrt *.obj *.ply *.stl)"));
    if (!path.isEmpty()) studio_.attempt(words_.export_title, [&] { export_mesh(path); });
}

void GlassMode::export_mesh(const QString& path) {
    const std::filesystem::path file = path.toStdString();
    if (!liquid_files::is_mesh_path(file))
        throw core::InputError("%1: the name must end in .pbrt, .obj, .ply or .stl. Choose one of them.",
                               file.string());
    const MeshWriter write = mesh_writer();
    if (!write) return;
    export_.start([write, file, told = words_.exported.arg(path)](const BackgroundExport::Stops& stops) {
        return write(file, stops) == files::ExportStatus::Stopped ? QString() : told;
    });
}

}  // namespace pastoso::main
