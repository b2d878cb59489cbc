// Which keys give which command: a set, and over it the painter's own.
#pragma once

#include "commands/key_sets.hpp"

#include <map>
#include <optional>

namespace pastoso::commands {

class KeyBindings {
  public:
    using Keys = QList<QKeySequence>;

    explicit KeyBindings(KeySet set = KeySet::Pastoso, std::map<Command, Keys> own = {});

    KeySet set() const { return set_; }

    /// The painter's own stay.
    void choose(KeySet set) { set_ = set; }

    /// The painter's own, or those of the set that are no other command's own. No key is given to two
    /// that can be given at one time.
    Keys keys(Command command) const;

    /// Who has the key, among those that can be given in this mode.
    std::optional<Command> holder(const QKeySequence& key, Mode mode = Mode::Everywhere) const;

    /// Gives the command these keys and no others; a command that had one of them has it no more.
    void give(Command command, const Keys& keys);

    /// As the set has it, but for keys that are another command's own.
    void reset(Command command) { own_.erase(command); }
    void reset_all() { own_.clear(); }

    bool is_own(Command command) const { return own_.contains(command); }
    const std::map<Command, Keys>& own() const { return own_; }

    friend bool operator==(const KeyBindings&, const KeyBindings&) = default;

  private:
    KeySet set_;
    std::map<Command, Keys> own_;
};

/// A key that means something on the canvas itself and can be given to no command.
bool is_reserved(const QKeySequence& key);

}  // namespace pastoso::commands
