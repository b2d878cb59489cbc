// How the docks of a window stand, read as a value and brought about by one.
#pragma once

#include "tools/panel_arrangement.hpp"

class QMainWindow;

namespace pastoso::main {

/// Of the docks that are open. Docks are told by the names of their objects.
tools::PanelArrangement read_docks(const QMainWindow& window);

/// Docks stand as `wanted` says, all others are closed. A closed one comes back where it stands at
/// `home`: behind those that it stands with there, or by itself. Names of docks that the window has not
/// are left out.
void arrange_docks(QMainWindow& window, const tools::PanelArrangement& wanted,
                   const tools::PanelArrangement& home);

}  // namespace pastoso::main
