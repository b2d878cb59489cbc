// The commands as Qt's actions: one each, shared by menus, buttons and keys.
#pragma once

#include "commands/command_list.hpp"

#include <functional>
#include <map>

class QAction;
class QMenuBar;
class QObject;

namespace pastoso::commands {

class CommandRegistry {
  public:
    /// Makes an action for every command; `owner` owns them.
    explicit CommandRegistry(QObject* owner);

    QAction* action(Command command) const;

    /// Calls `handler` whenever the command is given; `checked` says the new state of a checkable one.
    void on(Command command, std::function<void(bool checked)> handler) const;

    /// Builds the menus of the table.
    void fill(QMenuBar* bar) const;

  private:
    std::map<Command, QAction*> actions_;
};

}  // namespace pastoso::commands
