// What other programs and painters call the commands.
#pragma once

#include "commands/command_list.hpp"

#include <QString>

namespace pastoso::commands {

/// Words by which a command is found besides its own, separated by commas: in the language of the window
/// and in English, in which hands may know them from elsewhere. Empty where there are none.
QString synonyms_of(Command command);

}  // namespace pastoso::commands
