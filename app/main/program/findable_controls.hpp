// What stands in a panel alone and is found like a command.
#pragma once

#include "commands/command_registry.hpp"
#include "dialogs/command_palette.hpp"
#include "main/panel_set.hpp"

#include <vector>

namespace pastoso::main {

/// Taking one shows its panel and gives the control the keyboard; a button that asks for nothing more is
/// pressed besides. What is greyed out there, or whose panel cannot be shown now, cannot be taken.
void add_controls(std::vector<dialogs::Offer>& offers, const commands::CommandRegistry& commands,
                  const PanelSet& panels);

}  // namespace pastoso::main
