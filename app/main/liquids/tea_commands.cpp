// What the commands of the Milk Tea mode do.

#include "core/text_file.hpp"
#include "liquid/tea/milk_surface.hpp"
#include "liquid_files/mesh_export.hpp"
#include "liquid_files/tea_json.hpp"
#include "main/liquids/tea_mode.hpp"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QCoreApplication>
#include <QFileDialog>
#include <QMainWindow>
#include <glm/geometric.hpp>

namespace pastoso::main {
namespace {

using commands::Command;

constexpr double kAxisStep_m = 0.002;

constexpr std::pair<Command, const char*> kButtonWords[] = {
    {Command::TeaPour, QT_TR_NOOP("Pour")},
    {Command::TeaNewGlass, QT_TR_NOOP("New")},
    {Command::TeaOpenScene, QT_TR_NOOP("Open")},
    {Command::TeaSaveScene, QT_TR_NOOP("Save")},
    {Command::TeaForce, QT_TR_NOOP("Stir")},
    {Command::TeaReverse, QT_TR_NOOP("Other way round")},
    {Command::TeaRender, QT_TR_NOOP("Render a picture...")},
    {Command::LiquidExportMesh, QT_TR_NOOP("Export the surface...")},
};

}  // namespace

void TeaMode::connect_commands() {
    for (const auto& [command, words] : kButtonWords)
        action(command)->setIconText(QCoreApplication::translate("pastoso::main", words));
    on_here(Command::TeaPour, [this](bool pours) { pour_recipe(pours); });
    on_here(Command::TeaNewGlass, [this](bool) { session_->new_glass(page_->panel().settings()); });
    on_here(Command::TeaOpenScene, [this](bool) { ask_open(); });
    on_here(Command::TeaSaveScene, [this](bool) { ask_save(); });
    connect_force();
}

void TeaMode::pour_recipe(bool pours) {
    if (pours) go_on();
    session_->pour_recipe(pours);
}

void TeaMode::connect_force() {
    const commands::CommandRegistry& commands = studio().commands();
    commands.on(Command::TeaForce, [this](bool on) {
        session::TeaForce force = force_;
        force.on = on;
        use_force(force);
    });
    commands.on(Command::TeaReverse, [this](bool) {
        session::TeaForce force = force_;
        force.swirl_rad_s2 = -force.swirl_rad_s2;
        use_force(force);
    });
    commands.on(Command::TeaRecentre, [this](bool) {
        session::TeaForce force = force_;
        force.axis_m = page_->panel().settings().cup.axis_m;
        use_force(force);
    });
    commands.on(Command::TeaAxisLeft, [this](bool) { move_axis(-1.0, 0.0); });
    commands.on(Command::TeaAxisRight, [this](bool) { move_axis(1.0, 0.0); });
    commands.on(Command::TeaAxisAway, [this](bool) { move_axis(0.0, 1.0); });
    commands.on(Command::TeaAxisNear, [this](bool) { move_axis(0.0, -1.0); });
}

void TeaMode::use_force(const session::TeaForce& force) {
    force_ = force;
    session_->set_force(force);
    page_->panel().show_force(force);
    page_->view().show_force(force);
    action(Command::TeaForce)->setChecked(force.on);
}

/// As it is seen, and not out of the glass.
void TeaMode::move_axis(double right, double away) {
    const glass::GlassCamera& camera = page_->view().camera();
    const glm::dvec2 to_the_right(camera.right()), forward(-to_the_right.y, to_the_right.x);
    const liquid::Cup& cup = page_->panel().settings().cup;
    const glm::dvec2 middle(cup.axis_m);
    const auto radius_m = static_cast<double>(cup.inner_radius_m(cup.level_m));
    session::TeaForce force = force_;
    glm::dvec2 place = force.axis_m - middle + kAxisStep_m * (right * to_the_right + away * forward);
    if (glm::length(place) > radius_m) place *= radius_m / glm::length(place);
    force.axis_m = middle + place;
    use_force(force);
}

// ---- scenes

void TeaMode::open_scene(const QString& path_or_name) {
    liquid::TeaSettings settings = liquid_files::read_tea(path_or_name.toStdString());
    settings.parcels = std::min(settings.parcels, glass::kLiveParcels);
    session::TeaForce force = force_;
    force.on = settings.swirl_rad_s2 != 0.0 || settings.push_m_s2 != 0.0;
    if (force.on) {
        force.swirl_rad_s2 = settings.swirl_rad_s2;
        force.push_m_s2 = settings.push_m_s2;
    }
    force.axis_m = {settings.swirl_x_m, settings.swirl_y_m};
    use_force(force);
    page_->panel().show_settings(settings);
    session_->new_glass(settings);
    pour_recipe(true);
}

void TeaMode::save_scene(const QString& path) const {
    liquid::TeaSettings settings = page_->panel().settings();
    settings.swirl_rad_s2 = force_.on ? force_.swirl_rad_s2 : 0.0;
    settings.push_m_s2 = force_.on ? force_.push_m_s2 : 0.0;
    settings.swirl_x_m = force_.axis_m.x;
    settings.swirl_y_m = force_.axis_m.y;
    core::write_text_file(path.toStdString(), liquid_files::tea_to_json(settings));
}

void TeaMode::ask_open() {
    const QString path =
        QFileDialog::getOpenFileName(&studio().window(), tr("Open a scene of milk tea"), {},
                                     tr("Scenes of milk tea (*.json);;All files (*)"));
    if (!path.isEmpty()) try_to_open(path);
}

void TeaMode::try_to_open(const QString& path_or_name) {
    studio().attempt(tr("Open a scene of milk tea"), [&] { open_scene(path_or_name); });
}

void TeaMode::ask_save() {
    const QString path =
        QFileDialog::getSaveFileName(&studio().window(), tr("Save the scene"),
                                     QStringLiteral("milk_tea.json"), tr("Scenes of milk tea (*.json)"));
    if (!path.isEmpty()) studio().attempt(tr("Save the scene"), [&] { save_scene(path); });
}

// ---- the surface

/// With all its volume.
GlassMode::MeshWriter TeaMode::mesh_writer() const {
    const auto snapshot = session_->snapshot();
    if (snapshot == nullptr) return {};
    return [snapshot](const std::filesystem::path& file, const BackgroundExport::Stops& stops) {
        core::ThreadPool pool;
        liquid::MilkSurfaces surfaces(pool);
        const liquid::MilkSurface milk =
            surfaces.make(snapshot->seen.parcels, snapshot->cup(), snapshot->seen.dissolved.shape());
        return liquid_files::export_mesh(file, milk.mesh, {}, [&stops](double) { return !stops(); });
    };
}

}  // namespace pastoso::main
