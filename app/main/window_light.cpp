// In which light, and in which colours of a screen, MainWindow shows the painting.

#include "core/error.hpp"
#include "main/main_window.hpp"
#include "panels/easel_panel.hpp"
#include "pigment/illuminant.hpp"

#include <utility>

#include <QAction>
#include <QActionGroup>
#include <QFileDialog>

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

void MainWindow::show_under(const pigment::Viewing& viewing) {
    for (view::CanvasView* view : {canvas_, well_})
        view->set_viewing(viewing);
}

void MainWindow::use_light(const QString& name_or_path) {
    try {
        show_under(pigment::viewing_under(pigment::find_illuminant(name_or_path.toStdString()),
                                          canvas_->viewing().space));
        light_ = name_or_path;
    } catch (const core::InputError& error) {
        report(QString::fromUtf8(error.what()));
    }
    stand_->show_illuminant(light_);
    show_light();
}

void MainWindow::ask_light() {
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Light from a file"), QString(), tr("Spectra (*.csv)"));
    use_light(path.isEmpty() ? light_ : path);
}

void MainWindow::show_light() {
    bool bundled = false;
    for (const auto& [command, name] : kLights) {
        const bool here = light_ == QLatin1String(name);
        commands_.action(command)->setChecked(here);
        bundled = bundled || here;
    }
    commands_.action(Command::LightFile)->setChecked(!bundled);
    for (const auto& [command, space] : kSpaces)
        commands_.action(command)->setChecked(canvas_->viewing().space == space);
}

void MainWindow::use_space(pigment::WorkingSpace space) {
    pigment::Viewing viewing = canvas_->viewing();
    if (viewing.space != space) {
        viewing = pigment::viewing_under(pigment::find_illuminant(light_.toStdString()), space);
        show_under(viewing);
    }
    show_light();
}

void MainWindow::connect_light_commands() {
    auto* lights = new QActionGroup(this);
    auto* spaces = new QActionGroup(this);
    for (const auto& [command, name] : kLights) {
        lights->addAction(commands_.action(command));
        commands_.on(command, [this, name = name](bool) { use_light(QString::fromLatin1(name)); });
    }
    lights->addAction(commands_.action(Command::LightFile));
    commands_.on(Command::LightFile, [this](bool) { ask_light(); });
    for (const auto& [command, space] : kSpaces) {
        spaces->addAction(commands_.action(command));
        commands_.on(command, [this, space = space](bool) { use_space(space); });
    }
    show_light();
}

}  // namespace pastoso::main
