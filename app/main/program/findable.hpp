// What the list of commands finds besides commands: tools, paints and media.
#pragma once

#include "dialogs/command_palette.hpp"
#include "main/panel_set.hpp"

#include <vector>

namespace pastoso::main {

/// As they stand in the panels now; taking one does what a click on it there does.
std::vector<dialogs::Offer> findable(const PanelSet& panels);

}  // namespace pastoso::main
