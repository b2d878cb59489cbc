// One run of a scene file: the film, how it is stepped, and what is written down.
#include "core/memory.hpp"
#include "document/canvas.hpp"
#include "recordings/scene_json_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace pastoso::recordings {
namespace {

constexpr double kLongestRun_s = 1e6;
constexpr double kMostRows = 1e6;

template <class Value>
struct Choice {
    const char* name;
    Value value;
};

template <class Value, std::size_t kCount>
Value read_choice(const files::JsonPlace& place, const std::array<Choice<Value>, kCount>& choices) {
    const std::string text = place.text();
    std::string names;
    for (const Choice<Value>& choice : choices) {
        if (text == choice.name) return choice.value;
        names += (names.empty() ? "" : ", ") + std::string(choice.name);
    }
    place.fail("\"%1\" is none of %2.", text, names);
}

constexpr std::array kEdges = {Choice<film::Edge>{"periodic", film::Edge::Periodic},
                               Choice<film::Edge>{"wall", film::Edge::Wall},
                               Choice<film::Edge>{"open", film::Edge::Open}};
constexpr std::array kSchemes = {Choice<film::Scheme>{"auto", film::Scheme::Auto},
                                 Choice<film::Scheme>{"explicit", film::Scheme::Explicit},
                                 Choice<film::Scheme>{"large-step", film::Scheme::LargeStep}};

void read_edges(const files::JsonPlace& place, film::SolverOptions& solver) {
    if (place.value().is_string()) {
        solver.edge_x = solver.edge_y = read_choice(place, kEdges);
        return;
    }
    place.allow_only({"x", "y"});
    if (const auto x = place.optional_entry("x")) solver.edge_x = read_choice(*x, kEdges);
    if (const auto y = place.optional_entry("y")) solver.edge_y = read_choice(*y, kEdges);
}

void read_solver(const files::JsonPlace& place, film::SolverOptions& solver) {
    place.allow_only({"scheme", "step_s", "inertia", "lateral_drag", "full_curvature", "sleeping",
                      "horizontal_tension", "tension_in_space"});
    if (const auto scheme = place.optional_entry("scheme"))
        solver.scheme = read_choice(*scheme, kSchemes);
    solver.fixed_step_s = number_between_or(place, "step_s", 1e-9, 1e3, 0.0);
    solver.inertia = flag_or(place, "inertia", solver.inertia);
    solver.lateral_drag = flag_or(place, "lateral_drag", solver.lateral_drag);
    solver.horizontal_tension =
        number_between_or(place, "horizontal_tension", 0.0, 1.0, solver.horizontal_tension);
    solver.tension_in_space = flag_or(place, "tension_in_space", solver.tension_in_space);
    solver.full_curvature = flag_or(place, "full_curvature", solver.full_curvature);
    solver.sleeping = flag_or(place, "sleeping", solver.sleeping);
}

std::string gib_text(std::size_t bytes) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f GiB", static_cast<double>(bytes) / (1 << 30));
    return text;
}

int cells_along(const files::JsonPlace& side, double cell_mm) {
    const double cells = std::round(side.number() / cell_mm);
    if (!(cells >= 1.0 && cells <= document::kMaxCellsPerSide)) {
        side.fail("this makes %1 cells; 1 to %2 are possible.", cells, document::kMaxCellsPerSide);
    }
    return static_cast<int>(cells);
}

void read_size(const files::JsonPlace& place, const SceneContext& context, film::Scene& scene) {
    scene.cell_mm = context.units.cells ? 1.0 : number_between(place.entry("cell_mm"), 1e-3, 10.0);
    const files::JsonPlace size = place.entry(context.units.length("size").c_str());
    if (size.size() != 2) size.fail("expected two numbers, [width, height].");
    scene.shape = {cells_along(size.element(0), scene.cell_mm),
                   cells_along(size.element(1), scene.cell_mm)};
    const std::size_t needed = document::estimated_bytes(scene.shape);
    const std::size_t available = core::available_memory_bytes();
    if (needed > available) {
        size.fail("%1 x %2 cells need about %3; %4 of memory are free.", scene.shape.width,
                  scene.shape.height, gib_text(needed), gib_text(available));
    }
}

film::Scene read_film_scene(const files::JsonPlace& place, const SceneContext& context) {
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
std::vector<double> read_sorted(const files::JsonPlace& place, double most) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < place.size(); ++i)
        numbers.push_back(number_between(place.element(i), 0.0, most));
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
}

std::vector<double> sorted_or(const files::JsonPlace& parent, const std::string& key, double most,
                              std::vector<double> otherwise) {
    const auto entry = parent.optional_entry(key.c_str());
    return entry ? read_sorted(*entry, most) : otherwise;
}

shade::Lighting read_light(const files::JsonPlace& place) {
    place.allow_only({"azimuth_deg", "elevation_deg", "ambient", "wet_roughness"});
    shade::Lighting light;
    light.azimuth_deg = number_between_or(place, "azimuth_deg", -360.0, 360.0, light.azimuth_deg);
    light.elevation_deg = number_between_or(place, "elevation_deg", 5.0, 90.0, light.elevation_deg);
    light.ambient = number_between_or(place, "ambient", 0.0, 1.0, light.ambient);
    light.wet_roughness = number_between_or(place, "wet_roughness", 0.05, 1.0, light.wet_roughness);
    return light;
}

Magnification read_magnification(const files::JsonPlace& place, const film::Scene& scene) {
    place.allow_only({"at_s", "scale", "cells"});
    Magnification part;
    part.at_s = number_between(place.entry("at_s"), 0.0, scene.duration_s);
    part.scale = static_cast<int>(place.entry("scale").integer(2, 32));
    const files::JsonPlace cells = place.entry("cells");
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

SceneOutput read_output(const files::JsonPlace& place, const SceneContext& context,
                        const film::Scene& scene) {
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
        place.fail(
            "pictures of %1 million pixels are too large; choose a \"picture_scale\" for at most 100 "
            "million.",
            std::round(pixels / 1e6));
    if (const auto light = place.optional_entry("light")) output.lighting = read_light(*light);
    if (const auto magnified = place.optional_entry("magnified"))
        output.magnification = read_magnification(*magnified, scene);
    return output;
}

}  // namespace

SceneRun read_run(const files::JsonPlace& place, const SceneContext& context) {
    const SceneUnits& units = context.units;
    place.allow_only({"format", "version", "title", "cell_units", "threads", units.length("size"),
                      units.cells ? "size_cells" : "cell_mm", "edges", "support", "paint", "tilt",
                      "gravity", "film", "duration_s", "solver", "output"});
    static const files::Json kNoOutput = files::Json::object();
    SceneRun run;
    run.scene = read_film_scene(place, context);
    const auto output = place.optional_entry("output");
    run.output = read_output(output ? *output : files::JsonPlace(kNoOutput, place.file(), "output"),
                             context, run.scene);
    return run;
}

}  // namespace pastoso::recordings
