// Scene files: films without a brush, for experiments and proofs (docs/scene-format.md).
#pragma once

#include "film/laboratory/scene.hpp"
#include "shade/render.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pastoso::recordings {

inline constexpr int kSceneFormatVersion = 1;

/// A part of the surface shown by interpolating it, beside the plain enlargement of its picture.
struct Magnification {
    double at_s = 0.0;
    int scale = 8;  ///< pixels per cell
    grid::Rect cells;
};

/// What is written while a scene runs. Times in s, ascending, from 0 to the duration.
struct SceneOutput {
    double series_every_s = 0.1;
    std::vector<double> pictures_at_s;
    std::vector<double> heights_at_s;
    std::vector<double> profiles_at_s;
    std::vector<double> lines_along_x_mm;  ///< the y of lines along x
    std::vector<double> lines_along_y_mm;  ///< the x of lines along y
    double picture_scale = 4.0;            ///< pixels per cell
    shade::Lighting lighting;
    std::optional<Magnification> magnification;
};

struct SceneRun {
    std::string name;  ///< empty when the file holds a single run
    film::Scene scene;
    SceneOutput output;
};

struct SceneFile {
    std::string title;
    /// Lengths are counted in cells of one millimetre: what is written says cells for mm.
    bool cell_units = false;
    int threads = 0;
    std::vector<SceneRun> runs;
};

/// Reads a scene; `name` is the file's name for errors, and relative image paths start at `folder`.
/// Throws InputError "FILE, film[2].radius_mm: MESSAGE" for whatever docs/scene-format.md does not
/// allow, and when a run does not fit into memory.
SceneFile scene_from_json(std::string_view text, const std::string& name,
                          const std::filesystem::path& folder);

/// The names of the scenes that come with the program, in alphabetical order.
std::vector<std::string> bundled_scene_names();

/// Reads the file; what is neither a path with an extension nor an existing file is taken as the name of
/// a scene that comes with the program. Throws InputError that lists their names when there is none
/// such.
SceneFile read_scene(const std::string& path_or_name);

/// Leaves out what lies later than `seconds`.
void shorten(SceneRun& run, double seconds);

}  // namespace pastoso::recordings
