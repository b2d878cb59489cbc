#include "recordings/recording_text.hpp"

#include "document/error_of.hpp"

#include <gtest/gtest.h>

namespace pastoso::recordings {
namespace {

using document::error_of;

PenTrace parse(const char* text) {
    return parse_pen_trace(text, "pen.dat");
}
std::string parse_error(const char* text) {
    return error_of([&] { parse(text); });
}

TEST(RecordingText, SplitsStrokesWhereThePenIsInTheAir) {
    const PenTrace trace = parse("0 1 2 0\n0.1 3 4 0.5\n0.2 5 6 0.25\n0.3 7 8 0\n0.4 9 10 1\n");
    ASSERT_EQ(trace.strokes.size(), 2U);
    ASSERT_EQ(trace.strokes[0].size(), 2U);
    EXPECT_EQ(trace.strokes[0][0], (brush::PenSample{0.1, 3, 4, 0.5}));
    EXPECT_EQ(trace.strokes[0][1], (brush::PenSample{0.2, 5, 6, 0.25}));
    ASSERT_EQ(trace.strokes[1].size(), 1U);
    EXPECT_EQ(trace.strokes[1][0], (brush::PenSample{0.4, 9, 10, 1}));
}

TEST(RecordingText, SkipsCommentsAndBlanksInAllLineEndings) {
    const PenTrace trace = parse("# a pen\r\n\r\n  \t 0\t1  2 +0.5 # down\r\n1e0 1 2 .5");
    ASSERT_EQ(trace.strokes.size(), 1U);
    EXPECT_EQ(trace.strokes[0].size(), 2U);
}

TEST(RecordingText, NamesLineAndValueOfText) {
    EXPECT_EQ(parse_error("0 1 2 0.5\n0.1 one 2 0.5\n"),
              "pen.dat, line 2: the x \"one\" is not a number.");
}

TEST(RecordingText, CountsCommentLines) {
    EXPECT_EQ(parse_error("# first\n\n0 1 2 x\n"),
              "pen.dat, line 3: the pressure \"x\" is not a number.");
}

TEST(RecordingText, RefusesNumbersWithATail) {
    EXPECT_EQ(parse_error("0 1,5 2 0.5\n"), "pen.dat, line 1: the x \"1,5\" is not a number.");
    EXPECT_EQ(parse_error("0 1 0x10 0.5\n"), "pen.dat, line 1: the y \"0x10\" is not a number.");
}

TEST(RecordingText, RefusesWhatIsNotFinite) {
    EXPECT_EQ(parse_error("0 nan 2 0.5\n"),
              "pen.dat, line 1: the x \"nan\" is not between -1e7 and 1e7.");
    EXPECT_EQ(parse_error("inf 1 2 0.5\n"),
              "pen.dat, line 1: the time \"inf\" is not between -1e7 and 1e7.");
    EXPECT_EQ(parse_error("0 1 1e8 0.5\n"),
              "pen.dat, line 1: the y \"1e8\" is not between -1e7 and 1e7.");
    EXPECT_EQ(parse_error("0 1 1e999 0.5\n"), "pen.dat, line 1: the y \"1e999\" is not a number.");
}

TEST(RecordingText, RefusesPressuresOutOfRange) {
    EXPECT_EQ(parse_error("0 1 2 -0.1\n"), "pen.dat, line 1: the pressure -0.1 is not between 0 and 1.");
    EXPECT_EQ(parse_error("0 1 2 1.5\n"), "pen.dat, line 1: the pressure 1.5 is not between 0 and 1.");
}

TEST(RecordingText, RefusesTimesThatRunBackwards) {
    EXPECT_EQ(parse_error("0.5 1 2 0\n0.4 1 2 0.5\n"),
              "pen.dat, line 2: the time 0.4 s is earlier than 0.5 s before it.");
    EXPECT_EQ(parse_error("-1 1 2 0.5\n"),
              "pen.dat, line 1: the time -1 s is not between 0 and 86400 s.");
    EXPECT_EQ(parse_error("90000 1 2 0.5\n"),
              "pen.dat, line 1: the time 90000 s is not between 0 and 86400 s.");
}

TEST(RecordingText, RefusesWrongNumbersOfColumns) {
    EXPECT_EQ(parse_error("0 1 2\n"),
              "pen.dat, line 1: expected 4 numbers, seconds x y pressure, found 3.");
    EXPECT_EQ(parse_error("0 1 2 0.5 9\n"),
              "pen.dat, line 1: expected 4 numbers, seconds x y pressure, found 5.");
}

TEST(RecordingText, RefusesFilesWithoutAStroke) {
    const std::string nothing =
        "pen.dat: holds no stroke; expected lines \"seconds x y pressure\", some with a "
        "pressure above 0.";
    EXPECT_EQ(parse_error(""), nothing);
    EXPECT_EQ(parse_error("# nothing\n"), nothing);
    EXPECT_EQ(parse_error("0 1 2 0\n"), nothing);
}

TEST(RecordingText, ShowsBytesThatAreNoTextAsQuestionMarks) {
    EXPECT_EQ(parse_error("\x01\xff 1 2 3\n"), "pen.dat, line 1: the time \"??\" is not a number.");
}

TEST(RecordingText, FitKeepsTheAspectAndCentres) {
    const PenTrace trace = parse("0 100 100 0.5\n1 300 200 0.5\n");
    const PenTrace wide = fitted(trace, 120, 100, 10);
    EXPECT_DOUBLE_EQ(wide.strokes[0][0].x_mm, 10);
    EXPECT_DOUBLE_EQ(wide.strokes[0][1].x_mm, 110);
    EXPECT_DOUBLE_EQ(wide.strokes[0][0].y_mm, 25);
    EXPECT_DOUBLE_EQ(wide.strokes[0][1].y_mm, 75);
}

TEST(RecordingText, FitPutsAPointIntoTheMiddle) {
    const PenTrace point = fitted(parse("0 7 9 0.5\n"), 40, 20, 5);
    EXPECT_DOUBLE_EQ(point.strokes[0][0].x_mm, 20);
    EXPECT_DOUBLE_EQ(point.strokes[0][0].y_mm, 10);
}

TEST(RecordingText, FitScalesALineByItsOnlyExtent) {
    const PenTrace line = fitted(parse("0 7 0 0.5\n1 7 50 0.5\n"), 40, 30, 5);
    EXPECT_DOUBLE_EQ(line.strokes[0][0].y_mm, 5);
    EXPECT_DOUBLE_EQ(line.strokes[0][1].y_mm, 25);
    EXPECT_DOUBLE_EQ(line.strokes[0][1].x_mm, 20);
}

TEST(RecordingText, TellsWhetherAnythingLiesOnTheCanvas) {
    const PenTrace trace = parse("0 500 10 0.5\n1 90 10 0.5\n");
    EXPECT_TRUE(touches_canvas(trace, 100, 20));
    EXPECT_FALSE(touches_canvas(trace, 80, 20));
}

TEST(RecordingText, LoadsTheBrushAfreshForEveryStrokeAndTakesPaintsInTurn) {
    const PenTrace trace = parse("0 1 1 .5\n.1 2 1 .5\n.2 2 1 0\n1 1 2 .5\n1.5 1 2 0\n2 1 3 .5\n");
    TraceSetup setup;
    setup.medium = "house paint";
    setup.tilt = {60, 90};
    setup.brush = {"flat", 12, 3};
    setup.paints = {{{{"PB29", 1}}, 1}, {{{"PY35", 1}}, 1}};
    setup.seconds_after = 1;
    const document::Recording recording = recording_from_trace(trace, setup);

    using namespace document;
    const auto load = [&](int paint) {
        LoadPaint action;
        action.paint = setup.paints[static_cast<std::size_t>(paint)];
        return action;
    };
    const std::vector<Event> expected = {
        {0, UseMedium{"house paint"}},
        {0, setup.tilt},
        {0, setup.brush},
        {0, CleanBrush{}},
        {0, load(0)},
        {0, PenDown{trace.strokes[0][0]}},
        {6, PenMove{trace.strokes[0][1]}},
        {6, PenUp{}},
        {60, CleanBrush{}},
        {60, load(1)},
        {60, PenDown{trace.strokes[1][0]}},
        {60, PenUp{}},
        {120, CleanBrush{}},
        {120, load(0)},
        {120, PenDown{trace.strokes[2][0]}},
        {120, PenUp{}},
    };
    EXPECT_EQ(recording.events, expected);
    EXPECT_EQ(recording.end_tick, 180);
}

}  // namespace
}  // namespace pastoso::recordings
