// What commands are called in files: the same in every language, and for good.
#pragma once

#include "commands/command_list.hpp"

#include <optional>
#include <string_view>

namespace pastoso::commands {

std::string_view name_of(Command command);

/// None where no command has that name or ever had, as one of a later version may not.
std::optional<Command> command_named(std::string_view name);

}  // namespace pastoso::commands
