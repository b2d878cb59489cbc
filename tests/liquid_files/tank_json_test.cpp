#include "liquid_files/tank_json.hpp"

#include "core/error.hpp"
#include "core/text_file.hpp"
#include "document/error_of.hpp"
#include "files/temporary_folder.hpp"
#include "liquid_files/mesh_export.hpp"
#include "tank/meshes.hpp"

#include <gmock/gmock.h>

namespace pastoso::liquid_files {
namespace {

using document::error_of;
using tank::Combination;
using tank::Combined;
using tank::Shape;
using tank::TankScene;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::shared_ptr<const liquid::TriangleMesh> kMesh =
    std::make_shared<const liquid::TriangleMesh>(tank::test::octahedron());

/// Any file is that mesh.
std::shared_ptr<const liquid::TriangleMesh> always_that(const std::string&) {
    return kMesh;
}

TankScene read(const std::string& entries) {
    return tank_from_json(R"({"format": "pastoso-tank", "version": 1)" + entries + "}", "tank.json",
                          always_that);
}

std::string error_in(const std::string& entries) {
    return error_of([&] { read(entries); });
}

std::string error_in_shape(const std::string& shape) {
    return error_in(R"(, "solids": [)" + shape + "]");
}

TEST(TankJson, AnEmptySceneIsTheUsualTank) {
    EXPECT_EQ(read(""), TankScene{});
}

/// With a little of all that there is.
TankScene full_scene() {
    liquid::Cup cup;
    cup.axis_m = {0.031F, 0.072F};
    cup.wall_m = 0.0031F;
    const Shape ball{tank::Sphere{{0.1F, 0.2F, 0.3F}, 0.01F}};
    const Shape block{tank::Block{{-0.1F, -0.2F, 0}, {1.0F / 3.0F, 0.2F, 0.3F}}};
    const Shape rod{tank::Cylinder{{0, 0, 0}, {1e-5F, 0.2F, 123.456F}, 0.07F}};
    const Shape ring{tank::Torus{{0.1F, 0, 0}, {0.6F, 0, 0.8F}, 0.2F, 0.05F}};
    const Shape body{tank::MeshBody{"parts/body.obj", kMesh, {0.3F, 0.2F, 0.1F}, 0.02F}};
    const Shape rest{Combined{Combination::Difference,
                              {Shape{Combined{Combination::Union, {ball, rod}}},
                               Shape{Combined{Combination::Intersection, {body, ring, block}}}}}};
    TankScene scene;
    scene.name = "Everything, with \"quotes\" and \u00e9";
    scene.cells = {9, 17, 256};
    scene.method = tank::Method::ParticleLevelSet;
    scene.seed = 4'000'000'000U;
    for (const tank::TankNumber& number : tank::tank_numbers()) {
        double& value = scene.*number.value;
        value = value == 0.0 ? 0.01 * number.most : 0.97 * value;
    }
    scene.liquids = {{block, {0.1F, -0.2F, 0.3F}, 0.4F}, {rest, {}, 0.0F}};
    scene.solids = {Shape{tank::CupGlass{cup}}, rest, body};
    scene.jets = {{rod, {-100.0F, 0, 0}, 1.0F, 0.1, 0.3}};
    scene.drains = {{ring, 5.5, 6.5}, {ball}};
    scene.wind = {3.5, -45.0, 0.25, 1.0, 2.0};
    return scene;
}

TEST(TankJson, EverythingComesBackAsItWasWritten) {
    const TankScene scene = full_scene();
    EXPECT_EQ(tank_from_json(tank_to_json(scene), "tank.json", always_that), scene);
    TankScene other = scene;
    for (const tank::Method method : {tank::Method::Particles, tank::Method::LevelSet}) {
        other.method = method;
        EXPECT_EQ(tank_from_json(tank_to_json(other), "tank.json", always_that), other);
    }
}

TEST(TankJson, FloatsAreWrittenWithNoMoreDigitsThanTheyHave) {
    EXPECT_EQ(float_to_json(0.1F).dump(), "0.1");
    EXPECT_EQ(float_to_json(-1234.5F).dump(), "-1234.5");
    EXPECT_THAT(tank_to_json(full_scene()),
                AllOf(HasSubstr("0.072"), testing::Not(HasSubstr("0.0719"))));
    for (const float value : {1.0F / 3.0F, 16777217.0F, 1e-30F, 3.4e38F})
        EXPECT_EQ(float_to_json(value).get<float>(), value);
}

TEST(TankJson, WhatIsNotGivenIsAsUsual) {
    const TankScene scene = read(R"(, "liquids": [{"shape": {"sphere": {"centre_m": [0.1, 0.2, 0.3],
        "radius_m": 0.05}}}], "jets": [{"shape": {"cup": {"slope": 0.2}}}], "wind": {"speed_m_s": 2},
        "drains": [{"shape": {"torus": {"centre_m": [1, 1, 1], "ring_radius_m": 2,
        "tube_radius_m": 1}}}], "solids": [{"mesh": {"file": "a.stl"}}])");
    TankScene expected;
    expected.liquids.push_back({Shape{tank::Sphere{{0.1F, 0.2F, 0.3F}, 0.05F}}});
    liquid::Cup cup;
    cup.slope = 0.2F;
    expected.jets.push_back({Shape{tank::CupGlass{cup}}});
    expected.drains.push_back({Shape{tank::Torus{{1, 1, 1}, {0, 0, 1}, 2, 1}}});
    expected.solids.push_back(Shape{tank::MeshBody{"a.stl", kMesh}});
    expected.wind.speed_m_s = 2.0;
    EXPECT_EQ(scene, expected);
}

TEST(TankJson, ErrorsNameFilePlaceAndValue) {
    EXPECT_EQ(error_in(R"(, "cell_m": -1)"), "tank.json: cell_m is -1, not between 1e-05 and 10.");
    EXPECT_EQ(error_in(R"(, "cells": [64, 4096, 64])"),
              "tank.json, cells[1]: 4096 is not between 8 and 256.");
    EXPECT_EQ(error_in(R"(, "cells": [64, 64])"),
              "tank.json, cells: expected three whole numbers, found 2.");
    EXPECT_THAT(error_in(R"(, "cells": 64)"), HasSubstr("tank.json, cells: expected a list"));
    EXPECT_EQ(error_in(R"(, "method": "flip")"),
              "tank.json, method: \"flip\" is none of \"particles\", \"level_set\", "
              "\"upwind_level_set\" and \"particle_level_set\".");
    EXPECT_THAT(error_in(R"(, "seed": -1)"), HasSubstr("tank.json, seed: -1"));
    EXPECT_THAT(error_in(R"(, "name": 3)"), HasSubstr("tank.json, name: expected a text"));
    EXPECT_THAT(error_in(R"(, "milk": 1)"), HasSubstr("no such entry as \"milk\""));
    EXPECT_THAT(error_in(R"(, "wind": {"force": 1})"), HasSubstr("wind: there is no such entry"));
    EXPECT_EQ(error_in(R"(, "wind": {"until_s": -1})"),
              "tank.json: wind.until_s is -1, not between 0 and 1e+09.");
    EXPECT_THAT(error_in(R"(, "liquids": {})"), HasSubstr("tank.json, liquids: expected a list"));
    EXPECT_THAT(error_in(R"(, "liquids": [{"milk": 1}])"),
                HasSubstr("tank.json, liquids[0]: the entry \"shape\" is missing"));
    EXPECT_THAT(error_in(R"(, "liquids": [{"shape": {"cup": {}}, "from_s": 1}])"),
                HasSubstr("tank.json, liquids[0]: there is no such entry as \"from_s\""));
    EXPECT_EQ(error_in(R"(, "liquids": [{"shape": {"cup": {}}, "milk": 2}])"),
              "tank.json: liquids[0].milk is 2, not between 0 and 1.");
    EXPECT_EQ(error_in(R"(, "jets": [{"shape": {"cup": {}}, "velocity_m_s": [0, 0, 1e39]}])"),
              "tank.json: jets[0].velocity_m_s is inf, not between -100 and 100.");
    EXPECT_THAT(error_in(R"(, "drains": [{"shape": {"cup": {}}, "milk": 1}])"),
                HasSubstr("tank.json, drains[0]: there is no such entry as \"milk\""));
}

TEST(TankJson, ErrorsInShapesNameTheirPlace) {
    EXPECT_THAT(error_in_shape("3"),
                AllOf(StartsWith("tank.json, solids[0]: a shape is an object with one entry"),
                      EndsWith("union, intersection, difference.")));
    EXPECT_THAT(error_in_shape("{}"), HasSubstr("a shape is an object with one entry"));
    EXPECT_THAT(error_in_shape(R"({"cup": {}, "mesh": {}})"), HasSubstr("with one entry"));
    EXPECT_THAT(error_in_shape(R"({"ball": {}})"),
                HasSubstr("tank.json, solids[0]: \"ball\" is no form of a shape; there are sphere,"));
    EXPECT_THAT(error_in_shape(R"({"sphere": {"radius_m": 1}})"),
                HasSubstr("tank.json, solids[0].sphere: the entry \"centre_m\" is missing"));
    EXPECT_THAT(error_in_shape(R"({"sphere": {"centre_m": [1, 2], "radius_m": 1}})"),
                HasSubstr("solids[0].sphere.centre_m: expected three numbers, found 2."));
    EXPECT_THAT(error_in_shape(R"({"sphere": {"centre_m": [1, 2, "3"], "radius_m": 1}})"),
                HasSubstr("solids[0].sphere.centre_m[2]: expected a number"));
    EXPECT_THAT(error_in_shape(R"({"cup": {"height_m": 1}})"),
                HasSubstr("solids[0].cup: there is no such entry as \"height_m\""));
    EXPECT_THAT(error_in_shape(R"({"union": []})"),
                HasSubstr("tank.json, solids[0].union: a combination has no parts."));
    EXPECT_THAT(
        error_in_shape(
            R"({"difference": [{"cup": {}}, {"union": [{"cup": {}}, {"cup": {"wall_m": -1}}]}]})"),
        HasSubstr("tank.json, solids[0].difference[1].union[1]: cup: wall_m is -1"));
    for (const char* form : {"sphere", "block", "cylinder", "torus", "mesh"})
        EXPECT_THAT(error_in_shape(R"({")" + std::string(form) + R"(": {"size_m": 1}})"),
                    HasSubstr("there is no such entry as \"size_m\""))
            << form;
}

TEST(TankJson, OtherFilesAreRefused) {
    EXPECT_THROW(tank_from_json("{}", "tank.json"), core::InputError);
    EXPECT_THROW(tank_from_json(R"({"format": "pastoso-tea", "version": 1})", "tank.json"),
                 core::InputError);
    EXPECT_THROW(tank_from_json(R"({"format": "pastoso-tank", "version": 2})", "tank.json"),
                 core::InputError);
    std::string nested = R"({"cup": {}})";
    for (int depth = 0; depth < 40; ++depth)
        nested = R"({"union": [)" + nested + "]}";
    EXPECT_THAT(error_in_shape(nested), HasSubstr("nested more than 64 deep"));
}

class TankFileTest : public files::TemporaryFolder {};

TEST_F(TankFileTest, MeshesAreFoundBesideTheScene) {
    std::filesystem::create_directory(folder / "parts");
    export_mesh(folder / "parts/body.obj", *kMesh, {}, [](double) { return true; });
    const TankScene scene = full_scene();
    core::write_text_file(folder / "tank.json", tank_to_json(scene));
    const TankScene back = read_tank((folder / "tank.json").string());
    EXPECT_EQ(back, scene);
    // Read once.
    const auto& parts = std::get<Combined>(back.solids[1].form).parts;
    const auto& first = std::get<tank::MeshBody>(std::get<Combined>(parts[1].form).parts[0].form);
    EXPECT_EQ(first.mesh, std::get<tank::MeshBody>(back.solids[2].form).mesh);
}

TEST_F(TankFileTest, MeshesThatCannotBeReadAreNamed) {
    const auto error_with = [&](const char* file) {
        core::write_text_file(
            folder / "tank.json",
            R"({"format": "pastoso-tank", "version": 1, "solids": [{"mesh": {"file": ")" +
                std::string(file) + "\"}}]}");
        return error_of([&] { read_tank((folder / "tank.json").string()); });
    };
    EXPECT_THAT(error_with("none.obj"), AllOf(HasSubstr("tank.json, solids[0].mesh.file: "),
                                              HasSubstr("none.obj: cannot be opened")));
    core::write_text_file(folder / "flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_THAT(error_with("flat.obj"), HasSubstr("tank.json, solids[0]: mesh: it is not closed"));
    core::write_text_file(folder / "bad.obj", "v 0 0 x\n");
    EXPECT_THAT(error_with("bad.obj"), HasSubstr("bad.obj, line 1: \"x\" is no number."));
}

}  // namespace
}  // namespace pastoso::liquid_files
