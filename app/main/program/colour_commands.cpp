#include "main/program/colour_commands.hpp"

#include "appearance/screen_colours.hpp"
#include "appearance/shown_message.hpp"
#include "main/program/x11_profile.hpp"

#include <utility>

#include <QAction>
#include <QEvent>
#include <QMainWindow>
#include <QScreen>
#include <QWindow>

namespace pastoso::main {
namespace {

using commands::Command;
using files::IccProfile;
using files::ScreenProfiles;

/// What is seen of a printer.
constexpr std::pair<Command, bool ScreenProfiles::*> kProofs[] = {
    {Command::SoftProof, &ScreenProfiles::soft_proof},
    {Command::GamutWarning, &ScreenProfiles::gamut_warning}};

}  // namespace

ColourCommands::ColourCommands(Studio& studio) : studio_(studio), colord_(QDBusConnection::systemBus()) {
    for (const auto& [command, proof] : kProofs)
        studio_.commands().on(command, [this, proof = proof](bool on) { prove(proof, on); });
    studio_.commands().on(Command::ValueCheck, [this](bool on) {
        profiles_.values = on;
        show();
    });
    studio_.commands().on(Command::SquintView, [](bool on) { appearance::screen_colours().squint(on); });
    connect(&studio_.canvas(), &view::CanvasView::viewing_changed, this, &ColourCommands::show);
    connect(&colord_, &ColordProfile::found, this, &ColourCommands::take_system);
    studio_.window().installEventFilter(this);
}

/// It has a screen from now on.
bool ColourCommands::eventFilter(QObject* window, QEvent* event) {
    if (event->type() == QEvent::Show) {
        connect(studio_.window().windowHandle(), &QWindow::screenChanged, this,
                &ColourCommands::follow_screen, Qt::UniqueConnection);
        follow_screen();
    }
    return QObject::eventFilter(window, event);
}

void ColourCommands::follow_screen() {
    colord_.ask(studio_.window().screen()->name());
}

void ColourCommands::take_system(const QString& file) {
    system_.clear();
    system_fault_ = core::fault_of([&] {
        if (!file.isEmpty())
            system_ = files::read_monitor_profile(file.toStdString());
        else if (IccProfile bytes = x11_profile(); !bytes.empty())
            system_ = files::monitor_profile(std::move(bytes), "_ICC_PROFILE");
    });
    system_name_ = system_.empty() ? QString() : QString::fromStdString(files::description_of(system_));
    read_profiles();
}

void ColourCommands::use(const tools::Preferences& preferences) {
    preferences_ = preferences;
    read_profiles();
}

void ColourCommands::prove(bool ScreenProfiles::*proof, bool on) {
    if (on && preferences_.printer_file.empty()) Q_EMIT printer_wanted();
    profiles_.*proof = on;
    show();
}

/// One sentence of the first that cannot be used.
void ColourCommands::read_profiles() {
    profiles_.monitor = preferences_.monitor.empty() ? system_ : IccProfile();
    profiles_.printer.clear();
    core::Message fault = preferences_.monitor.empty() ? system_fault_ : core::Message();
    const auto read = [&](const std::string& file, auto reader, IccProfile& profile) {
        if (file.empty()) return;
        const core::Message why = core::fault_of([&] { profile = reader(file); });
        if (fault.empty()) fault = why;
    };
    if (preferences_.monitor == "file")
        read(preferences_.monitor_file, files::read_monitor_profile, profiles_.monitor);
    read(preferences_.printer_file, files::read_printer_profile, profiles_.printer);
    if (fault.empty())
        studio_.messages().solve(panels::Matter::Colours);
    else
        studio_.messages().raise({panels::Matter::Colours, appearance::shown_message(fault)});
    show();
}

void ColourCommands::show() {
    profiles_.space = studio_.canvas().viewing().space;
    for (const auto& [command, proof] : kProofs) {
        profiles_.*proof = profiles_.*proof && !profiles_.printer.empty();
        studio_.commands().action(command)->setChecked(profiles_.*proof);
    }
    if (shown_ == profiles_) return;
    shown_ = profiles_;
    ScreenProfiles coloured = profiles_;
    coloured.values = false;
    const auto cube = files::screen_cube(coloured);
    appearance::screen_colours().use(cube, profiles_.values ? files::screen_cube(profiles_) : cube);
}

}  // namespace pastoso::main
