#include "recordings/scene_json.hpp"

#include "core/text_file.hpp"
#include "core/units.hpp"
#include "document/error_of.hpp"
#include "files/image.hpp"
#include "files/json_place.hpp"
#include "files/temporary_folder.hpp"
#include "pigment/palette.hpp"

#include <gmock/gmock.h>

namespace pastoso::recordings {
namespace {

using document::error_of;
using testing::ElementsAre;
using testing::HasSubstr;

const files::Json kSmall = files::Json::parse(R"({
  "format": "pastoso-scene", "version": 1,
  "size_mm": [20, 10], "cell_mm": 0.5,
  "paint": "house paint",
  "film": [{"kind": "cap", "at_mm": [5, 6], "radius_mm": 3, "thickness_mm": 1, "pigment": "PB29"}],
  "duration_s": 2
})");

const files::Json kCells = files::Json::parse(R"({
  "format": "pastoso-scene", "version": 1, "cell_units": true,
  "size_cells": [20, 10],
  "paint": {"viscosity_cells2_s": 2},
  "film": [{"kind": "slab", "thickness_cells": 1}],
  "duration_s": 2
})");

SceneFile read(const files::Json& json) {
    return scene_from_json(json.dump(), "a.json", ".");
}

/// The complaint about `base` changed at a JSON pointer; no value: the entry is taken out.
std::string complaint(const files::Json& base, const std::string& pointer, const files::Json& value) {
    files::Json json = base;
    json[files::Json::json_pointer(pointer)] = value;
    return error_of([&] { read(json); });
}
std::string without(const files::Json& base, const char* key) {
    files::Json json = base;
    json.erase(key);
    return error_of([&] { read(json); });
}

class SceneJson : public files::TemporaryFolder {};

TEST_F(SceneJson, DefaultsAreThoseOfTheCanvas) {
    const SceneFile file = read(kSmall);
    ASSERT_EQ(file.runs.size(), 1U);
    const film::Scene& scene = file.runs[0].scene;
    EXPECT_EQ(scene.shape, (grid::Shape{40, 20}));
    EXPECT_EQ(scene.medium.name, "house paint");
    EXPECT_EQ(scene.gravity, film::tilted_gravity(0));
    EXPECT_EQ(scene.solver.edge_x, film::Edge::Open);
    EXPECT_EQ(scene.solver.fixed_step_s, 0.0);
    EXPECT_EQ(scene.solver.horizontal_tension, 0.0);
    EXPECT_TRUE(scene.solver.tension_in_space);
    EXPECT_EQ(scene.solver.scheme, film::Scheme::Auto);
    EXPECT_FALSE(scene.solver.sleeping);
    EXPECT_TRUE(scene.support.empty());
    const auto& cap = std::get<film::SphericalCap>(scene.film.at(0).form);
    EXPECT_EQ(cap.centre.y_mm, 6.0);
    EXPECT_EQ(scene.film[0].pigment, pigment::find_pigment("PB29").coefficients);
    EXPECT_EQ(file.runs[0].output.series_every_s, 0.02);
    EXPECT_THAT(file.runs[0].output.pictures_at_s, ElementsAre(2.0));
}

TEST_F(SceneJson, EverythingIsRead) {
    files::Json json = kSmall;
    json.merge_patch(files::Json::parse(R"({
      "title": "all of it", "threads": 2,
      "edges": {"x": "periodic", "y": "wall"},
      "support": ["linen", {"kind": "ramp", "slope": 0.1, "direction_deg": 90},
                  {"kind": "bump", "at_mm": [1, 2], "height_mm": 0.5, "deviation_mm": 2},
                  {"kind": "weave", "thread_pitch_mm": 0.7, "relief_mm": 0.2}, "flat"],
      "paint": {"like": "heavy-body oil", "viscosity_m2_s": 0.1},
      "tilt": {"tilt_deg": 30, "direction_deg": 0},
      "film": [{"kind": "slab", "thickness_mm": 0.1},
               {"kind": "box", "area_mm": [1, 2, 3, 4], "thickness_mm": 0.1},
               {"kind": "disc", "at_mm": [1, 2], "radius_mm": 3, "thickness_mm": 0.1},
               {"kind": "gaussian", "at_mm": [1, 2], "deviation_mm": 3, "thickness_mm": 0.1},
               {"kind": "cosine", "wavelength_mm": 5, "phase_deg": 90, "thickness_mm": 0.1},
               {"kind": "noise", "seed": 9, "thickness_mm": 0.1,
                "pigment": [["PB29", 1], ["PW6", 3]], "strength": 0.5}],
      "solver": {"scheme": "explicit", "step_s": 0.01, "inertia": false, "lateral_drag": false,
                 "full_curvature": false, "sleeping": true, "horizontal_tension": 0.5,
                 "tension_in_space": false},
      "output": {"series_every_s": 0.5, "pictures_at_s": [2, 1, 1], "heights_at_s": [],
                 "profiles_at_s": [0], "profiles_along_x_at_y_mm": [5], "profiles_along_y_at_x_mm": [7, 6],
                 "picture_scale": 2, "light": {"azimuth_deg": 90, "elevation_deg": 30},
                 "magnified": {"at_s": 1, "scale": 8, "cells": [0, 0, 10, 5]}}
    })"));
    const SceneFile file = read(json);
    const film::Scene& scene = file.runs.at(0).scene;
    const SceneOutput& output = file.runs[0].output;
    EXPECT_EQ(file.title, "all of it");
    EXPECT_EQ(file.threads, 2);
    EXPECT_EQ(scene.solver.edge_x, film::Edge::Periodic);
    EXPECT_EQ(scene.solver.edge_y, film::Edge::Wall);
    EXPECT_EQ(scene.support.size(), 4U);
    EXPECT_EQ(scene.medium.viscosity_m2_s, 0.1);
    EXPECT_EQ(scene.medium.yield_stress_Pa, 80.0);
    EXPECT_EQ(scene.gravity, film::tilted_gravity(30, 0));
    ASSERT_EQ(scene.film.size(), 6U);
    EXPECT_EQ(std::get<film::WhiteNoise>(scene.film[5].form).seed, 9U);
    // Half strength, a quarter of the pigment being blue.
    const float blue = pigment::find_pigment("PB29").coefficients[4];
    const float white = pigment::find_pigment("PW6").coefficients[4];
    EXPECT_NEAR(scene.film[5].pigment[4], 0.5F * (0.25F * blue + 0.75F * white), 1e-4F);
    EXPECT_EQ(scene.solver.scheme, film::Scheme::Explicit);
    EXPECT_EQ(scene.solver.fixed_step_s, 0.01);
    EXPECT_FALSE(scene.solver.inertia || scene.solver.lateral_drag || scene.solver.full_curvature);
    EXPECT_TRUE(scene.solver.sleeping);
    EXPECT_EQ(scene.solver.horizontal_tension, 0.5);
    EXPECT_FALSE(scene.solver.tension_in_space);
    EXPECT_THAT(output.pictures_at_s, ElementsAre(1.0, 2.0));
    EXPECT_THAT(output.heights_at_s, ElementsAre());
    EXPECT_THAT(output.lines_along_y_mm, ElementsAre(6.0, 7.0));
    EXPECT_EQ(output.magnification->cells, (grid::Rect{0, 0, 10, 5}));
}

TEST_F(SceneJson, CellUnitsBecomeMillimetresAndWater) {
    files::Json json = kCells;
    json["paint"] = {{"viscosity_cells2_s", 2}, {"tension_cells3_s2", 8}, {"yield_cells2_s2", 0.5},
                     {"alpha_max", 1.2},        {"alpha_min", 0.5},       {"advancing_slope", 1},
                     {"receding_slope", 0},     {"slip_cells", 0.2}};
    json["gravity"] = {{"normal_cells_s2", 1}, {"x_cells_s2", 0.5}};
    const film::Scene scene = read(json).runs.at(0).scene;
    EXPECT_EQ(scene.cell_mm, 1.0);
    EXPECT_DOUBLE_EQ(scene.medium.viscosity_m2_s * 1e6, 2.0);
    EXPECT_DOUBLE_EQ(scene.medium.surface_tension_N_m / scene.medium.density_kg_m3 * 1e9, 8.0);
    EXPECT_DOUBLE_EQ(scene.medium.yield_stress_Pa / scene.medium.density_kg_m3 * 1e6, 0.5);
    EXPECT_DOUBLE_EQ(scene.medium.advancing_angle_deg, 45.0);
    EXPECT_EQ(scene.gravity, (film::Gravity{1.0, 0.5, 0.0}));
    EXPECT_EQ(read(kCells).runs.at(0).scene.gravity, (film::Gravity{}));
}

TEST_F(SceneJson, FormsMayHaveAPaintOfTheirOwn) {
    files::Json json = kSmall;
    json["film"].push_back(json["film"][0]);
    json["film"][1]["paint"] = "heavy-body oil";
    json["film"].push_back(json["film"][0]);
    json["film"][2]["paint"] = {{"like", "ink glaze"}, {"yield_stress_Pa", 3}};
    const film::Scene scene = read(json).runs.at(0).scene;
    EXPECT_FALSE(scene.film.at(0).medium);
    EXPECT_EQ(scene.film.at(1).medium->viscosity_m2_s, 0.3);
    EXPECT_EQ(scene.film.at(2).medium->viscosity_m2_s, 0.0001);
    EXPECT_EQ(scene.film.at(2).medium->yield_stress_Pa, 3.0);
    EXPECT_THAT(complaint(kSmall, "/film/0/paint", "honey"),
                HasSubstr("a.json, film[0].paint: There is no medium"));
    const files::Json in_cells = {{"viscosity_cells2_s", 9}};
    json = kCells;
    json["film"][0]["paint"] = in_cells;
    EXPECT_DOUBLE_EQ(read(json).runs.at(0).scene.film.at(0).medium->viscosity_m2_s, 9e-6);
    EXPECT_THAT(complaint(kSmall, "/film/0/paint", in_cells),
                HasSubstr("no field \"viscosity_cells2_s\""));
}

TEST_F(SceneJson, SchemesAreChosenByName) {
    const auto scheme = [](const char* name) {
        files::Json json = kSmall;
        json["solver"] = {{"scheme", name}};
        return read(json).runs.at(0).scene.solver.scheme;
    };
    EXPECT_EQ(scheme("auto"), film::Scheme::Auto);
    EXPECT_EQ(scheme("explicit"), film::Scheme::Explicit);
    EXPECT_EQ(scheme("large-step"), film::Scheme::LargeStep);
}

TEST_F(SceneJson, RunsChangeWhatTheyName) {
    files::Json json = kCells;
    json["runs"] = files::Json::parse(
        R"([{"name": "thin"}, {"name": "thick-2", "paint": {"viscosity_cells2_s": 9}, "duration_s": 1}])");
    const SceneFile file = read(json);
    ASSERT_EQ(file.runs.size(), 2U);
    EXPECT_EQ(file.runs[0].name, "thin");
    EXPECT_DOUBLE_EQ(file.runs[0].scene.medium.viscosity_m2_s, 2e-6);
    EXPECT_DOUBLE_EQ(file.runs[1].scene.medium.viscosity_m2_s, 9e-6);
    EXPECT_THAT(file.runs[1].output.pictures_at_s, ElementsAre(1.0));
    json["runs"][1]["paint"]["viscosity_cells2_s"] = -1;
    EXPECT_EQ(error_of([&] { read(json); }),
              "a.json, run \"thick-2\", paint.viscosity_cells2_s: -1 is not between 1e-06 and 1e+06.");
    json["runs"][1]["name"] = "../up";
    EXPECT_THAT(error_of([&] { read(json); }), HasSubstr("runs[1].name: a run is named by"));
    json["runs"][1] = {{"name", "thin"}};
    EXPECT_THAT(error_of([&] { read(json); }), HasSubstr("runs[1]: there is another run \"thin\"."));
    json["runs"][1] = {{"name", "b"}, {"cell_units", false}};
    EXPECT_THAT(error_of([&] { read(json); }), HasSubstr("\"cell_units\" stands once"));
    json["runs"] = files::Json::array();
    EXPECT_THAT(error_of([&] { read(json); }), HasSubstr("runs: at least one run is needed."));
}

TEST_F(SceneJson, ErrorsNameThePlaceTheValueAndWhatIsAllowed) {
    EXPECT_EQ(complaint(kSmall, "/film/0/radius_mm", -3),
              "a.json, film[0].radius_mm: -3 is not between 1e-04 and 1e+05.");
    EXPECT_EQ(complaint(kSmall, "/film/0/radius_cells", 3),
              "a.json, film[0]: there is no such entry as \"radius_cells\" here.");
    EXPECT_EQ(
        complaint(kSmall, "/film/0/kind", "pool"),
        "a.json, film[0].kind: there is no form \"pool\"; the forms are slab, box, disc, cap, gaussian, "
        "cosine, noise and image.");
    EXPECT_THAT(complaint(kSmall, "/film/0/pigment", "PB999"),
                HasSubstr("a.json, film[0].pigment: There is no pigment \"PB999\""));
    EXPECT_THAT(complaint(kSmall, "/film/0/thickness_mm", 3.5), HasSubstr("at most a half sphere"));
    EXPECT_THAT(complaint(kSmall, "/film/0/at_mm", {1}),
                HasSubstr("film[0].at_mm: expected two numbers"));
    EXPECT_THAT(complaint(kSmall, "/paint", "honey"), HasSubstr("a.json, paint: There is no medium"));
    EXPECT_THAT(complaint(kSmall, "/paint", {{"viscosity_m2_s", 50}}),
                HasSubstr("viscosity_m2_s is 50, it must be a number from"));
    EXPECT_THAT(complaint(kSmall, "/paint", {{"stickiness", 5}}), HasSubstr("no field \"stickiness\""));
    EXPECT_THAT(complaint(kSmall, "/paint", {{"viscosity_m2_s", "much"}}),
                HasSubstr("a.json, paint.viscosity_m2_s: expected a number, found \"much\"."));
    EXPECT_THAT(complaint(kSmall, "/support", "paper"), HasSubstr("there is no support \"paper\""));
    EXPECT_THAT(complaint(kSmall, "/edges", "round"),
                HasSubstr("edges: \"round\" is none of periodic, wall, open."));
    EXPECT_THAT(complaint(kSmall, "/solver", {{"scheme", "fast"}}),
                HasSubstr("solver.scheme: \"fast\" is none of auto, explicit, large-step."));
    EXPECT_EQ(complaint(kSmall, "/solver", {{"horizontal_tension", 1.5}}),
              "a.json, solver.horizontal_tension: 1.5 is not between 0 and 1.");
    EXPECT_THAT(complaint(kSmall, "/duration_s", "2"), HasSubstr("duration_s: expected a number"));
    EXPECT_THAT(complaint(kSmall, "/output", {{"pictures_at_s", {3}}}),
                HasSubstr("output.pictures_at_s[0]: 3 is not between 0 and 2."));
    EXPECT_THAT(complaint(kSmall, "/output", {{"picture_scale", 32.5}}), HasSubstr("picture_scale"));
    EXPECT_THAT(complaint(kSmall, "/size_mm", {20, 0}), HasSubstr("size_mm[1]: this makes 0 cells"));
    EXPECT_THAT(complaint(kSmall, "/gravity", {{"x_cells_s2", 1}}), HasSubstr("x_cells_s2"));
    files::Json both = kSmall;
    both["tilt"] = {{"tilt_deg", 5}};
    EXPECT_THAT(complaint(both, "/gravity", files::Json::object()), HasSubstr("give one of them"));
    EXPECT_THAT(complaint(kCells, "/tilt", {{"tilt_deg", 5}}), HasSubstr("a tilt needs millimetres"));
    EXPECT_THAT(complaint(kCells, "/support", "linen"), HasSubstr("known in millimetres only"));
    EXPECT_THAT(without(kSmall, "paint"), HasSubstr("a.json: the entry \"paint\" is missing."));
    EXPECT_THAT(without(kSmall, "duration_s"), HasSubstr("the entry \"duration_s\" is missing."));
}

TEST_F(SceneJson, WhatIsNoScene) {
    const auto text_error = [](const std::string& text) {
        return error_of([&] { scene_from_json(text, "a.json", "."); });
    };
    EXPECT_THAT(text_error("{"), HasSubstr("a.json, line 1: this is not valid JSON"));
    EXPECT_THAT(text_error("{\n\"duration_s\": NaN}"),
                HasSubstr("a.json, line 2: this is not valid JSON"));
    EXPECT_THAT(text_error("{}"), HasSubstr("a.json: this is not a scene"));
    EXPECT_THAT(text_error("[]"), HasSubstr("a.json: this is not a scene"));
    EXPECT_THAT(text_error(std::string(100000, '[')), HasSubstr("more than 32 deep"));
    EXPECT_THAT(complaint(kSmall, "/version", 2),
                HasSubstr("written by a newer Pastoso (scene format 2"));
}

TEST_F(SceneJson, TooLargeForMemory) {
    files::Json json = kSmall;
    json["size_mm"] = {32000, 32000};
    json["cell_mm"] = 1;
    EXPECT_THAT(error_of([&] { read(json); }),
                HasSubstr("a.json, size_mm: 32000 x 32000 cells need about"));
}

TEST_F(SceneJson, ImagesLieBesideTheScene) {
    files::write_image(folder / "map.exr", files::GreyImage{2, 1, {0.0F, 1.0F}});
    files::Json json = kSmall;
    json["support"] = {{"kind", "image"}, {"file", "map.exr"}, {"high_mm", 0.5}};
    json["film"] = {{{"kind", "image"}, {"file", "map.exr"}, {"thickness_mm", 0.2}}};
    core::write_text_file(folder / "a.json", json.dump());
    const film::Scene scene = read_scene((folder / "a.json").string()).runs.at(0).scene;
    EXPECT_EQ(std::get<film::ImageRelief>(scene.support.at(0)).map.width, 2);
    EXPECT_THAT(std::get<film::GreyMap>(scene.film.at(0).form).grey, ElementsAre(0.0F, 1.0F));
    json["support"]["file"] = "none.png";
    EXPECT_THAT(
        error_of([&] { scene_from_json(json.dump(), "a.json", folder); }),
        testing::AllOf(HasSubstr("a.json, support.file: "), HasSubstr("none.png: cannot be opened")));
}

TEST_F(SceneJson, ShorteningDropsWhatIsLater) {
    files::Json json = kSmall;
    json["output"] = {{"pictures_at_s", {0, 1, 2}},
                      {"magnified", {{"at_s", 2}, {"scale", 4}, {"cells", {0, 0, 4, 4}}}}};
    SceneRun run = read(json).runs.at(0);
    shorten(run, 1.5);
    EXPECT_EQ(run.scene.duration_s, 1.5);
    EXPECT_THAT(run.output.pictures_at_s, ElementsAre(0.0, 1.0));
    EXPECT_THAT(run.output.heights_at_s, ElementsAre());
    EXPECT_FALSE(run.output.magnification);
    shorten(run, 10.0);
    EXPECT_EQ(run.scene.duration_s, 1.5);
}

TEST_F(SceneJson, ScenesThatComeWithTheProgramAreFoundByName) {
    for (const char* name : {"paper-fig2", "paper-fig3", "paper-fig4", "paper-fig5", "paper-fig6"}) {
        const SceneFile file = read_scene(name);
        EXPECT_TRUE(file.cell_units);
        for (const SceneRun& run : file.runs) {
            EXPECT_EQ(run.scene.shape, (grid::Shape{100, 100})) << name;
            EXPECT_EQ(run.scene.solver.fixed_step_s, 0.004) << name;
            EXPECT_EQ(run.scene.solver.edge_x, film::Edge::Periodic) << name;
        }
    }
    EXPECT_THAT(error_of([] { read_scene("paper-fig9"); }),
                HasSubstr("There is no scene \"paper-fig9\"; give a file ending in .json, or one of: "
                          "glaze, paper-fig2, paper-fig3"));
}

}  // namespace
}  // namespace pastoso::recordings
