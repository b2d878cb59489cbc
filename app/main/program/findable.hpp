// What the list of commands finds besides commands: tools, paints, mixes, media and controls of panels.
#pragma once

#include "commands/command_registry.hpp"
#include "dialogs/command_palette.hpp"
#include "main/panel_set.hpp"

#include <vector>

namespace pastoso::main {

/// As they stand in the panels now; taking one does what a click on it there does.
std::vector<dialogs::Offer> findable(const commands::CommandRegistry& commands, const PanelSet& panels);

}  // namespace pastoso::main
