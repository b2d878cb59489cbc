// The tools of the pop-up palette keep their places; and how often a device tells of itself.
#include "tools/tool_slots.hpp"

#include "brush/preset.hpp"
#include "core/error.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"
#include "tools/event_rate.hpp"

#include <gmock/gmock.h>

namespace pastoso::tools {
namespace {

TEST(ToolSlots, AreAllThereAtFirst) {
    for (const ToolSlot& slot : first_tool_slots())
        EXPECT_EQ(brush::find_preset(slot.tool).name, slot.tool);
}

TEST(ToolSlots, AToolStaysInItsPlaceAndTheLeastUsedGoes) {
    ToolSlots slots = first_tool_slots();
    for (std::size_t i = 0; i < kToolSlots; ++i)
        note_use(first_tool_slots()[i].tool, slots);
    note_use("Flat bristle 20", slots);
    EXPECT_EQ(slots[0].tool, "Flat bristle 20");
    note_use("Bright 12", slots);
    EXPECT_EQ(slots[1].tool, "Bright 12");
    note_use("Straw 8", slots);
    EXPECT_EQ(slots[2].tool, "Straw 8");
    EXPECT_EQ(slots[0].tool, "Flat bristle 20");
    for (std::size_t i = 3; i < kToolSlots; ++i)
        EXPECT_EQ(slots[i].tool, first_tool_slots()[i].tool);
}

TEST(ToolSlots, WhatWasNeverUsedGoesFirst) {
    ToolSlots slots = first_tool_slots();
    note_use("Spray can 35", slots);
    note_use("Straw 8", slots);
    EXPECT_EQ(slots[8].tool, "Straw 8");
    EXPECT_EQ(slots[9].tool, "Spray can 35");
}

TEST(ToolSlots, ComeBackAsTheyWereWritten) {
    const tests::TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "popup.json";
    EXPECT_EQ(read_tool_slots(file), first_tool_slots());
    ToolSlots slots = first_tool_slots();
    note_use("Straw 8", slots);
    write_tool_slots(slots, file);
    EXPECT_EQ(read_tool_slots(file), slots);
    core::write_text_file(file, R"({"version": 1, "tools": []})");
    try {
        read_tool_slots(file);
        FAIL();
    } catch (const core::InputError& error) {
        EXPECT_EQ(error.what(), file.string() + ", tools: there are 0 tools instead of 10.");
    }
}

TEST(EventRate, CountsTheEventsOfTheLastHalfSecond) {
    EventRate rate;
    EXPECT_EQ(rate.hertz(), 0.0);
    for (std::uint64_t time_ms = 0; time_ms <= 1000; time_ms += 8)
        rate.note(time_ms);
    EXPECT_NEAR(rate.hertz(), 125.0, 0.1);
    for (std::uint64_t time_ms = 1001; time_ms <= 1600; ++time_ms)
        rate.note(time_ms);
    EXPECT_NEAR(rate.hertz(), 1000.0, 0.1);
}

TEST(EventRate, StartsAnewAfterARestAndWhereTheClockRunsBack) {
    EventRate rate;
    rate.note(100);
    rate.note(110);
    EXPECT_NEAR(rate.hertz(), 100.0, 0.1);
    rate.note(5000);
    EXPECT_EQ(rate.hertz(), 0.0);
    rate.note(5005);
    EXPECT_NEAR(rate.hertz(), 200.0, 0.1);
    rate.note(10);
    EXPECT_EQ(rate.hertz(), 0.0);
}

}  // namespace
}  // namespace pastoso::tools
