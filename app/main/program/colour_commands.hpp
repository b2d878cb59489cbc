// In which colours of the screen the painting is shown, and what of a printer's on it.
#pragma once

#include "files/screen_colours.hpp"
#include "main/program/colord_profile.hpp"
#include "main/studio.hpp"
#include "tools/preferences.hpp"

#include <optional>

namespace pastoso::main {

class ColourCommands : public QObject {
    Q_OBJECT
  public:
    explicit ColourCommands(Studio& studio);

    /// Files that cannot be used are told, and the screen is taken for one of the working space.
    void use(const tools::Preferences& preferences);

    /// What the system's profile for the window's screen calls itself; empty where there is none.
    const QString& system_name() const { return system_name_; }

    bool eventFilter(QObject* window, QEvent* event) override;

  Q_SIGNALS:
    /// There is none yet for what the painter wants to see.
    void printer_wanted();

  private:
    void follow_screen();
    void take_system(const QString& file);
    void prove(bool files::ScreenProfiles::*proof, bool on);
    void read_profiles();
    void show();

    Studio& studio_;
    ColordProfile colord_;
    tools::Preferences preferences_;
    files::IccProfile system_;
    QString system_name_;
    core::Message system_fault_;
    files::ScreenProfiles profiles_;
    std::optional<files::ScreenProfiles> shown_;
};

}  // namespace pastoso::main
