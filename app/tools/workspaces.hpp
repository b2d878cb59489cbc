// Ways in which the panels stand, by name: those that come with the program, and the painter's own.
#pragma once

#include "tools/panel_arrangement.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pastoso::tools {

/// Those that come with the program.
enum class Workspace { Sketch, Oil, Mixing, Export };

/// For a right-handed painter. Oil is how the panels stand at the first start.
const PanelArrangement& arrangement_of(Workspace workspace);

/// Where each panel stands when it is open, for a right-handed painter.
const PanelArrangement& panels_at_home();

/// The painter's own.
struct OwnWorkspace {
    std::string name;
    PanelArrangement panels;  ///< for a right-handed painter
    friend bool operator==(const OwnWorkspace&, const OwnWorkspace&) = default;
};

/// What is kept between two starts.
struct Workspaces {
    bool left_handed = false;                           ///< left and right have changed places
    std::optional<Workspace> shipped = Workspace::Oil;  ///< that is in use, unless an own one is
    std::string in_use;                                 ///< an own one, by its name; empty: none
    std::vector<OwnWorkspace> own;                      ///< no two of one name
    friend bool operator==(const Workspaces&, const Workspaces&) = default;
};

/// Null where there is no own one of that name.
const OwnWorkspace* find_own(const Workspaces& workspaces, const std::string& name);

/// The panels of the one in use, of none: those of Oil.
const PanelArrangement& arrangement_in_use(const Workspaces& workspaces);

/// Has this one in use.
void use(Workspace shipped, Workspaces& workspaces);
void use(const OwnWorkspace& own, Workspaces& workspaces);

/// Keeps it under that name, in place of an own one that has it, and has it in use.
void keep(const std::string& name, PanelArrangement panels, Workspaces& workspaces);

/// Of the own one in use, which there is. An own one that has the new name already goes.
void rename_in_use(const std::string& name, Workspaces& workspaces);

/// The own one in use, which there is; then none is.
void remove_in_use(Workspaces& workspaces);

/// None of one's own where there is no such file. Throws InputError that names the file and the place in
/// it for anything malformed.
Workspaces read_workspaces(const std::filesystem::path& file);

/// Written aside, its folder made where there is none. Throws InputError where that cannot be written.
void write_workspaces(const Workspaces& workspaces, const std::filesystem::path& file);

}  // namespace pastoso::tools
