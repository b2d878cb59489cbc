#include "brush/preset.hpp"

#include "brush/preset_fields.hpp"
#include "core/error.hpp"
#include "core/text_file.hpp"
#include "source_file.hpp"

#include <algorithm>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace pastoso::brush {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

json valid_preset() {
    return json::parse(R"({
        "version": 4, "kind": "contact", "name": "Test", "dips": true, "units": {"length": "mm", "angle": "deg", "volume": "mm3"},
        "tip": {"shape": "flat", "width": 20, "thickness": 4.8, "length": 22, "point": 0, "bristles": 300,
                "hairs_per_bristle": 16, "seed": 1},
        "flex": {"bend": 0.5, "splay": 0.22, "lag": 1, "press_depth": 0.32, "tilt_gain": 0.8, "descend": 0.35,
                 "rigidity": 0, "ride": 0.5},
        "paint": {"film": 0.22, "run": 160, "groove": 0.5, "hair": 0.35, "streak": 0.75, "gather": 0.5, "edge": 0.7,
                  "start": 0.5, "leave": 0, "reach": 1.15},
        "exchange": {"pickup": 0.35, "mix": 0.3, "wick": 0.06, "momentum": 0.5, "overflow": 1.15, "absorbs": false},
        "stroke": {"spacing": 0.4, "min_spacing": 0.06, "smoothing_ms": 10, "string_mm": 0,
                   "jitter_seed": "stroke"},
        "dynamics": [{"input": "pressure", "target": "press", "curve": [[0, 0], [1, 1]]}]})");
}

/// The message that parsing gives; empty when it succeeds.
std::string error_of(const std::string& text) {
    try {
        parse_preset(text, "test.json");
        return "";
    } catch (const core::InputError& error) {
        return error.what();
    }
}

std::string error_with(const char* pointer, const json& value) {
    json preset = valid_preset();
    preset[json::json_pointer(pointer)] = value;
    return error_of(preset.dump());
}

TEST(Preset, ReadsEveryField) {
    const Preset preset = parse_preset(valid_preset().dump(), "test.json");
    EXPECT_EQ(preset.name, "Test");
    EXPECT_EQ(preset.tip.shape, TipShape::Flat);
    EXPECT_EQ(preset.tip.width_mm, 20.0);
    EXPECT_EQ(preset.tip.bristles, 300);
    EXPECT_EQ(preset.flex.descend, 0.35);
    EXPECT_EQ(preset.paint.film_mm, 0.22);
    EXPECT_EQ(preset.exchange.overflow, 1.15);
    EXPECT_EQ(preset.stroke.smoothing_ms, 10.0);
    EXPECT_EQ(preset.stroke.jitter_seed, JitterSeed::Stroke);
    ASSERT_EQ(preset.dynamics.size(), 1U);
    EXPECT_EQ(preset.dynamics[0].input, DynamicsInput::Pressure);
    EXPECT_EQ(preset.dynamics[0].target, DynamicsTarget::Press);
    ASSERT_EQ(preset.dynamics[0].points.size(), 2U);
    EXPECT_EQ(preset.dynamics[0].points[1].output, 1.0);
}

TEST(Preset, SaysWhichFieldIsMissing) {
    json preset = valid_preset();
    preset["paint"].erase("film");
    EXPECT_EQ(error_of(preset.dump()), "test.json: paint.film is missing.");
    preset = valid_preset();
    preset.erase("tip");
    EXPECT_EQ(error_of(preset.dump()), "test.json: tip is missing.");
}

TEST(Preset, SaysWhichFieldHasTheWrongType) {
    EXPECT_EQ(error_with("/tip/width", "wide"), "test.json: tip.width must be a number, not \"wide\".");
    EXPECT_EQ(error_with("/tip/bristles", 1.5e2 + 0.5),
              "test.json: tip.bristles must be a whole number, not 150.5.");
    EXPECT_THAT(error_with("/flex", 3), HasSubstr("flex must be an object, not 3"));
    EXPECT_THAT(error_with("/dynamics", "none"), HasSubstr("dynamics must be a list"));
    EXPECT_THAT(error_of("[1, 2]"), HasSubstr("the preset must be an object"));
}

TEST(Preset, SaysWhichValueIsOutOfRange) {
    EXPECT_EQ(error_with("/exchange/pickup", 1.5),
              "test.json: exchange.pickup is 1.5, outside 0.0 to 1.0.");
    EXPECT_THAT(error_with("/tip/width", -1), HasSubstr("tip.width is -1, outside"));
    EXPECT_THAT(error_with("/tip/bristles", 100000), HasSubstr("tip.bristles is 100000, outside"));
    EXPECT_THAT(error_with("/version", 6), HasSubstr("version is 6"));
}

TEST(Preset, OfVersionThreeNeverRides) {
    EXPECT_EQ(parse_preset(valid_preset().dump(), "test.json").flex.ride, 0.5);
    json three = valid_preset();
    three["version"] = 3;
    EXPECT_THAT(error_of(three.dump()), HasSubstr("flex.ride"));
    three["flex"].erase("ride");
    EXPECT_EQ(parse_preset(three.dump(), "test.json").flex.ride, 0.0);
}

TEST(Preset, OfVersionFourHasTheTeethOfItsTime) {
    const Preset four = parse_preset(valid_preset().dump(), "test.json");
    EXPECT_EQ(four.tip.tooth, 0.6);
    EXPECT_EQ(four.tip.pores_mm, 0.0);
    EXPECT_EQ(four.tip.girth_mm, 0.0);
    EXPECT_EQ(four.paint.coat, 0.0);
    json five = valid_preset();
    five["version"] = 5;
    EXPECT_THAT(error_of(five.dump()), HasSubstr("tip.tooth is missing"));
    EXPECT_THAT(error_with("/tip/girth", 30), HasSubstr("tip.girth is not a field"));
}

TEST(Preset, OfVersionTwoNeverGathersItsHairs) {
    json two = valid_preset();
    two["version"] = 2;
    two["flex"].erase("ride");
    EXPECT_THAT(error_of(two.dump()), HasSubstr("paint.gather"));
    two["paint"].erase("gather");
    EXPECT_EQ(parse_preset(two.dump(), "test.json").paint.gather, 0.0);
    two["version"] = 3;
    EXPECT_THAT(error_of(two.dump()), HasSubstr("paint.gather is missing"));
}

TEST(Preset, SaysWhichChoiceIsUnknown) {
    EXPECT_EQ(error_with("/tip/shape", "broom"),
              "test.json: tip.shape is \"broom\", which is none of: round, flat, filbert, fan, "
              "knife, comb, pad, nib.");
    EXPECT_THAT(error_with("/units/length", "inch"), HasSubstr("units.length is \"inch\""));
    EXPECT_THAT(error_with("/dynamics/0/input", "mood"), HasSubstr("dynamics[0].input is \"mood\""));
}

TEST(Preset, RejectsUnknownFields) {
    EXPECT_EQ(error_with("/paint/flim", 1),
              "test.json: paint.flim is not a field of a brush preset (value 1).");
}

TEST(Preset, ChecksCurves) {
    EXPECT_THAT(error_with("/dynamics/0/curve", json::array()),
                HasSubstr("dynamics[0].curve must have 1 to"));
    EXPECT_THAT(error_with("/dynamics/0/curve/1", json::array({0, 1})),
                HasSubstr("dynamics[0].curve[1] is [0,1], whose input is not above"));
    EXPECT_THAT(error_with("/dynamics/0/curve/1", "high"),
                HasSubstr("must be two numbers, not \"high\""));
    EXPECT_THAT(error_with("/dynamics/0/target", "lean"),
                HasSubstr("dynamics[0].input is \"pressure\", which cannot set \"lean\""));
}

TEST(Preset, SaysWhereTheFileIsNoJson) {
    EXPECT_EQ(error_of("{\n \"version\": 1,\n oops}"), "test.json, line 3: this is not valid JSON.");
    EXPECT_EQ(error_of(std::string(2'000'000, '[')),
              "test.json: lists and objects are nested more than 64 deep.");
    EXPECT_THAT(error_of("{\"version\": 1e999}"), HasSubstr("number that is too large"));
    EXPECT_THAT(error_of(""), HasSubstr("test.json, line 1"));
}

TEST(BundledPresets, AreManyAndOfEveryKind) {
    std::set<std::string> names;
    std::set<TipShape> shapes;
    std::set<ToolKind> kinds;
    for (const Preset& preset : bundled_presets()) {
        EXPECT_TRUE(names.insert(preset.name).second) << preset.name << " is there twice";
        shapes.insert(preset.tip.shape);
        kinds.insert(preset.kind);
    }
    EXPECT_GE(names.size(), 24U);
    EXPECT_EQ(shapes.size(), 8U);
    EXPECT_EQ(kinds.size(), 3U);
}

TEST(BundledPresets, ReadBackAsTheyAreWritten) {
    for (const Preset& preset : bundled_presets())
        EXPECT_EQ(parse_preset(preset_to_json(preset), "again.json"), preset) << preset.name;
}

TEST(BundledPresets, AreFoundByNameOrShape) {
    EXPECT_EQ(find_preset("Impasto flat 18").name, "Impasto flat 18");
    EXPECT_EQ(find_preset("impasto FLAT 18").name, "Impasto flat 18");
    EXPECT_EQ(find_preset("flat").name, "Flat bristle 20");
    EXPECT_EQ(find_preset("Round").name, "Round sable 9");
    EXPECT_EQ(find_preset("filbert").name, "Filbert 14");
    EXPECT_EQ(find_preset("fan").name, "Fan 26");
    EXPECT_EQ(find_preset("knife").name, "Palette knife 17");
}

TEST(BundledPresets, UnknownNameListsThoseThereAre) {
    try {
        find_preset("broom");
        FAIL() << "must throw";
    } catch (const core::InputError& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr("\"broom\""), HasSubstr("\"Round sable 9\""),
                                        HasSubstr("\"Palette knife 17\"")));
    }
}

TEST(PresetFields, AreAllInTheManual) {
    const std::string manual = core::read_text_file(tests::source_file("docs/brush-format.md"));
    for (const PresetField& field : preset_fields()) {
        const std::string row = "| `" + std::string(field.section) + "." + std::string(field.key) +
                                "` | " + std::string(field.unit) + " | ";
        EXPECT_THAT(manual, HasSubstr(row));
        EXPECT_THAT(manual, HasSubstr(std::string(field.meaning)));
    }
}

TEST(PresetFields, DefaultsLieWithinTheirRanges) {
    const Preset preset;
    for (const PresetField& field : preset_fields()) {
        EXPECT_GE(field.get(preset), field.low) << field.section << '.' << field.key;
        EXPECT_LE(field.get(preset), field.high) << field.section << '.' << field.key;
    }
}

const PresetField& field_named(std::string_view section, std::string_view key) {
    const auto fields = preset_fields();
    return *std::find_if(fields.begin(), fields.end(), [&](const PresetField& field) {
        return field.section == section && field.key == key;
    });
}

TEST(WithNumber, WhateverIsAskedForCanBeReadBack) {
    for (const char* name : {"flat", "round", "knife", "spray", "dropper", "straw 8"}) {
        const Preset& preset = find_preset(name);
        for (const PresetField& field : preset_fields()) {
            if (!applies_to(field, preset.kind)) continue;
            for (const double value :
                 {-1e12, field.low, 0.3 * field.low + 0.7 * field.high, field.high, 1e12}) {
                const Preset changed = with_number(preset, field, value);
                EXPECT_EQ(parse_preset(preset_to_json(changed), "changed"), changed)
                    << name << ' ' << field.key << ' ' << value;
            }
        }
    }
}

TEST(WithNumber, ChangesThatNumberAloneAndKeepsItInItsRange) {
    const Preset& flat = find_preset("flat");
    Preset wanted = flat;
    wanted.paint.film_mm = 0.4;
    EXPECT_EQ(with_number(flat, field_named("paint", "film"), 0.4), wanted);
    EXPECT_EQ(with_number(flat, field_named("paint", "film"), 40.0).paint.film_mm, 3.0);
    EXPECT_EQ(with_number(flat, field_named("tip", "bristles"), 99.6).tip.bristles, 100);
}

TEST(WithNumber, APointIsNeverLongerThanTheHairs) {
    Preset preset = find_preset("round");
    preset = with_number(preset, field_named("tip", "point"), 40.0);
    EXPECT_EQ(preset.tip.length_mm, 40.0);
    preset = with_number(preset, field_named("tip", "length"), 12.0);
    EXPECT_EQ(preset.tip.point_mm, 12.0);
}

TEST(WithinRanges, TakesBackWhatAWideTipHasTooMuchOf) {
    for (const Preset& preset : bundled_presets()) {
        EXPECT_EQ(within_ranges(preset), preset) << preset.name;
        const Preset wide = within_ranges(resized(preset, 200.0));
        EXPECT_EQ(wide.tip.width_mm, 200.0);
        const Preset read = parse_preset(preset_to_json(wide), "wide");
        if (preset.kind == ToolKind::Contact) {
            EXPECT_EQ(read, wide) << preset.name;
        }
    }
    EXPECT_EQ(within_ranges(resized(find_preset("rigger"), 200.0)).tip.length_mm, 400.0);
}

TEST(WithNumber, NoMoreDropsFallThanAPictureShows) {
    Preset preset = find_preset("spray");
    preset = with_number(preset, field_named("droplets", "rate"), 10000.0);
    EXPECT_EQ(preset.droplets.rate_mm3_s, 10000.0);
    EXPECT_EQ(preset.droplets.drop_mm3, 0.1);
    preset = with_number(preset, field_named("droplets", "drop"), 1e-3);
    EXPECT_EQ(preset.droplets.rate_mm3_s, 100.0);
}

TEST(Resized, ScalesTheTipInProportion) {
    const Preset small = resized(find_preset("round"), 4.5);
    EXPECT_DOUBLE_EQ(small.tip.width_mm, 4.5);
    EXPECT_DOUBLE_EQ(small.tip.thickness_mm, 4.5);
    EXPECT_DOUBLE_EQ(small.tip.length_mm, 11.5);
    EXPECT_DOUBLE_EQ(small.tip.point_mm, 3.375);
    EXPECT_EQ(small.tip.bristles, 65);
    EXPECT_EQ(resized(find_preset("knife"), 8.5).tip.bristles, 35);
    EXPECT_EQ(resized(find_preset("flat"), 60.0).tip.bristles, 250);
    EXPECT_EQ(resized(find_preset("flat"), 120.0).tip.bristles, 500);
    EXPECT_EQ(resized(find_preset("flat"), 0.5).tip.bristles, 30);
    EXPECT_EQ(resized(find_preset("flat"), 0.0).tip.width_mm, 20.0);
    const Preset roller = resized(find_preset("roller"), 25.0);
    EXPECT_EQ(roller.tip.girth_mm, find_preset("roller").tip.girth_mm);
    EXPECT_EQ(2 * roller.tip.bristles, find_preset("roller").tip.bristles);
}

}  // namespace
}  // namespace pastoso::brush
