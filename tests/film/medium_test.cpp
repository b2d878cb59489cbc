#include "core/error.hpp"
#include "core/units.hpp"
#include "film/media_families.hpp"

#include <algorithm>
#include <cctype>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace pastoso::film;  // NOLINT(google-build-using-namespace)
using testing::HasSubstr;

constexpr const char* kGood = R"([
  {"name": "tar", "description": "Slow.", "density_kg_m3": 1200, "viscosity_m2_s": 0.5, "yield_stress_Pa": 10,
   "surface_tension_N_m": 0.03, "advancing_angle_deg": 30, "receding_angle_deg": 10, "slip_cells": 0.2,
   "alpha_min": 1.0, "alpha_max": 1.0, "typical_thickness_mm": 0.5, "solid_fraction": 0.8,
   "touch_dry_s": 7200}
])";

/// kGood with one piece of text replaced.
std::string changed(const std::string& from, const std::string& to) {
    std::string text = kGood;
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return text.replace(place, from.size(), to);
}

std::string error_of(const std::string& text) {
    try {
        parse_media(text, "my media.json");
    } catch (const pastoso::core::InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Media, AreReadFieldByField) {
    const std::vector<Medium> media = parse_media(kGood, "test");
    ASSERT_EQ(media.size(), 1U);
    EXPECT_EQ(media[0].name, "tar");
    EXPECT_EQ(media[0].viscosity_m2_s, 0.5);
    EXPECT_EQ(media[0].typical_thickness_mm, 0.5);
    EXPECT_EQ(media[0].solid_fraction, 0.8);
    EXPECT_EQ(media[0].touch_dry_s, 7200.0);
    EXPECT_TRUE(parse_media("[]", "test").empty());
}

TEST(Media, TheFlowIndexMayBeLeftOut) {
    EXPECT_EQ(parse_media(kGood, "test")[0].flow_index, 1.0);
    const std::string thinning =
        changed("\"yield_stress_Pa\"", "\"flow_index\": 0.4, \"yield_stress_Pa\"");
    EXPECT_EQ(parse_media(thinning, "test")[0].flow_index, 0.4);
    EXPECT_THAT(error_of(changed("\"yield_stress_Pa\"", "\"flow_index\": 1.5, \"yield_stress_Pa\"")),
                HasSubstr("flow_index is 1.5, it must be a number from 0.2 to 1.0."));
}

TEST(Media, ErrorsNameTheFileTheEntryTheFieldAndTheValue) {
    EXPECT_EQ(error_of(changed("\"yield_stress_Pa\": 10", "\"yield_stress_Pa\": -3")),
              "my media.json, entry 1 (\"tar\"): yield_stress_Pa is -3, it must be a number from 0.0 to "
              "200.0.");
    EXPECT_EQ(error_of(changed("\"slip_cells\": 0.2,", "")),
              "my media.json, entry 1 (\"tar\"): the field \"slip_cells\" is missing.");
    EXPECT_EQ(error_of(changed("\"tar\"", "7")),
              "my media.json, entry 1: name is 7, it must be a text.");
}

TEST(Media, WrongKindsOfValuesAreRefused) {
    EXPECT_THAT(error_of(changed("0.5, \"yield", "\"thick\", \"yield")),
                HasSubstr("viscosity_m2_s is \"thick\""));
    EXPECT_THAT(error_of(changed("0.5, \"yield", "null, \"yield")), HasSubstr("viscosity_m2_s is null"));
    EXPECT_THAT(error_of(changed("0.5, \"yield", "1e999, \"yield")), HasSubstr("my media.json"));
    EXPECT_THAT(error_of(changed("slip_cells", "slip_cell")), HasSubstr("\"slip_cells\" is missing"));
    EXPECT_THAT(error_of(changed("\"slip_cells\"", "\"gloss\": 1, \"slip_cells\"")),
                HasSubstr("there is no field \"gloss\""));
}

TEST(Media, ContradictionsAreRefused) {
    EXPECT_THAT(
        error_of(changed("\"receding_angle_deg\": 10", "\"receding_angle_deg\": 40")),
        HasSubstr("receding_angle_deg is 40.0, it must not be larger than advancing_angle_deg, 30.0"));
    EXPECT_THAT(error_of(changed("\"alpha_min\": 1.0", "\"alpha_min\": 1.5")),
                HasSubstr("alpha_min is 1.5"));
    EXPECT_THAT(error_of(changed("7200", "1800001")),
                HasSubstr("touch_dry_s is 1800001.0, it must not be larger than"));
}

TEST(Media, WhatIsNotAListOfMediaIsRefused) {
    EXPECT_THAT(error_of(""), HasSubstr("my media.json, line 1: this is not JSON"));
    EXPECT_THAT(error_of("[\n\n oops ]"), HasSubstr("my media.json, line 3: this is not JSON"));
    EXPECT_THAT(error_of("{}"), HasSubstr("not a list of media"));
    EXPECT_THAT(error_of("[3]"), HasSubstr("entry 1: is not an object"));
}

TEST(BundledMedia, AreThoseOfTheProgram) {
    std::vector<std::string> names;
    for (const Medium& medium : bundled_media())
        names.push_back(medium.name);
    EXPECT_THAT(names, testing::ElementsAre("heavy-body oil", "wax paste", "alkyd gel", "linseed oil",
                                            "stand oil", "thin oil", "soft-body acrylic",
                                            "fluid acrylic", "house paint", "ink glaze", "thinner"));
}

TEST(BundledMedia, OilsAndAcrylicsRunFromStiffToThin) {
    const std::vector<std::vector<const char*>> families = {
        {"wax paste", "heavy-body oil", "alkyd gel", "linseed oil", "stand oil", "thin oil", "thinner"},
        {"soft-body acrylic", "fluid acrylic", "house paint", "ink glaze", "thinner"}};
    for (const auto& family : families) {
        for (std::size_t i = 1; i < family.size(); ++i) {
            const Medium &stiffer = find_medium(family[i - 1]), &thinner = find_medium(family[i]);
            EXPECT_GT(stiffer.viscosity_m2_s, thinner.viscosity_m2_s) << family[i];
            EXPECT_GE(stiffer.yield_stress_Pa, thinner.yield_stress_Pa) << family[i];
        }
    }
}

TEST(BundledMedia, StandUnderTwoHeadings) {
    std::vector<std::string> names, order;
    for (const MediaFamily& family : bundled_media_families()) {
        names.push_back(family.name);
        for (const Medium& medium : family.media)
            order.push_back(medium.name);
    }
    EXPECT_THAT(names, testing::ElementsAre("Oils", "Acrylics and others"));
    EXPECT_EQ(bundled_media_families()[0].media.back().name, "thin oil");
    ASSERT_EQ(order.size(), bundled_media().size());
    for (std::size_t i = 0; i < order.size(); ++i)
        EXPECT_EQ(order[i], bundled_media()[i].name);
}

TEST(BundledMedia, SayWhatTheyAreAndWhatThinsThem) {
    for (const Medium& medium : bundled_media())
        EXPECT_THAT(medium.description, testing::EndsWith("."));
    for (const Medium& medium : bundled_media())
        EXPECT_EQ(medium.thinned_with.empty(), medium.name == "thinner") << medium.name;
}

TEST(Media, AreThinnedWithOneOfTheOthers) {
    const auto thinned_with = [](const std::string& name) {
        return changed("\"yield_stress_Pa\"", "\"thinned_with\": \"" + name + "\", \"yield_stress_Pa\"");
    };
    std::string two = thinned_with("thin tar");
    const std::string thin_tar = changed("tar", "thin tar");
    two.replace(two.rfind(']'), 1, "," + thin_tar.substr(thin_tar.find('{')));
    EXPECT_EQ(parse_media(two, "test")[0].thinned_with, "thin tar");
    EXPECT_EQ(error_of(thinned_with("tar")),
              "my media.json (\"tar\"): thinned_with is \"tar\", it must be the name of another medium "
              "here.");
    EXPECT_THAT(error_of(thinned_with("milk")), HasSubstr("thinned_with is \"milk\""));
}

TEST(Media, HoldAllOfThePigmentUnlessTheySayLess) {
    EXPECT_EQ(parse_media(kGood, "test")[0].pigment_share, 1.0);
    const auto share = [](const char* value) {
        return changed("\"yield_stress_Pa\"",
                       std::string("\"pigment_share\": ") + value + ", \"yield_stress_Pa\"");
    };
    EXPECT_EQ(parse_media(share("0.25"), "test")[0].pigment_share, 0.25);
    EXPECT_THAT(error_of(share("0")),
                HasSubstr("pigment_share is 0, it must be a number from 0.0005 to 1.0."));
}

/// Thickness that stands on an upright canvas: tau / (rho g).
double standing_thickness_mm(const Medium& medium) {
    return medium.yield_stress_Pa /
           (medium.density_kg_m3 * pastoso::core::kStandardGravity_mm_s2 * 1e-3) * 1e3;
}

TEST(BundledMedia, OilStandsOnAnUprightCanvasAndHousePaintRuns) {
    const Medium& oil = find_medium("heavy-body oil");
    const Medium& house = find_medium("house paint");
    EXPECT_GT(standing_thickness_mm(oil), oil.typical_thickness_mm);
    EXPECT_LT(standing_thickness_mm(house), house.typical_thickness_mm);
}

TEST(ParseMedium, NumbersLeftOutAreTheOtherMediums) {
    const Medium& oil = find_medium("heavy-body oil");
    const Medium thin = parse_medium(R"({"viscosity_m2_s": 0.02, "alpha_min": 0.5})",
                                     pastoso::core::Message::verbatim("a.json"), oil);
    EXPECT_EQ(thin.viscosity_m2_s, 0.02);
    EXPECT_EQ(thin.alpha_min, 0.5);
    EXPECT_EQ(thin.yield_stress_Pa, oil.yield_stress_Pa);
    EXPECT_EQ(thin.name, oil.name);
    EXPECT_EQ(parse_medium("{}", pastoso::core::Message::verbatim("a.json"), {}).density_kg_m3,
              Medium{}.density_kg_m3);
}

TEST(ParseMedium, RefusesUnknownAndOddNumbers) {
    const auto error = [](const char* text) -> std::string {
        try {
            parse_medium(text, pastoso::core::Message::verbatim("a.json"), {});
        } catch (const pastoso::core::InputError& problem) {
            return problem.what();
        }
        return "";
    };
    EXPECT_THAT(error(R"({"viscosity_m2_s": 7})"),
                HasSubstr("viscosity_m2_s is 7, it must be a number"));
    EXPECT_THAT(error(R"({"stickiness": 7})"), HasSubstr("there is no field \"stickiness\""));
    EXPECT_THAT(error(R"({"alpha_min": 1.5})"), HasSubstr("must not be larger than alpha_max"));
    EXPECT_THAT(error("[]"), HasSubstr("a.json: is not an object in braces."));
}

TEST(ParseMedium, ReadsExactlyWhatIsWritten) {
    for (Medium medium : bundled_media()) {
        medium.viscosity_m2_s = 1.0 / 3.0;
        EXPECT_EQ(
            parse_medium(numbers_to_json(medium), pastoso::core::Message::verbatim("here"), medium),
            medium);
    }
}

TEST(FindMedium, IgnoresCase) {
    EXPECT_EQ(find_medium("House PAINT").name, "house paint");
}

TEST(FindMedium, ListsTheNamesThereAre) {
    try {
        find_medium("honey");
        FAIL() << "no error";
    } catch (const pastoso::core::InputError& error) {
        EXPECT_STREQ(
            error.what(),
            "There is no medium \"honey\"; the media are: heavy-body oil, wax paste, alkyd gel, linseed "
            "oil, stand oil, thin oil, soft-body acrylic, fluid acrylic, house paint, ink glaze, "
            "thinner.");
    }
}

}  // namespace
