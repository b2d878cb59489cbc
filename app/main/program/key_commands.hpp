// The keys of all commands, changed by the painter and there again at the next start; and what is found
// by typing its name.
#pragma once

#include "main/panel_set.hpp"
#include "main/program/remembered_file.hpp"
#include "main/studio.hpp"

#include <map>
#include <string>
#include <vector>

#include <QObject>

namespace pastoso::dialogs {
class CommandPalette;
}

namespace pastoso::tools {
struct KeySettings;
}

namespace pastoso::main {

class KeyCommands : public QObject {
    Q_OBJECT
  public:
    KeyCommands(Studio& studio, const PanelSet& panels);

    /// A file that cannot be read is told, and left as it is.
    void recall();

  private:
    void edit();
    void use(const commands::KeyBindings& bindings);
    void remember();
    void add_unknown(tools::KeySettings& settings) const;

    Studio& studio_;
    dialogs::CommandPalette* palette_;
    /// By the names of commands that this program does not have, as a later one may.
    std::map<std::string, std::vector<std::string>> unknown_;
    RememberedFile file_;
};

}  // namespace pastoso::main
