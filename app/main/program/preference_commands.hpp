// The program's settings: asked for in a dialog, applied at once, and kept.
#pragma once

#include "dialogs/settings_dialog.hpp"
#include "main/canvas/undo_commands.hpp"
#include "main/program/colour_commands.hpp"
#include "main/program/desktop_look.hpp"
#include "main/program/kept_preferences.hpp"
#include "main/program/remembered_file.hpp"
#include "main/studio.hpp"
#include "tools/preferences.hpp"

#include <QObject>

class QTimer;

namespace pastoso::main {

/// What of them holds for the whole program.
void apply_preferences(const tools::Preferences& preferences);

class PreferenceCommands : public QObject {
    Q_OBJECT
  public:
    PreferenceCommands(Studio& studio, UndoCommands& undo, ColourCommands& colours);

    /// Tells the painter where they could not be read, and leaves the file alone then.
    void recall(const KeptPreferences& kept);

  Q_SIGNALS:
    /// It is time that the painting is saved by itself.
    void autosave_due();

  private:
    void ask(dialogs::SettingsDialog::Page page);
    void use(const tools::Preferences& preferences);
    void remember();
    void show_canvas();
    void start_autosave();
    void follow_desktop();

    Studio& studio_;
    UndoCommands& undo_;
    ColourCommands& colours_;
    tools::Preferences preferences_;
    RememberedFile file_;
    QTimer* autosave_;  ///< the window's
    DesktopLook desktop_;
};

}  // namespace pastoso::main
