#include "recordings/recording_json.hpp"

#include "core/random.hpp"
#include "core/text_file.hpp"
#include "document/error_of.hpp"

#include <cmath>
#include <filesystem>
#include <memory>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::recordings {
namespace {

using namespace document;
using testing::HasSubstr;
using testing::Not;

LoadPaint double_load() {
    LoadPaint load;
    load.paint = {{{"PB29", 1.0}, {"PW6", 0.3}, {"PB29", 0.1}, {"#c03020", 0.2}}, 0.7};
    load.second = {{{"PY35", 1.0}}, 1.0};
    load.second_share = 0.4;
    load.share_variation = 0.6;
    load.side_by_side = true;
    load.fill = 0.9;
    return load;
}

LoadPaint plain_load() {
    LoadPaint load;
    load.paint = {{{"PR254", 2.0}}, 1.0};
    return load;
}

film::Medium stiffer_house_paint() {
    film::Medium medium = film::find_medium("house paint");
    medium.yield_stress_Pa = 12.3;
    medium.viscosity_m2_s = 1.0 / 300.0;
    return medium;
}

layers::PressedTexture pressed_texture() {
    auto picture = std::make_shared<pigment::Picture>(
        pigment::Picture{2, 1, {255, 255, 255, 255, 20, 30, 40, 128}});
    return {.place = {-2, 3.5, 30, 15}, .height_mm = 0.75, .dark_raised = true, .picture = picture};
}

/// Every kind of event, strokes interrupted by others and never lifted, ticks that follow from the times
/// and ticks that do not.
Recording everything() {
    Recording recording;
    recording.canvas = {123.4, 56.7, 3.5, "panel", "", 0.1, {true, 3}};
    recording.events = {
        {0, UseMedium{"house paint"}},
        {0, UseMedium{"house paint", stiffer_house_paint()}},
        {0, TiltCanvas{35.5, -45}},
        {0, TakeBrush{"flat", 11.5, 7}},
        {0, double_load()},
        {1, SetDrying{{60, 8, 20, 30.5, 40}}},
        {1, SetDrying{}},
        {2, DryNow{}},
        {2, LoadPaint{}},
        {3, PenDown{{0.05, 1, 2, 0.1, 10, 0, 0}}},
        {3, PenMove{{0.0625, 1.5, 2.25, 0.3, 0, 0, 45}}},
        {4, PenMove{{0.07, 2, 3, 0.5}}},
        {6, PenUp{}},
        {10, plain_load()},
        {10, PenDown{{0.2, 5, 5, 0.5}}},
        {12, TiltCanvas{60, 90}},
        {13, PenMove{{0.25, 6, 5, 0.5, 1.25, -2.5, 0}}},
        {14, Undo{}},
        {15, PenUp{}},
        {16, Redo{}},
        {17, PenDown{{0.3, 5, 5, 0.5}}},
        {18, PenDown{{0.3, 6, 6, 0.5}}},
        {18, PenUp{}},
        {19, CleanBrush{}},
        {19, CleanBrush{0.75}},
        {20, PenMove{{0.4, 6, 6, 0.5}}},
        {21, SetStabiliser{{120, 2.5}}},
        {21, SetStabiliser{}},
        {22, SetGuide{}},
        {22, SetGuide{{brush::StraightLine{}, 5.0, true}}},
        {22, SetGuide{{brush::Ruler{1.5, 2, -3, 4}, 0.0, false}}},
        {22, SetGuide{{brush::EllipseCurve{50, 30, 20.5, 10, 15}, 2.0, true}}},
        {22, SetGuide{{brush::VanishingPoints{1, 50, 30.5}, 5.0, true, 0.75}}},
        {22, SetGuide{{brush::VanishingPoints{3, -50, 30, 400, 0, 0, 900, 2.5, 92.5}}}},
        {22, SetGuide{{brush::Grid{1, 2, 30, 12.5, 150, 0.1}, 0.0, false, 0.0}}},
        {23, SetSymmetry{{60, 28.35, 12.5, true, 8}}},
        {24, SetSymmetry{}},
        {30, SqueezePaint{{{{"PR108", 1.0}, {"PW6", 2.0}}, 0.9}, 320.5, 20, 30.25}},
        {31, PenDown{{0.5, 20, 30, 0.5}, Surface::Well}},
        {32, PenMove{{0.52, 25, 30, 0.5}}},
        {32, TiltCanvas{10, 90}},
        {33, PenMove{{0.54, 30, 30, 0.5}}},
        {33, PenUp{}},
        {34, CleanWell{}},
        {35, AddLayer{"Sky, \"far\""}},
        {35, SelectLayer{1}},
        {36, SetLayer{2, {"Sky", false, true, 0.25}}},
        {36, DuplicateLayer{2}},
        {37, MoveLayer{3, 0, 0}},
        {37, GroupLayers{"Both", {1, 2}}},
        {37, MoveLayer{3, 1, 1}},
        {38, SetGroup{1, {"Both", true, false, 0.5}}},
        {38, MoveGroup{1, 0}},
        {39, UngroupLayers{1}},
        {40, MergeDown{2}},
        {41, ClearLayer{3}},
        {41, RemoveLayer{3}},
        {42, FlattenLayers{}},
        {43, SelectArea{{{1, 2}, {30.5, 2}, {20, 40}}}},
        {43, SelectArea{{{1, 2}, {3, 2}, {2, -4}}, Combination::Subtract}},
        {44, SelectByHeight{0.25, 3, Combination::Intersect}},
        {44, SelectByWetness{0.5, 1000, Combination::Add}},
        {45, ResizeCanvas{-2.5, 3, 120, 90.5}},
        {45, CopyPaint{3}},
        {45, CopyPaint{}},
        {45, BringPaint{std::make_shared<const film::FilmState>(grid::Shape{70, 20}, 0.25)}},
        {45, PastePaint{"Piece", 3.5, -20}},
        {45, TurnCanvas{{true, 2}}},
        {45, TurnCanvas{{false, 1}}},
        {45, ScaleCanvas{1.25, 0.5, 2.5}},
        {45, RotateCanvas{-7.25}},
        {45, RotateCanvas{352, true}},
        {45, InvertSelection{}},
        {45, TransformLayer{2, {10, 12.5, -3, 4, 30, 0.5, -2}}},
        {45, DistortLayer{2, {{10, 12.5}, 30, 20, {12, 11}, {38, 12.5}, {41.25, 34}, {-8, 32}}}},
        {46, SelectPaint{Combination::Add}},
        {46, SelectSimilarColour{10.5, 20, 12.25, false, Combination::Intersect}},
        {46, GrowSelection{2.5}},
        {46, ShrinkSelection{0.75}},
        {46, BorderSelection{1.5}},
        {46, FeatherSelection{4.25}},
        {47, FillWithPaint{{{{"PB29", 1.0}}, 0.5}, 0.35, {{{"PW6", 1.0}}}, {{5, 10}, {40.5, 30}}}},
        {47, FillWithPaint{{{{"PB29", 1.0}}}}},
        {47, ToneGround{{{{"PBr7-RU", 2.0}, {"PW6", 1.0}}}, 0.05, "Ground"}},
        {47, LayTexture{{{{"PW6", 1.0}}}, layers::SandTexture{1.25, 4000000000U}}},
        {47, LayTexture{{{{"PW6", 1.0}}}, layers::KnifedTexture{0.5, 2.5, -30, 7}}},
        {47, LayTexture{{{{"PW6", 1.0}}}, pressed_texture()}},
        {47, AdjustDryPaint{{{{"PB29", 1.0}}, 0.5}, layers::Glaze{0.0375}}},
        {47, AdjustDryPaint{{{{"#c03020", 1.0}}}, layers::PaintExchange{0.375}}},
        {48, SelectAll{}},
        {49, MaskStripe{{{1, 2}, {30.5, -2}, {20, 40}}, 7.5}},
        {49, MaskStripe{{{1, 2}, {3, 2}}, 12, true, true}},
        {49, MaskSelection{}},
        {50, SelectMasked{Combination::Intersect}},
        {50, SetLayer{3, {.name = "Glaze", .bare_locked = true}}},
        {50, SetLayer{3, {.name = "Glaze", .clipped = true}}},
        {50, PeelMasking{}},
    };
    recording.end_tick = 100;
    return recording;
}

std::string error(const std::string& text) {
    return error_of([&] { recording_from_json(text, "s.json"); });
}

/// A file whose only event is given.
std::string file_with(const std::string& event) {
    return R"({"format":"pastoso-strokes","version":1,"canvas":{"width_mm":100,"height_mm":80},"end_tick":900,)"
           R"("events":[)" +
           event + "]}";
}

std::string stroke_error(const std::string& samples) {
    return error(file_with(R"({"tick":0,"stroke":{"samples":)" + samples + "}}"));
}

TEST(RecordingJson, KeepsEverything) {
    const Recording recording = everything();
    EXPECT_EQ(recording_from_json(recording_to_json(recording), "s.json"), recording);
}

TEST(RecordingJson, KeepsEveryBitOfRandomNumbers) {
    Recording recording;
    auto noise = [n = 0U]() mutable {
        n += 2;
        return core::uniform_noise(n, 1) + 1e-9 * core::uniform_noise(n + 1, 1);
    };
    double time_s = 0.0;
    std::int64_t tick = 0;
    for (int i = 0; i < 500; ++i) {
        time_s += 0.01 * noise();
        tick += static_cast<std::int64_t>(2.0 * noise());
        const brush::PenSample sample{time_s,       100 * noise(), 100 * noise(), noise(),
                                      90 * noise(), -90 * noise(), 360 * noise()};
        if (i % 20 == 0)
            recording.events.push_back({tick, PenDown{sample}});
        else
            recording.events.push_back({tick, PenMove{sample}});
        if (i % 20 == 19) recording.events.push_back({tick, PenUp{}});
    }
    recording.end_tick = tick;
    EXPECT_EQ(recording_from_json(recording_to_json(recording), "s.json"), recording);
}

TEST(RecordingJson, ReadsASmallFileWrittenByHand) {
    const Recording recording = recording_from_json(
        file_with(R"({"tick":3,"stroke":{"samples":[[0.1,1,2,0.5],[0.2,3,4,1,5]]}})"), "s.json");
    const std::vector<Event> expected = {
        {6, PenDown{{0.1, 1, 2, 0.5}}}, {12, PenMove{{0.2, 3, 4, 1, 5, 0, 0}}}, {12, PenUp{}}};
    EXPECT_EQ(recording.events, expected);
    EXPECT_EQ(recording.canvas.support, "linen");
    EXPECT_EQ(recording.canvas.px_per_mm, 4.0);
}

TEST(RecordingJson, NamesTheLineOfASyntaxError) {
    EXPECT_THAT(error("{\n\"format\": \"pastoso-strokes\",\n\"version\": }"),
                HasSubstr("s.json, line 3: this is not valid JSON: "));
    EXPECT_THAT(error(""), HasSubstr("s.json, line 1: this is not valid JSON: "));
    EXPECT_THAT(error("{\"format\": 1e999}"), HasSubstr("1e999"));
    EXPECT_THAT(error("{\"format\": NaN}"), HasSubstr("s.json, line 1: this is not valid JSON: "));
}

TEST(RecordingJson, RefusesOtherJson) {
    const std::string sentence =
        "s.json: this is not a stroke recording; it would begin with \"format\": \"pastoso-strokes\".";
    EXPECT_EQ(error("[1, 2]"), sentence);
    EXPECT_EQ(error("{}"), sentence);
    EXPECT_EQ(error("{\"format\": \"other\"}"), sentence);
}

TEST(RecordingJson, ReadsTheFirstVersion) {
    const Recording recording =
        recording_from_json(file_with(R"({"tick":3,"use_medium":{"name":"ink glaze"}})"), "s.json");
    ASSERT_EQ(recording.events.size(), 1U);
    EXPECT_EQ(std::get<UseMedium>(recording.events[0].action).name, "ink glaze");
}

TEST(RecordingJson, MediaOfOnesOwnNeedNameOnlyTheNumbersThatDiffer) {
    const Recording recording = recording_from_json(
        file_with(R"({"tick":3,"use_medium":{"name":"House Paint","numbers":{"yield_stress_Pa":7}}})"),
        "s.json");
    film::Medium expected = film::find_medium("house paint");
    expected.yield_stress_Pa = 7.0;
    EXPECT_EQ(std::get<UseMedium>(recording.events.at(0).action), (UseMedium{"House Paint", expected}));
}

TEST(RecordingJson, NumbersOfAMediumAreLocated) {
    EXPECT_EQ(error(file_with(R"({"tick":3,"use_medium":{"name":"oil","numbers":{}}})"))
                  .find("s.json, events[0].use_medium.name: There is no medium \"oil\""),
              0U);
    EXPECT_EQ(
        error(file_with(R"({"tick":3,"use_medium":{"name":"house paint","numbers":{"slip_cells":7}}})")),
        "s.json, events[0].use_medium.numbers: this paint (\"house paint\"): slip_cells is 7, it "
        "must be a number from 0.0 to 1.0.");
}

TEST(RecordingJson, RefusesNewerVersionsInOneSentence) {
    EXPECT_EQ(
        error(R"({"format":"pastoso-strokes","version":17,"more":[]})"),
        "s.json: this was written by a newer Pastoso (stroke format 17; this program reads up to 16).");
}

TEST(RecordingJson, NamesWhatIsMissingOrMisspelt) {
    EXPECT_EQ(error(R"({"format":"pastoso-strokes","version":1})"),
              "s.json: the entry \"canvas\" is missing.");
    EXPECT_EQ(error(file_with(R"({"tick":0,"take_brush":{"preset":"flat","size":3}})")),
              "s.json, events[0].take_brush: there is no such entry as \"size\" here.");
    EXPECT_THAT(error(file_with(R"({"tick":0,"jump":{}})")),
                HasSubstr("s.json, events[0]: expected one of stroke"));
    EXPECT_EQ(error(file_with(R"({"tick":0,"undo":{},"redo":{}})")),
              "s.json, events[0]: there is no such entry as \"redo\" here.");
}

TEST(RecordingJson, NamesWhatIsOfTheWrongKind) {
    EXPECT_EQ(error(file_with("7")), "s.json, events[0]: expected an object, found 7.");
    EXPECT_EQ(error(file_with(R"({"tick":"now","undo":{}})")),
              "s.json, events[0].tick: expected a whole number, found \"now\".");
    EXPECT_EQ(error(file_with(R"({"tick":0.5,"undo":{}})")),
              "s.json, events[0].tick: expected a whole number, found 0.5.");
    EXPECT_EQ(error(file_with(R"({"tick":0,"stroke":{"samples":{}}})")),
              "s.json, events[0].stroke.samples: expected a list, found an object.");
    EXPECT_EQ(stroke_error(R"([[0,1,"two",0.5]])"),
              "s.json, events[0].stroke.samples[0][2]: expected a number, found \"two\".");
    EXPECT_EQ(stroke_error("[[0,1,null,0.5]]"),
              "s.json, events[0].stroke.samples[0][2]: expected a number, found null.");
}

TEST(RecordingJson, SurvivesDeepNesting) {
    const std::size_t depth = 200'000;
    EXPECT_EQ(error(file_with(std::string(depth, '[') + std::string(depth, ']'))),
              "s.json: lists and objects are nested more than 64 deep.");
}

TEST(RecordingJson, RefusesSamplesOutOfRange) {
    EXPECT_EQ(stroke_error("[[0,1,2,0.5],[0.1,1,2,-0.5]]"),
              "s.json, events[0].stroke.samples[1]: the pressure of the pen is -0.5, but must lie "
              "between 0 and 1.");
    EXPECT_THAT(stroke_error("[[0,1,2,1.01]]"),
                HasSubstr("samples[0]: the pressure of the pen is 1.01"));
    EXPECT_THAT(stroke_error("[[-1,1,2,1]]"), HasSubstr("samples[0]: the time of the pen in s is -1"));
    EXPECT_THAT(stroke_error("[[0,1e9,2,1]]"), HasSubstr("samples[0]: the x of the pen in mm is 1e+09"));
    EXPECT_THAT(stroke_error("[[0,1,2,1,91]]"),
                HasSubstr("samples[0]: the x tilt of the pen in degrees is 91"));
    EXPECT_THAT(stroke_error("[[0,1,2]]"), HasSubstr("samples[0]: a sample has 4 to 8 numbers"));
    EXPECT_THAT(stroke_error("[[0,1,2,1,0,0,0,0,0]]"),
                HasSubstr("samples[0]: a sample has 4 to 8 numbers"));
    EXPECT_THAT(stroke_error("[]"), HasSubstr("stroke.samples: a stroke needs at least one sample."));
}

TEST(RecordingJson, RefusesTimesAndTicksThatRunBackwards) {
    EXPECT_EQ(stroke_error("[[0.5,1,2,0.5],[0.4,1,2,0.5]]"),
              "s.json, events[0].stroke.samples[1]: the time 0.4 s is earlier than 0.5 s before it.");
    EXPECT_EQ(error(file_with(R"({"tick":5,"undo":{}},{"tick":4,"undo":{}})")),
              "s.json, events[1].tick: the tick 4 is earlier than 5 before it.");
    EXPECT_EQ(error(file_with(R"({"tick":1000,"undo":{}})")),
              "s.json, end_tick: the tick 900 is earlier than 1000 before it.");
    EXPECT_EQ(error(file_with(R"({"tick":0,"stroke":{"samples":[[0,1,1,1],[0,1,1,1]],"ticks":[4,3]}})")),
              "s.json, events[0].stroke.ticks[1]: the tick 3 is earlier than 4 before it.");
}

TEST(RecordingJson, RefusesTicksThatDoNotMatchTheSamples) {
    EXPECT_EQ(error(file_with(R"({"tick":0,"stroke":{"samples":[[0,1,1,1]],"ticks":[4,3]}})")),
              "s.json, events[0].stroke.ticks: there are 2 ticks for 1 samples.");
    EXPECT_EQ(error(file_with(R"({"tick":999999999,"undo":{}})")),
              "s.json, events[0].tick: 999999999 is not between 0 and 518400000.");
    EXPECT_THAT(error(file_with(R"({"tick":18446744073709551615,"undo":{}})")),
                HasSubstr("is not between"));
    EXPECT_THAT(error(file_with(R"({"tick":-1,"undo":{}})")), HasSubstr("-1 is not between"));
}

TEST(RecordingJson, RefusesUnknownNamesAndAbsurdValues) {
    EXPECT_THAT(error(file_with(R"({"tick":0,"take_brush":{"preset":"broom"}})")),
                HasSubstr("s.json, events[0].take_brush: "));
    EXPECT_THAT(error(file_with(R"({"tick":0,"load_paint":{"paint":{"mix":[["XX1",1]]}}})")),
                HasSubstr("XX1"));
    EXPECT_THAT(error(file_with(R"({"tick":0,"set_drying":{"speed":-1}})")),
                HasSubstr("the speed of drying is -1"));
    EXPECT_THAT(error(file_with(R"({"tick":0,"set_drying":{"speed":1,"fan":0.5}})")),
                HasSubstr("the strength of the fan is 0.5"));
    EXPECT_THAT(error(file_with(R"({"tick":0,"load_paint":{"paint":{"mix":[["PB29",0]]}}})")),
                HasSubstr("the number of parts of PB29 is 0"));
    EXPECT_THAT(
        error(file_with(R"({"tick":0,"load_paint":{"paint":{"mix":[["PB29",1]],"strength":2}}})")),
        HasSubstr("the strength of the paint is 2"));
    EXPECT_THAT(error(file_with(R"({"tick":0,"load_paint":{"paint":{"mix":["PB29"]}}})")),
                HasSubstr("mix[0]"));
    EXPECT_THAT(error(file_with(R"({"tick":0,"use_medium":{"name":"honey"}})")), HasSubstr("honey"));
    EXPECT_THAT(error(file_with(R"({"tick":0,"tilt_canvas":{"tilt_deg":91}})")),
                HasSubstr("the tilt of the canvas in degrees is 91"));
    EXPECT_THAT(error(file_with(R"({"tick":0,"take_brush":{"preset":"flat","size_mm":-3}})")),
                HasSubstr("the width of the brush in mm is -3"));
}

TEST(RecordingJson, ReadsAidsWrittenByHand) {
    const Recording recording = recording_from_json(
        file_with(
            R"({"tick":0,"set_symmetry":{"centre_x_mm":50,"centre_y_mm":40,"count":6}},)"
            R"({"tick":0,"set_guide":{"form":"ellipse","centre_mm":[1,2],"half_width_mm":3,"half_height_mm":4}},)"
            R"({"tick":0,"set_guide":{"form":"perspective","points":2,"first_mm":[1,2],"second_mm":[3,0]}},)"
            R"({"tick":0,"set_guide":{"form":"none"}},{"tick":0,"set_stabiliser":{"string_mm":3}})"),
        "s.json");
    const std::vector<Event> expected = {
        {0, SetSymmetry{{.centre_x_mm = 50, .centre_y_mm = 40, .count = 6}}},
        {0, SetGuide{{.form = brush::EllipseCurve{1, 2, 3, 4, 0}}}},
        {0, SetGuide{{.form = brush::VanishingPoints{.count = 2, .x1_mm = 1, .y1_mm = 2, .x2_mm = 3}}}},
        {0, SetGuide{}},
        {0, SetStabiliser{{.string_mm = 3}}}};
    EXPECT_EQ(recording.events, expected);
}

TEST(RecordingJson, RefusesBadAids) {
    const auto refused = [](const std::string& event) {
        return error(file_with(R"({"tick":0,)" + event + "}"));
    };
    EXPECT_EQ(refused(R"("set_symmetry":{"centre_x_mm":1,"centre_y_mm":1,"count":0})"),
              "s.json, events[0].set_symmetry.count: 0 is not between 1 and 16.");
    EXPECT_EQ(refused(R"("set_symmetry":{"centre_x_mm":1,"centre_y_mm":1,"count":2.5})"),
              "s.json, events[0].set_symmetry.count: expected a whole number, found 2.5.");
    EXPECT_EQ(refused(R"("set_symmetry":{"centre_y_mm":1})"),
              "s.json, events[0].set_symmetry: the entry \"centre_x_mm\" is missing.");
    EXPECT_EQ(refused(R"("set_symmetry":{"centre_x_mm":null,"centre_y_mm":1})"),
              "s.json, events[0].set_symmetry.centre_x_mm: expected a number, found null.");
    EXPECT_THAT(refused(R"("set_symmetry":{"centre_x_mm":NaN,"centre_y_mm":1})"),
                HasSubstr("s.json, line 1: this is not valid JSON"));
    EXPECT_EQ(refused(R"("set_symmetry":{"centre_x_mm":1e9,"centre_y_mm":1})"),
              "s.json, events[0].set_symmetry: the x of the centre of the symmetry in mm is 1e+09, but "
              "must lie between -20000 and 20000.");
    EXPECT_THAT(refused(R"("set_symmetry":{"centre_x_mm":1,"centre_y_mm":1,"mirror":1})"),
                HasSubstr("set_symmetry.mirror: expected true or false"));
    EXPECT_EQ(refused(R"("set_guide":{"form":"spiral"})"),
              "s.json, events[0].set_guide.form: \"spiral\" is not one of none, line, ruler, ellipse, "
              "perspective, grid.");
    EXPECT_EQ(refused(R"("set_guide":{"form":"line","from_mm":[1,2]})"),
              "s.json, events[0].set_guide: there is no such entry as \"from_mm\" here.");
    EXPECT_EQ(refused(R"("set_guide":{"form":"ruler","from_mm":[1,2],"to_mm":[1]})"),
              "s.json, events[0].set_guide.to_mm: expected two numbers, for example [20, 30].");
    EXPECT_THAT(refused(R"("set_guide":{"form":"ruler","from_mm":[1,2],"to_mm":[1,2]})"),
                HasSubstr("events[0].set_guide: the distance of the ruler's points in mm is 0"));
    EXPECT_THAT(refused(R"("set_stabiliser":{"smoothing_ms":-3})"),
                HasSubstr("events[0].set_stabiliser: the smoothing of the stabiliser in ms is -3"));
    EXPECT_THAT(refused(R"("set_stabiliser":{"string":3})"), HasSubstr("no such entry as \"string\""));
}

TEST(RecordingJson, ReadsTheWellWrittenByHand) {
    const Recording recording = recording_from_json(
        file_with(R"({"tick":0,"squeeze_paint":{"paint":{"mix":[["PY35",1]]},"x_mm":60,"y_mm":45}},)"
                  R"({"tick":0,"stroke":{"surface":"well","samples":[[0,60,45,0.5]]}},)"
                  R"({"tick":0,"stroke":{"surface":"canvas","samples":[[0,1,2,0.5]]}},)"
                  R"({"tick":0,"clean_well":{}})"),
        "s.json");
    const std::vector<Event> expected = {{0, SqueezePaint{{{{"PY35", 1.0}}, 1.0}, 250.0, 60, 45}},
                                         {0, PenDown{{0, 60, 45, 0.5}, Surface::Well}},
                                         {0, PenUp{}},
                                         {0, PenDown{{0, 1, 2, 0.5}, Surface::Canvas}},
                                         {0, PenUp{}},
                                         {0, CleanWell{}}};
    EXPECT_EQ(recording.events, expected);
}

TEST(RecordingJson, RefusesABadWell) {
    const auto refused = [](const std::string& event) {
        return error(file_with(R"({"tick":0,)" + event + "}"));
    };
    EXPECT_EQ(refused(R"("stroke":{"surface":"floor","samples":[[0,1,2,0.5]]})"),
              "s.json, events[0].stroke.surface: there is no surface \"floor\"; a stroke is on the "
              "\"canvas\" or the \"well\".");
    EXPECT_EQ(refused(R"("stroke":{"surface":3,"samples":[[0,1,2,0.5]]})"),
              "s.json, events[0].stroke.surface: expected a text, found 3.");
    EXPECT_EQ(refused(R"("stroke":{"surface":"well","continued":true,"samples":[[0,1,2,0.5]]})"),
              "s.json, events[0].stroke.surface: a stroke that goes on stays on its surface.");
    const auto squeeze = [&](const std::string& rest) {
        return refused(R"("squeeze_paint":{"paint":{"mix":[["PY35",1]]},)" + rest + "}");
    };
    EXPECT_EQ(squeeze(R"("x_mm":10)"),
              "s.json, events[0].squeeze_paint: the entry \"y_mm\" is missing.");
    EXPECT_EQ(squeeze(R"("x_mm":10,"y_mm":91)"),
              "s.json, events[0].squeeze_paint: the y of the squeezed paint in mm is 91, but must lie "
              "between 0 and 90.");
    EXPECT_EQ(squeeze(R"("x_mm":10,"y_mm":10,"volume_mm3":1e6)"),
              "s.json, events[0].squeeze_paint: the volume of the squeezed paint in mm3 is 1e+06, but "
              "must lie between 1 and 5000.");
    EXPECT_EQ(refused(R"("clean_well":{"all":true})"),
              "s.json, events[0].clean_well: there is no such entry as \"all\" here.");
}

TEST(RecordingJson, WithoutTheWellOlderProgramsCanReadIt) {
    Recording recording;
    recording.arithmetic = 1;
    EXPECT_THAT(recording_to_json(recording), HasSubstr("\"version\": 3,"));
    recording.events = {{0, CleanWell{}}};
    EXPECT_THAT(recording_to_json(recording), HasSubstr("\"version\": 4,"));
}

TEST(RecordingJson, KnowsTheArithmeticThatItWasPaintedWith) {
    const std::string now = recording_to_json(Recording{});
    EXPECT_THAT(now, HasSubstr("\"version\": 9,\n\"arithmetic\": 7,"));
    EXPECT_EQ(recording_from_json(now, "s.json").arithmetic, document::kArithmetic);
    EXPECT_EQ(recording_from_json(file_with(R"({"tick":3,"clean_brush":{}})"), "s.json").arithmetic, 1)
        << "that says nothing";
    Recording early;
    early.arithmetic = 1;
    EXPECT_EQ(recording_from_json(recording_to_json(early), "s.json"), early);
    std::string later = now;
    later.replace(later.find("\"arithmetic\": 7"), 15, "\"arithmetic\": 8");
    EXPECT_EQ(error(later), "s.json, arithmetic: 8 is not between 1 and 7.");
}

/// Whichever arithmetic it was painted with.
TEST(RecordingJson, SaysTheVersionOfItsNewestAction) {
    for (const int arithmetic : {1, document::kArithmetic}) {
        Recording recording;
        recording.arithmetic = arithmetic;
        recording.events = {{0, TurnStroke{0.5}}};
        EXPECT_THAT(recording_to_json(recording), HasSubstr("\"version\": 10,")) << arithmetic;
        recording.events.push_back({0, LayBrushAside{}});
        EXPECT_THAT(recording_to_json(recording), HasSubstr("\"version\": 11,")) << arithmetic;
        recording.events = {{0, TurnCanvas{{true, 0}}}};
        EXPECT_THAT(recording_to_json(recording), HasSubstr("\"version\": 12,")) << arithmetic;
        recording.events = {{0, FillWithPaint{}}};
        EXPECT_THAT(recording_to_json(recording), HasSubstr("\"version\": 12,")) << arithmetic;
        recording.events = {{0, ScaleCanvas{2.0, 2.0, 1.0}}};
        EXPECT_THAT(recording_to_json(recording), HasSubstr("\"version\": 13,")) << arithmetic;
        recording.events = {{0, SetLayer{1, {.name = "Paint", .locked = true}}}};
        EXPECT_THAT(recording_to_json(recording), Not(HasSubstr("\"version\": 14,"))) << arithmetic;
        recording.events = {{0, SetLayer{1, {.name = "Paint", .bare_locked = true}}}};
        EXPECT_THAT(recording_to_json(recording), HasSubstr("\"version\": 14,")) << arithmetic;
        recording.events = {{0, SetLayer{1, {.name = "Paint", .clipped = true}}}};
        EXPECT_THAT(recording_to_json(recording), HasSubstr("\"version\": 15,")) << arithmetic;
        recording.events = {{0, PeelMasking{}}};
        EXPECT_THAT(recording_to_json(recording), HasSubstr("\"version\": 14,")) << arithmetic;
        recording.events = {{0, LayTexture{}}};
        EXPECT_THAT(recording_to_json(recording), HasSubstr("\"version\": 14,")) << arithmetic;
        recording.events = {{0, RotateCanvas{7.0}}};
        EXPECT_THAT(recording_to_json(recording), HasSubstr("\"version\": 14,")) << arithmetic;
        recording.events = {{0, DistortLayer{1, {{0, 0}, 2, 2, {0, 0}, {2, 0}, {3, 3}, {0, 2}}}}};
        EXPECT_THAT(recording_to_json(recording), HasSubstr("\"version\": 14,")) << arithmetic;
        recording.events = {{0, SetGuide{{.form = brush::Grid{}}}}};
        EXPECT_THAT(recording_to_json(recording), HasSubstr("\"version\": 14,")) << arithmetic;
        recording.events = {{0, SetGuide{{.strength = 0.5}}}};
        EXPECT_THAT(recording_to_json(recording), HasSubstr("\"version\": 14,")) << arithmetic;
        recording.events = {{0, AdjustDryPaint{}}};
        EXPECT_THAT(recording_to_json(recording), HasSubstr("\"version\": 15,")) << arithmetic;
        recording.events = {{0, FeatherSelection{}}};
        EXPECT_THAT(recording_to_json(recording), HasSubstr("\"version\": 15,")) << arithmetic;
        recording.events = {{0, PenDown{.sample = {}, .beside = true}}};
        EXPECT_THAT(recording_to_json(recording), HasSubstr("\"version\": 15,")) << arithmetic;
        recording.events = {
            {0, BringPaint{std::make_shared<const film::FilmState>(grid::Shape{4, 4}, 0.25)}}};
        EXPECT_THAT(recording_to_json(recording), HasSubstr("\"version\": 16,")) << arithmetic;
    }
}

TEST(RecordingJson, TellsTheWheelWhereItIsTurned) {
    Recording recording;
    recording.events = {
        {0, PenDown{{.pressure = 0.5}}}, {0, PenMove{{.pressure = 0.5, .wheel = -0.25}}}, {0, PenUp{}}};
    recording.arithmetic = document::kArithmetic;
    const std::string text = recording_to_json(recording);
    EXPECT_THAT(text, HasSubstr("\"version\": 13,"));
    EXPECT_THAT(text, HasSubstr("[0.0,0.0,0.0,0.5],[0.0,0.0,0.0,0.5,0.0,0.0,0.0,-0.25]"));
    EXPECT_EQ(recording_from_json(text, "s.json"), recording);
    EXPECT_THAT(stroke_error("[[0,1,2,1,0,0,0,2]]"), HasSubstr("the wheel of the pen is 2"));
}

TEST(RecordingJson, TellsOfAPenThatComesDownBeside) {
    Recording recording;
    recording.events = {{0, PenDown{.sample = {.x_mm = -9.0, .pressure = 0.5}, .beside = true}},
                        {0, CleanBrush{}},
                        {0, PenMove{{.pressure = 0.5}}},
                        {0, PenUp{}},
                        {0, PenDown{{.pressure = 0.5}}},
                        {0, PenUp{}}};
    EXPECT_EQ(recording_from_json(recording_to_json(recording), "s.json"), recording);
    EXPECT_EQ(error(file_with(R"({"tick":0,"stroke":{"samples":[],"continued":true,"beside":true}})")),
              "s.json, events[0].stroke.beside: a stroke that goes on says nothing of where it began.");
}

TEST(RecordingJson, TellsOfTubesThatJoinAStep) {
    Recording recording;
    SqueezePaint squeeze{{{{"PY35", 1.0}}}, 250.0, 60.0, 45.0};
    recording.events = {{0, squeeze}};
    EXPECT_THAT(recording_to_json(recording), Not(HasSubstr("\"version\": 15,")));
    squeeze.joins = true;
    recording.events.push_back({0, squeeze});
    EXPECT_THAT(recording_to_json(recording), HasSubstr("\"version\": 15,"));
    EXPECT_EQ(recording_from_json(recording_to_json(recording), "s.json"), recording);
}

TEST(RecordingJson, SaysThatItsClothWasTurned) {
    Recording recording;
    recording.canvas.support_turn = {false, 3};
    const std::string text = recording_to_json(recording);
    EXPECT_THAT(text, HasSubstr("\"version\": 12,"));
    EXPECT_THAT(text, HasSubstr("\"support_quarter_turns\":3"));
    EXPECT_THAT(text, Not(HasSubstr("support_mirrored")));
    EXPECT_EQ(recording_from_json(text, "s.json"), recording);
    EXPECT_EQ(error(R"({"format":"pastoso-strokes","version":12,"canvas":{"width_mm":9,"height_mm":9,)"
                    R"("support_quarter_turns":4},"end_tick":0,"events":[]})"),
              "s.json, canvas.support_quarter_turns: 4 is not between 0 and 3.");
}

TEST(RecordingJson, SaysHowItsClothWasTurnedAndDrawnOut) {
    Recording recording;
    recording.canvas.support_map = {1.25, -0.5, 0.75, 1.0 / 3.0};
    recording.canvas.support_x_mm = 1.0 / 3.0;
    const std::string text = recording_to_json(recording);
    EXPECT_THAT(text, HasSubstr("\"version\": 15,"));
    EXPECT_EQ(recording_from_json(text, "s.json"), recording);
    const auto error_of_map = [](const std::string& map) {
        return error(R"({"format":"pastoso-strokes","version":15,"canvas":{"width_mm":9,"height_mm":9,)"
                     R"("support_map":)" +
                     map + R"(},"end_tick":0,"events":[]})");
    };
    EXPECT_EQ(error_of_map("[1, 0, 0]"), "s.json, canvas.support_map: a map has 4 numbers; here are 3.");
    EXPECT_EQ(error_of_map("[1, 0, 0, 401]"),
              "s.json, canvas: The width of the cloth's threads of the canvas is 40100 %, but must lie "
              "between 0.25 and 40000.");
    EXPECT_EQ(error_of_map("[1, 2, 1, 2]"),
              "s.json, canvas: The width of the cloth's threads of the canvas is 0 %, but must lie "
              "between 0.25 and 40000.");
}

TEST(RecordingJson, ReadsTheAngleOfACloth) {
    const Recording recording = recording_from_json(
        R"({"format":"pastoso-strokes","version":14,"canvas":{"width_mm":9,"height_mm":9,)"
        R"("support_askew_deg":-30},"end_tick":0,"events":[]})",
        "s.json");
    EXPECT_NEAR(recording.canvas.support_map.xx, std::sqrt(0.75), 1e-15);
    EXPECT_NEAR(recording.canvas.support_map.xy, 0.5, 1e-15);
    EXPECT_NEAR(recording.canvas.support_map.yx, -0.5, 1e-15);
}

TEST(RecordingJson, RefusesAbsurdCanvases) {
    const auto canvas_error = [](const std::string& canvas) {
        return error(R"({"format":"pastoso-strokes","version":1,"canvas":)" + canvas +
                     R"(,"end_tick":0,"events":[]})");
    };
    EXPECT_EQ(canvas_error(R"({"width_mm":-5,"height_mm":10})"),
              "s.json, canvas: The width of the canvas is -5 mm, but must lie between 1 and 5000.");
    EXPECT_THAT(canvas_error(R"({"width_mm":1e30,"height_mm":10})"), HasSubstr("1e+30"));
    EXPECT_THAT(canvas_error(R"({"width_mm":4000,"height_mm":4000,"px_per_mm":60})"),
                HasSubstr("at most 32768 a side"));
}

TEST(RecordingJson, TakesTheHeightImageFromTheRecordingsFolder) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("pastoso-json-" + std::to_string(::getpid()));
    std::filesystem::create_directory(folder);
    Recording recording;
    recording.canvas.support = "image";
    recording.canvas.support_image = "relief.png";
    write_recording_json(folder / "s.json", recording);
    EXPECT_EQ(read_recording_json(folder / "s.json").canvas.support_image,
              (folder / "relief.png").string());
    recording.canvas.support_image = "/somewhere/relief.png";
    write_recording_json(folder / "s.json", recording);
    EXPECT_EQ(read_recording_json(folder / "s.json").canvas.support_image, "/somewhere/relief.png");
    std::filesystem::remove_all(folder);
}

TEST(RecordingJson, NamesMissingFiles) {
    EXPECT_EQ(error_of([] { read_recording_json("/nonexistent/s.json"); }),
              "/nonexistent/s.json: cannot be opened (No such file or directory).");
}

}  // namespace
}  // namespace pastoso::recordings
