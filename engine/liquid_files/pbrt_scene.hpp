// A whole scene for PBRT: the cup, the tea and the milk in it (docs/mesh-export.md).
#pragma once

#include "files/keep_going.hpp"
#include "grid/box_field.hpp"
#include "liquid/surface/triangle_mesh.hpp"
#include "liquid/vessel/cup.hpp"
#include "liquid_files/mesh_export.hpp"

#include <array>
#include <filesystem>
#include <vector>

namespace pastoso::liquid_files {

struct PbrtScene {
    const liquid::Cup& cup;
    const liquid::TriangleMesh& milk;  ///< may be empty
    const grid::BoxField* dissolved =
        nullptr;  ///< share of milk in the tea; syntax V4 alone can hold it
    PbrtSyntax syntax = PbrtSyntax::V4;
    int width = 800, height = 800, samples = 256;
    std::array<float, 3> absorption_per_m = {4.5F, 17.0F, 48.0F};  ///< of the tea: red, green, blue
    float scattering_per_m = 3000.0F;                              ///< of undiluted milk, reduced
};

/// The files of a scene: NAME.pbrt, and beside it NAME-glass.pbrt, NAME-tea.pbrt, NAME-level.pbrt and
/// NAME-milk.pbrt, which it includes.
std::vector<std::filesystem::path> pbrt_scene_files(const std::filesystem::path& path);

/// Writes them, the scene last, each aside; stopped, the scene is as it was. Throws InputError as
/// export_mesh() does, and when the name does not end in .pbrt.
files::ExportStatus export_pbrt_scene(const std::filesystem::path& path, const PbrtScene& scene,
                                      const files::KeepGoing& keep_going);

}  // namespace pastoso::liquid_files
