// The commands as Qt's actions: one each, shared by menus, buttons and keys.
#pragma once

#include "commands/command_list.hpp"
#include "commands/key_bindings.hpp"

#include <functional>
#include <map>
#include <utility>
#include <vector>

class QAction;
class QMenu;
class QMenuBar;
class QObject;

namespace pastoso::commands {

class CommandRegistry {
  public:
    /// Makes an action for every command, with the keys of the first set; `owner` owns them.
    explicit CommandRegistry(QObject* owner);
    CommandRegistry(const CommandRegistry&) = delete;
    CommandRegistry& operator=(const CommandRegistry&) = delete;

    QAction* action(Command command) const;

    /// Calls `handler` whenever the command is given; `checked` says the new state of a checkable one.
    void on(Command command, std::function<void(bool checked)> handler) const;

    /// Builds the menus of the table.
    void fill(QMenuBar* bar) const;

    /// From now on only commands of this mode can be given; menus show no others, and keys give none.
    void set_mode(Mode mode);
    Mode mode() const { return mode_; }

    /// From now on these keys give the commands.
    void use_keys(const KeyBindings& bindings);
    const KeyBindings& keys() const { return bindings_; }

    /// What was given so far, the latest first, each once.
    const std::vector<Command>& recent() const { return recent_; }

    /// What was given before this start, in the same order.
    void set_recent(std::vector<Command> recent) { recent_ = std::move(recent); }

  private:
    void note(Command command);

    std::map<Command, QAction*> actions_;
    mutable std::vector<QMenu*> menus_;
    Mode mode_ = Mode::Painting;
    KeyBindings bindings_;
    std::vector<Command> recent_;
};

}  // namespace pastoso::commands
