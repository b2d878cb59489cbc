// The mark that shows a tool best.
#include "document/tool_sample.hpp"

#include "core/thread_pool.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace pastoso::document {
namespace {

constexpr SampleBoard::Size kSize{.width_mm = 80.0, .width_px = 120, .height_px = 40};

pigment::Image8 sample(const brush::Preset& preset, const SampleBoard::Size& size = kSize,
                       const std::function<bool()>& cancelled = {}) {
    core::ThreadPool pool(1);
    return tool_sample(preset, mark_of(preset), size, pool, cancelled);
}

/// Of all channels.
double mean(const pigment::Image8& image) {
    double sum = 0.0;
    for (const auto value : image.rgb)
        sum += value;
    return sum / static_cast<double>(image.rgb.size());
}

TEST(ToolSample, ShowsWhatAToolIsTakenFor) {
    const std::pair<const char*, ToolMark> kMarks[] = {
        {"flat", ToolMark::Wave},        {"knife", ToolMark::OverWet},
        {"rag", ToolMark::OverWet},      {"Dry scumbler 22", ToolMark::OverDry},
        {"Stippler 15", ToolMark::Dabs}, {"rigger", ToolMark::Lines},
        {"dropper", ToolMark::Drops},    {"spray", ToolMark::Stream},
        {"blow", ToolMark::Blow}};
    for (const auto& [name, mark] : kMarks)
        EXPECT_EQ(mark_of(brush::find_preset(name)), mark) << name;
}

TEST(ToolSample, IsSeenOnABoardThatHoldsItsMark) {
    EXPECT_DOUBLE_EQ(sample_width_mm(20.0, 300, 100), 96.0);  // 1.6 marks high
    EXPECT_DOUBLE_EQ(sample_width_mm(20.0, 100, 100), 80.0);  // 4 marks wide
    EXPECT_DOUBLE_EQ(sample_width_mm(1.0, 300, 100), 19.2);   // 6.4 mm high
    EXPECT_EQ(mark_width_mm(brush::find_preset("flat")), 20.0);
    // A cap of 25 mm3 that is 0.35 radii high.
    EXPECT_NEAR(mark_width_mm(brush::find_preset("dropper")), 2.0 * 3.569, 1e-3);
}

TEST(ToolSample, OnCoarserCellsIsTheSamePictureRoughly) {
    SampleBoard::Size coarse = kSize;
    coarse.cell_px = 2.0;
    for (const char* name : {"flat", "Scraper 30", "Spreading knife 40", "Fine comb 18"}) {
        const pigment::Image8 fine = sample(brush::find_preset(name));
        const pigment::Image8 rough = sample(brush::find_preset(name), coarse);
        EXPECT_EQ(rough.width, fine.width);
        EXPECT_EQ(rough.height, fine.height);
        EXPECT_NE(rough.rgb, fine.rgb) << name;
        // The outermost hairs cover other cells: of 40 rows of pixels two more or less.
        EXPECT_NEAR(mean(rough), mean(fine), 6.0) << name;
    }
}

TEST(ToolSample, ABandCoversWhatItIsSaidTo) {
    core::ThreadPool pool(1);
    SampleBoard board({.width_mm = 60.0, .width_px = 240, .height_px = 80}, "panel", pool);
    lay_band(board, 0.3, 0.1, tinted("PR108"));
    const pigment::Image8 image = board.picture();
    const auto is_red = [&](int column, int row) {
        const std::uint8_t* rgb = &image.rgb[static_cast<std::size_t>(3 * (row * image.width + column))];
        return rgb[0] > 2 * rgb[1];
    };
    // 24 rows about the 24th, from column 14.4 to 225.6.
    for (const int column : {20, 120, 220})
        EXPECT_TRUE(is_red(column, 24)) << column;
    for (const int row : {14, 34})
        EXPECT_TRUE(is_red(120, row)) << row;
    for (const int row : {10, 38, 70})
        EXPECT_FALSE(is_red(120, row)) << row;
    for (const int column : {10, 230})
        EXPECT_FALSE(is_red(column, 24)) << column;
    EXPECT_FALSE(is_red(16, 14)) << "its ends are round";
}

/// The coarsest cells that the strip of the brush editor is painted with.
TEST(ToolSample, AStrawPartsAPuddleOnCoarseCellsToo) {
    const brush::Preset& straw = brush::find_preset("Straw 8");
    const SampleBoard::Size coarse{.width_mm = sample_width_mm(mark_width_mm(straw), 600, 108),
                                   .width_px = 600,
                                   .height_px = 108,
                                   .cell_px = 8.0};
    const pigment::Image8 image = sample(straw, coarse);
    const auto red_at = [&](double x) {
        const int column = static_cast<int>(x * image.width), row = image.height / 2;
        return int{image.rgb[static_cast<std::size_t>(3 * (row * image.width + column))]};
    };
    // Blue paint has next to no red; what is left of it where the air went lets the board through.
    EXPECT_GT(red_at(0.42), red_at(0.85) + 80);
}

TEST(ToolSample, IsGivenUpWhenItIsAskedTo) {
    EXPECT_TRUE(sample(brush::find_preset("flat"), kSize, [] { return true; }).rgb.empty());
    int asked = 0;
    EXPECT_TRUE(sample(brush::find_preset("flat"), kSize, [&] { return ++asked > 5; }).rgb.empty());
    EXPECT_LT(asked, 20) << "soon";
    EXPECT_FALSE(sample(brush::find_preset("flat"), kSize, [] { return false; }).rgb.empty());
}

}  // namespace
}  // namespace pastoso::document
