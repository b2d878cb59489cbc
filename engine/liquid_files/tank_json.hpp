// Scenes of a glass tank as JSON (docs/tank-format.md).
#pragma once

#include "liquid_files/shape_json.hpp"
#include "tank/tank_scene.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pastoso::liquid_files {

inline constexpr int kTankFormatVersion = 1;

/// Reads .obj and .stl, named relative to a folder, each once.
MeshOfFile meshes_in(const std::filesystem::path& folder);

/// Reads a scene; what the file does not say is as usual. Throws InputError "FILE, liquids[0].milk:
/// MESSAGE" for whatever docs/tank-format.md does not allow, and for a mesh that cannot be read.
tank::TankScene tank_from_json(std::string_view text, const std::string& name,
                               const MeshOfFile& mesh_of = meshes_in("."));

/// How methods are named in scenes; in the order of tank::Method.
std::vector<std::string> tank_method_names();

/// The names of the scenes that come with the program, in alphabetical order.
std::vector<std::string> bundled_tank_names();

/// The same of a file, whose meshes are named relative to it, or of a scene that comes with the program
/// when `path_or_name` is a name without a folder and an ending. Throws InputError that lists the names
/// when there is none of that name.
tank::TankScene read_tank(const std::string& path_or_name);

/// All of the scene, meshes by their files; given the same meshes, tank_from_json() gives it back
/// exactly.
std::string tank_to_json(const tank::TankScene& scene);

}  // namespace pastoso::liquid_files
