#include "main/paint/light_choice.hpp"

#include "panels/canvas/easel_panel.hpp"
#include "panels/canvas/light_panel.hpp"
#include "pigment/illuminant.hpp"

#include <utility>

#include <QAction>
#include <QActionGroup>
#include <QFileDialog>
#include <QMainWindow>

namespace pastoso::main {
namespace {

using commands::Command;

constexpr std::pair<Command, const char*> kLights[] = {{Command::LightD65, "D65"},
                                                       {Command::LightD50, "D50"},
                                                       {Command::LightA, "A"},
                                                       {Command::LightLed, "LED"}};
constexpr std::pair<Command, pigment::WorkingSpace> kSpaces[] = {
    {Command::SpaceSrgb, pigment::WorkingSpace::Srgb},
    {Command::SpaceDisplayP3, pigment::WorkingSpace::DisplayP3}};

}  // namespace

void LightChoice::light_views() {
    for (view::CanvasView* view : studio_.views())
        view->set_lighting(shade::varnished(lamp_, varnish_));
}

void LightChoice::colour_views() {
    for (view::CanvasView* view : studio_.views())
        view->set_viewing(shade::varnished(viewing_, varnish_));
}

void LightChoice::use(const QString& name_or_path) {
    studio_.attempt([&] {
        viewing_ =
            pigment::viewing_under(pigment::find_illuminant(name_or_path.toStdString()), viewing_.space);
        name_ = name_or_path;
        colour_views();
    });
    panel_->show_illuminant(name_);
    show();
}

void LightChoice::ask() {
    const QString path = QFileDialog::getOpenFileName(&studio_.window(), tr("Light from a file"),
                                                      QString(), tr("Spectra (*.csv)"));
    use(path.isEmpty() ? name_ : path);
}

void LightChoice::show() {
    bool bundled = false;
    for (const auto& [command, name] : kLights) {
        const bool here = name_ == QLatin1String(name);
        studio_.commands().action(command)->setChecked(here);
        bundled = bundled || here;
    }
    studio_.commands().action(Command::LightFile)->setChecked(!bundled);
    for (const auto& [command, space] : kSpaces)
        studio_.commands().action(command)->setChecked(viewing_.space == space);
}

void LightChoice::use_space(pigment::WorkingSpace space) {
    if (viewing_.space != space) {
        viewing_ = pigment::viewing_under(pigment::find_illuminant(name_.toStdString()), space);
        colour_views();
    }
    show();
}

void LightChoice::use_lamp(const shade::Lighting& lamp) {
    lamp_ = lamp;
    light_views();
    stand_->show_light(lamp_);
    panel_->show_lamp(lamp_);
}

void LightChoice::move_lamp(double elevation_deg, double azimuth_deg) {
    shade::Lighting lamp = lamp_;
    lamp.elevation_deg = elevation_deg;
    lamp.azimuth_deg = azimuth_deg;
    use_lamp(lamp);
}

void LightChoice::use_varnish(const shade::Varnish& varnish) {
    varnish_ = varnish;
    light_views();
    colour_views();
    panel_->show_varnish(varnish_);
}

LightChoice::LightChoice(Studio& studio, panels::EaselPanel* stand, panels::LightPanel* panel)
    : studio_(studio), stand_(stand), panel_(panel) {
    connect_commands();
    connect_panels();
    show();
}

void LightChoice::connect_commands() {
    auto* lights = new QActionGroup(this);
    auto* spaces = new QActionGroup(this);
    for (const auto& [command, name] : kLights) {
        lights->addAction(studio_.commands().action(command));
        studio_.commands().on(command, [this, name = name](bool) { use(QString::fromLatin1(name)); });
    }
    lights->addAction(studio_.commands().action(Command::LightFile));
    studio_.commands().on(Command::LightFile, [this](bool) { ask(); });
    for (const auto& [command, space] : kSpaces) {
        spaces->addAction(studio_.commands().action(command));
        studio_.commands().on(command, [this, space = space](bool) { use_space(space); });
    }
    studio_.commands().on(Command::MoveLight,
                          [this](bool shown) { studio_.on_canvas().lamp.show(shown); });
    connect(&studio_.on_canvas().lamp, &interactions::Lamp::dragged, this, &LightChoice::move_lamp);
}

void LightChoice::connect_panels() {
    connect(stand_, &panels::EaselPanel::light_moved, this, &LightChoice::move_lamp);
    connect(panel_, &panels::LightPanel::illuminant_chosen, this, &LightChoice::use);
    connect(panel_, &panels::LightPanel::illuminant_file_wanted, this, &LightChoice::ask);
    connect(panel_, &panels::LightPanel::lamp_changed, this, &LightChoice::use_lamp);
    connect(panel_, &panels::LightPanel::varnish_chosen, this, &LightChoice::use_varnish);
}

}  // namespace pastoso::main
