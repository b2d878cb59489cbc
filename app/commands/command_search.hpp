// Commands found by a few letters of their words.
#pragma once

#include "commands/command_list.hpp"

#include <vector>

#include <QString>

namespace pastoso::commands {

/// How well what was typed fits: 0 not at all. Every word of it must begin a word of the command, of its
/// menu or of its hint, or be put together of such beginnings ("nela" for New layer); what begins the
/// command's own words counts most.
int fit(const QString& typed, const CommandText& text);

/// All that fit, the best first, in the order of the menus where they fit alike.
std::vector<Command> find_commands(const QString& typed);

}  // namespace pastoso::commands
