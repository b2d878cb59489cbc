#include "commands/key_bindings.hpp"

#include <utility>

namespace pastoso::commands {
namespace {

bool meet(Command a, Command b) {
    return commands::meet(text_of(a).mode, text_of(b).mode);
}

}  // namespace

KeyBindings::KeyBindings(KeySet set, std::map<Command, Keys> own) : set_(set), own_(std::move(own)) {}

KeyBindings::Keys KeyBindings::keys(Command command) const {
    if (const auto found = own_.find(command); found != own_.end()) return found->second;
    Keys keys = keys_in(set_, command);
    for (const auto& [other, taken] : own_)
        for (const QKeySequence& key : taken)
            if (meet(command, other)) keys.removeAll(key);
    return keys;
}

std::optional<Command> KeyBindings::holder(const QKeySequence& key, Mode mode) const {
    for (const CommandText& text : command_list())
        if (commands::meet(text.mode, mode) && keys(text.command).contains(key)) return text.command;
    return std::nullopt;
}

void KeyBindings::give(Command command, const Keys& keys) {
    for (auto& [other, taken] : own_)
        for (const QKeySequence& key : keys)
            if (meet(command, other)) taken.removeAll(key);
    own_[command] = keys;
    if (keys == keys_in(set_, command)) own_.erase(command);
}

bool is_reserved(const QKeySequence& key) {
    const QKeyCombination combination = key[0];
    switch (combination.key()) {
        case Qt::Key_Space:
        case Qt::Key_Escape:
            return true;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            return combination.keyboardModifiers() == Qt::NoModifier;
        default:
            return false;
    }
}

}  // namespace pastoso::commands
