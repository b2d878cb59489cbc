// Shapes that cannot be are refused in a sentence that names the number.
#include "core/error.hpp"
#include "tank/meshes.hpp"
#include "tank/shape.hpp"

#include <limits>
#include <memory>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::tank {
namespace {

using ::testing::HasSubstr;

constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();

MeshBody mesh_body(liquid::TriangleMesh mesh) {
    return {"body.obj", std::make_shared<const liquid::TriangleMesh>(std::move(mesh)), {}, 1.0F};
}

std::string fault(auto form) {
    try {
        check_shape(Shape{std::move(form)});
    } catch (const core::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(CheckShape, NumbersOutOfRangeAreNamed) {
    EXPECT_EQ(fault(Sphere{{0, 0, 0}, -1}), "sphere: radius_m is -1, not between 1e-06 and 10000.");
    EXPECT_EQ(fault(Sphere{{0, kNoNumber, 0}, 1}),
              "sphere: centre_m is nan, not between -10000 and 10000.");
    EXPECT_EQ(fault(Block{{0, 0, 0}, {1, 0, 1}}),
              "block: high_m - low_m is 0, not between 1e-06 and 10000.");
    EXPECT_THAT(fault(Block{{0, -1e9F, 0}, {1, 0, 1}}), HasSubstr("block: low_m is -1e+09"));
    EXPECT_THAT(fault(Block{{0, 0, 0}, {1, 1, kNoNumber}}), HasSubstr("block: high_m is nan"));
    EXPECT_THAT(fault(Cylinder{{1, 2, 3}, {1, 2, 3}, 1}),
                HasSubstr("cylinder: the distance from from_m to to_m is 0"));
    EXPECT_THAT(fault(Cylinder{{1, 2, 3}, {1, 2, 2e4F}, 1}), HasSubstr("cylinder: to_m is 20000"));
    EXPECT_THAT(fault(Cylinder{{-2e4F, 2, 3}, {1, 2, 2}, 1}), HasSubstr("cylinder: from_m is -20000"));
    EXPECT_THAT(fault(Cylinder{{0, 0, 0}, {0, 0, 1}, 0}), HasSubstr("cylinder: radius_m is 0"));
    EXPECT_THAT(fault(Torus{{0, 0, 0}, {0, 0, 0}, 2, 1}), HasSubstr("torus: the length of axis is 0"));
    EXPECT_THAT(fault(Torus{{0, 0, 1e5F}, {0, 0, 1}, 2, 1}), HasSubstr("torus: centre_m is 100000"));
    EXPECT_THAT(fault(Torus{{0, 0, 0}, {0, 0, kNoNumber}, 2, 1}), HasSubstr("torus: axis is nan"));
    EXPECT_THAT(fault(Torus{{0, 0, 0}, {0, 0, 1}, -2, 1}), HasSubstr("torus: ring_radius_m is -2"));
    EXPECT_THAT(fault(Torus{{0, 0, 0}, {0, 0, 1}, 2, kNoNumber}),
                HasSubstr("torus: tube_radius_m is nan"));
    EXPECT_THAT(fault(Torus{{0, 0, 0}, {0, 0, 1}, 1, 1.5F}),
                HasSubstr("torus: ring_radius_m - tube_radius_m is -0.5"));
}

TEST(CheckShape, CupsThatCannotBeAreNamed) {
    const auto cup_fault = [](float liquid::Cup::*number, float value) {
        liquid::Cup cup;
        cup.*number = value;
        return fault(CupGlass{cup});
    };
    using liquid::Cup;
    EXPECT_EQ(cup_fault(&Cup::wall_m, 0), "cup: wall_m is 0, not between 1e-06 and 10000.");
    EXPECT_THAT(cup_fault(&Cup::foot_m, 0.5F), HasSubstr("cup: floor_m - foot_m is -0.496"));
    EXPECT_THAT(cup_fault(&Cup::rim_m, 0.001F), HasSubstr("cup: rim_m - floor_m is -0.003"));
    EXPECT_THAT(cup_fault(&Cup::rim_m, kNoNumber), HasSubstr("foot_m, floor_m and rim_m is nan"));
    EXPECT_THAT(cup_fault(&Cup::level_m, kNoNumber), HasSubstr("cup: level_m is nan"));
    EXPECT_THAT(cup_fault(&Cup::slope, 11), HasSubstr("cup: slope is 11"));
    EXPECT_THAT(cup_fault(&Cup::floor_radius_m, 0), HasSubstr("cup: floor_radius_m is 0"));
    EXPECT_THAT(cup_fault(&Cup::slope, -1), HasSubstr("cup: the inner radius at rim_m is -0.061"));
    EXPECT_THAT(cup_fault(&Cup::slope, 10), HasSubstr("cup: the outer radius at foot_m is -0.0198"));
    liquid::Cup cup;
    cup.axis_m.y = 1e6F;
    EXPECT_THAT(fault(CupGlass{cup}), HasSubstr("cup: x_m and y_m is 1e+06"));
}

TEST(CheckShape, MeshesAndCombinationsThatCannotBeAreNamed) {
    EXPECT_EQ(fault(MeshBody{"bunny.obj", nullptr, {}, 1}), "mesh: \"bunny.obj\" was not read.");
    MeshBody body = mesh_body(test::octahedron());
    body.scale = 0;
    EXPECT_THAT(fault(body), HasSubstr("mesh: scale is 0"));
    body.scale = 1;
    body.position_m.z = kNoNumber;
    EXPECT_THAT(fault(body), HasSubstr("mesh: position_m is nan"));
    liquid::TriangleMesh open = test::octahedron();
    open.triangles.pop_back();
    EXPECT_THAT(fault(mesh_body(open)), HasSubstr("mesh: it is not closed"));
    EXPECT_EQ(fault(Combined{Combination::Union, {}}), "a combination has no parts.");
    EXPECT_THAT(fault(Combined{Combination::Union, {{CupGlass{}}, {Sphere{}}}}),
                HasSubstr("sphere: radius_m is 0"));
    EXPECT_THROW(ShapeDistance({Sphere{}}), core::InputError);
}

}  // namespace
}  // namespace pastoso::tank
