#include "liquid_files/tea_json.hpp"

#include "core/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::liquid_files {
namespace {

using liquid::TeaSettings;
using ::testing::AllOf;
using ::testing::HasSubstr;

std::string error_of(const std::string& entries) {
    try {
        tea_from_json(R"({"format": "pastoso-tea", "version": 1)" + entries + "}", "cup.json");
    } catch (const core::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(TeaJson, AnEmptySceneIsTheUsualTea) {
    EXPECT_EQ(tea_from_json(R"({"format": "pastoso-tea", "version": 1})", "cup.json"), TeaSettings{});
}

TEST(TeaJson, EverySettingComesBackAsItWasWritten) {
    TeaSettings settings;
    settings.cells = 32;
    settings.parcels = 777;
    settings.seed = 4'000'000'000U;
    settings.ball_candidates = 11;
    settings.advection = liquid::VelocityAdvection::Reflected;
    settings.cup.floor_m = 0.0051F;
    settings.cup.axis_m = {0.049F, 0.051F};
    // A little beside what is usual, so that every number counts.
    for (const liquid::TeaNumber& number : liquid::tea_numbers()) {
        double& value = settings.*number.value;
        value = value == 0.0 ? 0.01 * number.most : 0.97 * value;
    }
    EXPECT_EQ(tea_from_json(tea_to_json(settings), "cup.json"), settings);
}

TEST(TeaJson, ErrorsNameFilePlaceAndValue) {
    EXPECT_THAT(error_of(R"(, "milk_m3": -1)"),
                AllOf(HasSubstr("cup.json"), HasSubstr("milk_m3 is -1")));
    EXPECT_THAT(error_of(R"(, "viscosity_m2_s": -0.1)"), HasSubstr("viscosity_m2_s is -0.1"));
    EXPECT_THAT(error_of(R"(, "cells": 0)"), AllOf(HasSubstr("cup.json, cells"), HasSubstr("0")));
    EXPECT_THAT(error_of(R"(, "cells": 4096)"), AllOf(HasSubstr("cup.json, cells"), HasSubstr("4096")));
    EXPECT_THAT(error_of(R"(, "milk": 1)"), HasSubstr("\"milk\""));
    EXPECT_THAT(error_of(R"(, "cup": {"depth_m": 1})"), AllOf(HasSubstr("cup"), HasSubstr("depth_m")));
    EXPECT_THAT(error_of(R"(, "advection": "linear")"), HasSubstr("\"linear\""));
    EXPECT_THAT(error_of(R"(, "cup": {"level_m": 1e30})"), HasSubstr("cup.level_m is 1e+30"));
}

TEST(TeaJson, OtherFilesAreRefused) {
    EXPECT_THROW(tea_from_json("{}", "cup.json"), core::InputError);
    EXPECT_THROW(tea_from_json(R"({"format": "pastoso-scene", "version": 1})", "cup.json"),
                 core::InputError);
    EXPECT_THROW(tea_from_json(R"({"format": "pastoso-tea", "version": 2})", "cup.json"),
                 core::InputError);
}

}  // namespace
}  // namespace pastoso::liquid_files
