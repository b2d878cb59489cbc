// The sets of keys that a painter can start from: those of programs that hands already know.
#pragma once

#include "commands/command_list.hpp"

#include <span>
#include <string_view>

#include <QKeySequence>
#include <QList>

namespace pastoso::commands {

enum class KeySet { Pastoso, Krita, Photoshop };

struct KeySetText {
    KeySet set;
    std::string_view name;  ///< in files
    const char* words;
    const char* hint;
};

std::span<const KeySetText> key_sets();

/// What the set gives the command, before the painter changes anything; none where it has no key there.
/// In one set no two commands share a key: all of them hold wherever the window has the keyboard.
QList<QKeySequence> keys_in(KeySet set, Command command);

}  // namespace pastoso::commands
