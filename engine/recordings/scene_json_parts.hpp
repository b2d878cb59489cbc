// Parts of a scene file: a run with its support, film, paint and forces.
#pragma once

#include "files/json_place.hpp"
#include "film/laboratory/scene.hpp"
#include "recordings/scene_json.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace pastoso::recordings {

/// Whether a scene counts in millimetres or in cells, which its keys say: "radius_mm", "radius_cells".
struct SceneUnits {
    bool cells = false;

    std::string length(const std::string& key) const { return key + (cells ? "_cells" : "_mm"); }
    std::string acceleration(const std::string& key) const {
        return key + (cells ? "_cells_s2" : "_mm_s2");
    }
};

/// Where scene files are read: the units, and the folder that relative image paths start from.
struct SceneContext {
    SceneUnits units;
    std::filesystem::path folder;
};

double number_between(const files::JsonPlace& place, double least, double most);
double number_between_or(const files::JsonPlace& parent, const std::string& key, double least,
                         double most, double otherwise);
bool flag_or(const files::JsonPlace& parent, const char* key, bool otherwise);

std::vector<film::Relief> read_support(const files::JsonPlace& place, const SceneContext& context);
std::vector<film::Primitive> read_film(const files::JsonPlace& place, const SceneContext& context);
film::Medium read_scene_paint(const files::JsonPlace& place, const SceneContext& context);

/// From the entries "tilt" or "gravity" of a scene; without them a flat canvas under gravity, or, in
/// cell units, no force at all.
film::Gravity read_forces(const files::JsonPlace& scene, const SceneContext& context);

/// A whole scene but for its name; the entries that stand once for the file are allowed beside it.
SceneRun read_run(const files::JsonPlace& place, const SceneContext& context);

}  // namespace pastoso::recordings
