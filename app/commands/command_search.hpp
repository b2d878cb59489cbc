// Commands found by a few letters of their words.
#pragma once

#include "commands/command_list.hpp"

#include <vector>

#include <QString>

namespace pastoso::commands {

/// How well what was typed fits: 0 not at all. Every word of it must begin a word of the command, of
/// what else it is called, of its menu or of its hint, or be put together of beginnings of the command's
/// own
/// ("nela" for New layer); what begins the command's own words counts most.
int fit(const QString& typed, const CommandText& text);

/// The same of a thing that has a name: every word must begin a word of the name, of what else it is
/// called or of what kind it is.
int fit_of_name(const QString& typed, const QString& name, const QString& kind,
                const QString& synonyms = {});

struct Found {
    Command command;
    int fit;
};

/// All that fit, the best first, in the order of the menus where they fit alike.
std::vector<Found> find_with_fit(const QString& typed);
std::vector<Command> find_commands(const QString& typed);

}  // namespace pastoso::commands
