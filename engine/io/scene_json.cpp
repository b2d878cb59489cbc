#include "io/scene_json.hpp"

#include "core/resources.hpp"
#include "core/text_file.hpp"
#include "document/canvas.hpp"
#include "document/number_text.hpp"
#include "io/scene_json_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>

namespace pastoso::io {
namespace {

namespace fs = std::filesystem;
using document::number_text;

constexpr std::size_t kMaxFileBytes = std::size_t{16} << 20;
constexpr double kLongestRun_s = 1e6;
constexpr double kMostRows = 1e6;

template <class Value>
struct Choice {
    const char* name;
    Value value;
};

template <class Value, std::size_t kCount>
Value read_choice(const JsonPlace& place, const std::array<Choice<Value>, kCount>& choices) {
    const std::string text = place.text();
    std::string names;
    for (const Choice<Value>& choice : choices) {
        if (text == choice.name) return choice.value;
        names += (names.empty() ? "" : ", ") + std::string(choice.name);
    }
    place.fail("\"" + text + "\" is none of " + names + ".");
}

constexpr std::array kEdges = {Choice<film::Edge>{"periodic", film::Edge::Periodic},
                               Choice<film::Edge>{"wall", film::Edge::Wall},
                               Choice<film::Edge>{"open", film::Edge::Open}};
constexpr std::array kSchemes = {Choice<film::Scheme>{"auto", film::Scheme::Auto},
                                 Choice<film::Scheme>{"explicit", film::Scheme::Explicit},
                                 Choice<film::Scheme>{"large-step", film::Scheme::LargeStep}};

void read_edges(const JsonPlace& place, film::SolverOptions& solver) {
    if (place.value().is_string()) {
        solver.edge_x = solver.edge_y = read_choice(place, kEdges);
        return;
    }
    place.allow_only({"x", "y"});
    if (const auto x = place.optional_entry("x")) solver.edge_x = read_choice(*x, kEdges);
    if (const auto y = place.optional_entry("y")) solver.edge_y = read_choice(*y, kEdges);
}

void read_solver(const JsonPlace& place, film::SolverOptions& solver) {
    place.allow_only({"scheme", "step_s", "inertia", "lateral_drag", "full_curvature", "sleeping"});
    if (const auto scheme = place.optional_entry("scheme"))
        solver.scheme = read_choice(*scheme, kSchemes);
    solver.fixed_step_s = number_between_or(place, "step_s", 1e-9, 1e3, 0.0);
    solver.inertia = flag_or(place, "inertia", solver.inertia);
    solver.lateral_drag = flag_or(place, "lateral_drag", solver.lateral_drag);
    solver.full_curvature = flag_or(place, "full_curvature", solver.full_curvature);
    solver.sleeping = flag_or(place, "sleeping", solver.sleeping);
}

std::string gib_text(std::size_t bytes) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f GiB", static_cast<double>(bytes) / (1 << 30));
    return text;
}

int cells_along(const JsonPlace& side, double cell_mm) {
    const double cells = std::round(side.number() / cell_mm);
    if (!(cells >= 1.0 && cells <= document::kMaxCellsPerSide)) {
        side.fail("this makes " + number_text(cells) + " cells; 1 to " +
                  std::to_string(document::kMaxCellsPerSide) + " are possible.");
    }
    return static_cast<int>(cells);
}

void read_size(const JsonPlace& place, const SceneContext& context, film::Scene& scene) {
    scene.cell_mm = context.units.cells ? 1.0 : number_between(place.entry("cell_mm"), 1e-3, 10.0);
    const JsonPlace size = place.entry(context.units.length("size").c_str());
    if (size.size() != 2) size.fail("expected two numbers, [width, height].");
    scene.shape = {cells_along(size.element(0), scene.cell_mm),
                   cells_along(size.element(1), scene.cell_mm)};
    const std::size_t needed = document::estimated_bytes(scene.shape);
    const std::size_t available = document::available_memory_bytes();
    if (needed > available) {
        size.fail(std::to_string(scene.shape.width) + " x " + std::to_string(scene.shape.height) +
                  " cells need about " + gib_text(needed) + "; " + gib_text(available) +
                  " of memory are free.");
    }
}

film::Scene read_film_scene(const JsonPlace& place, const SceneContext& context) {
    film::Scene scene;
    scene.solver.sleeping = false;
    read_size(place, context, scene);
    scene.medium = read_scene_paint(place.entry("paint"), context);
    scene.gravity = read_forces(place, context);
    if (const auto edges = place.optional_entry("edges")) read_edges(*edges, scene.solver);
    if (const auto support = place.optional_entry("support"))
        scene.support = read_support(*support, context);
    scene.film = read_film(place.entry("film"), context);
    if (const auto solver = place.optional_entry("solver")) read_solver(*solver, scene.solver);
    scene.duration_s = number_between(place.entry("duration_s"), 0.0, kLongestRun_s);
    return scene;
}

/// A list of numbers in [0, most], sorted, each once.
std::vector<double> read_sorted(const JsonPlace& place, double most) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < place.size(); ++i)
        numbers.push_back(number_between(place.element(i), 0.0, most));
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
}

std::vector<double> sorted_or(const JsonPlace& parent, const std::string& key, double most,
                              std::vector<double> otherwise) {
    const auto entry = parent.optional_entry(key.c_str());
    return entry ? read_sorted(*entry, most) : otherwise;
}

shade::Lighting read_light(const JsonPlace& place) {
    place.allow_only({"azimuth_deg", "elevation_deg", "ambient", "wet_roughness"});
    shade::Lighting light;
    light.azimuth_deg = number_between_or(place, "azimuth_deg", -360.0, 360.0, light.azimuth_deg);
    light.elevation_deg = number_between_or(place, "elevation_deg", 5.0, 90.0, light.elevation_deg);
    light.ambient = number_between_or(place, "ambient", 0.0, 1.0, light.ambient);
    light.wet_roughness = number_between_or(place, "wet_roughness", 0.05, 1.0, light.wet_roughness);
    return light;
}

Magnification read_magnification(const JsonPlace& place, const film::Scene& scene) {
    place.allow_only({"at_s", "scale", "cells"});
    Magnification part;
    part.at_s = number_between(place.entry("at_s"), 0.0, scene.duration_s);
    part.scale = static_cast<int>(place.entry("scale").integer(2, 32));
    const JsonPlace cells = place.entry("cells");
    if (cells.size() != 4) cells.fail("expected four whole numbers, [left, top, right, bottom].");
    const auto side = [&](std::size_t i, int most) {
        return static_cast<int>(cells.element(i).integer(0, most));
    };
    part.cells = {side(0, scene.shape.width), side(1, scene.shape.height), side(2, scene.shape.width),
                  side(3, scene.shape.height)};
    if (part.cells.empty()) cells.fail("the area is empty.");
    return part;
}

/// Pictures beyond this are a mistake of the scale.
constexpr double kMaxPicturePixels = 1e8;

SceneOutput read_output(const JsonPlace& place, const SceneContext& context, const film::Scene& scene) {
    const std::string along_x = context.units.length("profiles_along_x_at_y");
    const std::string along_y = context.units.length("profiles_along_y_at_x");
    place.allow_only({"series_every_s", "pictures_at_s", "picture_scale", "heights_at_s", "light",
                      "profiles_at_s", along_x, along_y, "magnified"});
    const double end_s = scene.duration_s;
    SceneOutput output;
    output.series_every_s = number_between_or(place, "series_every_s", std::max(end_s / kMostRows, 1e-9),
                                              kLongestRun_s, end_s > 0.0 ? end_s / 100.0 : 1.0);
    output.pictures_at_s = sorted_or(place, "pictures_at_s", end_s, {end_s});
    output.heights_at_s = sorted_or(place, "heights_at_s", end_s, {end_s});
    output.profiles_at_s = sorted_or(place, "profiles_at_s", end_s, {end_s});
    output.lines_along_x_mm = sorted_or(place, along_x, scene.shape.height * scene.cell_mm, {});
    output.lines_along_y_mm = sorted_or(place, along_y, scene.shape.width * scene.cell_mm, {});
    output.picture_scale = number_between_or(place, "picture_scale", 0.0625, 32.0, output.picture_scale);
    const double pixels =
        output.picture_scale * output.picture_scale * scene.shape.width * scene.shape.height;
    if (pixels > kMaxPicturePixels)
        place.fail("pictures of " + number_text(std::round(pixels / 1e6)) +
                   " million pixels are too large; choose a \"picture_scale\" for at most 100 million.");
    if (const auto light = place.optional_entry("light")) output.lighting = read_light(*light);
    if (const auto magnified = place.optional_entry("magnified"))
        output.magnification = read_magnification(*magnified, scene);
    return output;
}

SceneRun read_run(const JsonPlace& place, const SceneContext& context) {
    const SceneUnits& units = context.units;
    place.allow_only({"format", "version", "title", "cell_units", "threads", units.length("size"),
                      units.cells ? "size_cells" : "cell_mm", "edges", "support", "paint", "tilt",
                      "gravity", "film", "duration_s", "solver", "output"});
    static const Json kNoOutput = Json::object();
    SceneRun run;
    run.scene = read_film_scene(place, context);
    const auto output = place.optional_entry("output");
    run.output =
        read_output(output ? *output : JsonPlace(kNoOutput, place.file(), "output"), context, run.scene);
    return run;
}

void check_header(const JsonPlace& root) {
    const bool has_format = root.value().is_object() && root.value().contains("format");
    const Json* format = has_format ? &root.entry("format").value() : nullptr;
    if (format == nullptr || !format->is_string() || format->get<std::string>() != "pastoso-scene")
        root.fail("this is not a scene; it would begin with \"format\": \"pastoso-scene\".");
    const std::int64_t version = root.entry("version").integer(1, INT32_MAX);
    if (version > kSceneFormatVersion) {
        root.fail("this was written for a newer Pastoso (scene format " + std::to_string(version) +
                  "; this program reads up to " + std::to_string(kSceneFormatVersion) + ").");
    }
}

/// Names of runs name folders.
std::string read_run_name(const JsonPlace& place) {
    const std::string name = place.text();
    const bool plain =
        !name.empty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), [](char letter) {
            return (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') || letter == '-';
        });
    if (!plain) place.fail("a run is named by up to 64 small letters, digits and hyphens.");
    return name;
}

/// Each run is the file without "runs", changed by the run's own entries (RFC 7386).
std::vector<SceneRun> read_runs(const JsonPlace& runs, const Json& file, const SceneContext& context) {
    if (runs.size() == 0) runs.fail("at least one run is needed.");
    std::vector<SceneRun> all;
    std::set<std::string> names;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const JsonPlace place = runs.element(i);
        const std::string name = read_run_name(place.entry("name"));
        if (!names.insert(name).second) place.fail("there is another run \"" + name + "\".");
        for (const char* key : {"format", "version", "title", "cell_units", "threads", "runs"}) {
            if (place.optional_entry(key))
                place.fail(std::string("\"") + key + "\" stands once for the whole file.");
        }
        Json merged = file, change = place.value();
        merged.erase("runs");
        change.erase("name");
        merged.merge_patch(change);
        const std::string label = runs.file() + ", run \"" + name + "\"";
        all.push_back(read_run(JsonPlace(merged, label), context));
        all.back().name = name;
    }
    return all;
}

std::string bundled_scene_names() {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(core::resource_path("scenes")))
        if (entry.path().extension() == ".json") names.insert(entry.path().stem().string());
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "" : ", ") + name;
    return text;
}

fs::path scene_path(const std::string& path_or_name) {
    std::error_code ignored;
    const fs::path path = path_or_name;
    if (path.has_extension() || path.has_parent_path() || fs::exists(path, ignored)) return path;
    const fs::path bundled = core::resource_path("scenes") / (path_or_name + ".json");
    if (!fs::exists(bundled, ignored)) {
        throw core::InputError("There is no scene \"" + path_or_name +
                               "\"; give a file ending in .json, or one of: " + bundled_scene_names() +
                               ".");
    }
    return bundled;
}

/// Runs are made by copying, which would run out of stack on a file that nests without end.
void check_nesting(std::string_view text, const std::string& name) {
    constexpr int kDeepest = 32;
    int depth = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char letter = text[i];
        if (quoted && letter == '\\')
            ++i;
        else if (letter == '"')
            quoted = !quoted;
        else if (!quoted && (letter == '[' || letter == '{'))
            ++depth;
        else if (!quoted && (letter == ']' || letter == '}'))
            --depth;
        if (depth > kDeepest)
            throw core::InputError(name + ": lists and objects stand more than " +
                                   std::to_string(kDeepest) + " deep in each other.");
    }
}

void drop_later(std::vector<double>& times, double seconds) {
    std::erase_if(times, [seconds](double time) { return time > seconds; });
}

}  // namespace

SceneFile scene_from_json(std::string_view text, const std::string& name, const fs::path& folder) {
    check_nesting(text, name);
    const Json json = parse_json(text, name);
    const JsonPlace root(json, name);
    check_header(root);
    SceneFile file;
    if (const auto title = root.optional_entry("title")) file.title = title->text();
    file.cell_units = flag_or(root, "cell_units", false);
    if (const auto threads = root.optional_entry("threads"))
        file.threads = static_cast<int>(threads->integer(0, 256));
    const SceneContext context{{file.cell_units}, folder};
    if (const auto runs = root.optional_entry("runs"))
        file.runs = read_runs(*runs, json, context);
    else
        file.runs.push_back(read_run(root, context));
    return file;
}

SceneFile read_scene(const std::string& path_or_name) {
    const fs::path path = scene_path(path_or_name);
    return scene_from_json(core::read_text_file(path, kMaxFileBytes), path.string(), path.parent_path());
}

void shorten(SceneRun& run, double seconds) {
    run.scene.duration_s = std::min(run.scene.duration_s, seconds);
    for (auto* times : {&run.output.pictures_at_s, &run.output.heights_at_s, &run.output.profiles_at_s})
        drop_later(*times, seconds);
    if (run.output.magnification && run.output.magnification->at_s > seconds)
        run.output.magnification.reset();
}

}  // namespace pastoso::io
