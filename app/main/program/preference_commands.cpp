#include "main/program/preference_commands.hpp"

#include "appearance/theme.hpp"
#include "core/error.hpp"
#include "core/thread_count.hpp"
#include "main/program/machine_facts.hpp"

#include <chrono>

#include <QApplication>
#include <QMainWindow>
#include <QTimer>

namespace pastoso::main {
namespace {

using commands::Command;
using Page = dialogs::SettingsDialog::Page;

screen::DrawnBy drawn_by(const tools::Preferences& preferences) {
    if (preferences.drawn_by.empty()) return screen::DrawnBy::Fastest;
    return preferences.drawn_by == "opengl" ? screen::DrawnBy::OpenGl : screen::DrawnBy::Processor;
}

}  // namespace

void apply_preferences(const tools::Preferences& preferences) {
    core::set_default_thread_count(preferences.threads);
    const auto theme = preferences.theme == appearance::name_of(appearance::Theme::Light)
                           ? appearance::Theme::Light
                           : appearance::Theme::Dark;
    if (appearance::theme() != theme) appearance::apply_theme(*qApp, theme);
}

PreferenceCommands::PreferenceCommands(Studio& studio, UndoCommands& undo, ColourCommands& colours)
    : studio_(studio),
      undo_(undo),
      colours_(colours),
      file_(studio, preferences_file(), [](const auto& file) { tools::read_preferences(file); }),
      desktop_(desktop_bus()) {
    studio_.commands().on(Command::EditSettings, [this](bool) { ask(Page::Appearance); });
    studio_.commands().on(Command::UndoMemory, [this](bool) { ask(Page::Keeping); });
    connect(&colours_, &ColourCommands::printer_wanted, this, [this] { ask(Page::Colour); });
    autosave_ = new QTimer(&studio_.window());
    autosave_->setObjectName(QStringLiteral("autosave"));
    connect(autosave_, &QTimer::timeout, this, &PreferenceCommands::autosave_due);
    follow_desktop();
}

void PreferenceCommands::follow_desktop() {
    connect(&desktop_, &DesktopLook::contrast_told, this, [](bool high) {
        appearance::set_contrast(*qApp, high ? appearance::Contrast::High : appearance::Contrast::Usual);
    });
    if (!qt_scales_text())
        connect(&desktop_, &DesktopLook::text_scale_told, this, &appearance::scale_text);
    desktop_.ask();
}

void PreferenceCommands::recall(const KeptPreferences& kept) {
    preferences_ = kept.values;
    file_.recall([&kept](const auto&) {
        if (!kept.fault.empty()) throw core::InputError(kept.fault);
    });
    show_canvas();
    start_autosave();
}

void PreferenceCommands::show_canvas() {
    for (view::CanvasView* view : studio_.views())
        view->set_drawn_by(drawn_by(preferences_));
    colours_.use(preferences_);
}

void PreferenceCommands::ask(Page page) {
    dialogs::SettingsDialog dialog(preferences_, undo_.memory_MiB(), colours_.system_name(),
                                   machine_facts(), &studio_.window());
    connect(&dialog, &dialogs::SettingsDialog::changed, this, &PreferenceCommands::use);
    connect(&dialog, &dialogs::SettingsDialog::undo_memory_changed, &undo_, &UndoCommands::set_memory);
    dialog.show_page(page);
    dialog.exec();
}

void PreferenceCommands::use(const tools::Preferences& preferences) {
    preferences_ = preferences;
    apply_preferences(preferences_);
    show_canvas();
    start_autosave();
    remember();
}

void PreferenceCommands::start_autosave() {
    autosave_->stop();
    if (preferences_.autosave_min > 0) autosave_->start(std::chrono::minutes(preferences_.autosave_min));
}

void PreferenceCommands::remember() {
    file_.remember([this](const auto& file) { tools::write_preferences(preferences_, file); });
}

}  // namespace pastoso::main
