#include "main/light_choice.hpp"

#include "core/error.hpp"
#include "panels/easel_panel.hpp"
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

void LightChoice::show_under(const pigment::Viewing& viewing) {
    for (view::CanvasView* view : studio_.views())
        view->set_viewing(viewing);
}

void LightChoice::use(const QString& name_or_path) {
    try {
        show_under(pigment::viewing_under(pigment::find_illuminant(name_or_path.toStdString()),
                                          studio_.canvas().viewing().space));
        name_ = name_or_path;
    } catch (const core::InputError& error) {
        studio_.report(QString::fromUtf8(error.what()));
    }
    stand_->show_illuminant(name_);
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
        studio_.commands().action(command)->setChecked(studio_.canvas().viewing().space == space);
}

void LightChoice::use_space(pigment::WorkingSpace space) {
    pigment::Viewing viewing = studio_.canvas().viewing();
    if (viewing.space != space) {
        viewing = pigment::viewing_under(pigment::find_illuminant(name_.toStdString()), space);
        show_under(viewing);
    }
    show();
}

void LightChoice::light_from(double elevation_deg, double azimuth_deg) {
    shade::Lighting lighting = studio_.canvas().lighting();
    lighting.elevation_deg = elevation_deg;
    lighting.azimuth_deg = azimuth_deg;
    for (view::CanvasView* view : studio_.views())
        view->set_lighting(lighting);
    stand_->show_light(lighting);
}

LightChoice::LightChoice(Studio& studio, panels::EaselPanel* stand) : studio_(studio), stand_(stand) {
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
    connect(stand_, &panels::EaselPanel::illuminant_chosen, this, &LightChoice::use);
    connect(stand_, &panels::EaselPanel::illuminant_file_wanted, this, &LightChoice::ask);
    connect(stand_, &panels::EaselPanel::light_moved, this, &LightChoice::light_from);
    studio_.commands().on(Command::MoveLight,
                          [this](bool shown) { studio_.canvas().show_light_handle(shown); });
    connect(&studio_.canvas(), &view::CanvasView::light_dragged, this, &LightChoice::light_from);
    show();
}

}  // namespace pastoso::main
