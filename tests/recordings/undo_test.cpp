// Undo of a real painting session, with the budget that painters get.
#include "core/resources.hpp"
#include "recordings/canvas_support.hpp"
#include "recordings/recording_json.hpp"

#include <variant>
#include <vector>

#include <gtest/gtest.h>

namespace pastoso::recordings {
namespace {

TEST(Undo, TakesBackMoreThanAHundredStrokesOfARecording) {
    constexpr std::size_t kStrokes = 120;
    const document::Recording recording =
        read_recording_json(core::resource_path("strokes/still-life.json"));
    core::ThreadPool pool;
    const auto painting = make_painting(recording.canvas, pool);
    std::vector<std::uint64_t> before;
    for (const document::Event& event : recording.events) {
        while (painting->tick() < event.tick)
            painting->advance_tick();
        if (std::holds_alternative<document::PenDown>(event.action)) {
            if (before.size() == kStrokes) break;
            before.push_back(painting->state_hash());
        }
        ASSERT_FALSE(std::holds_alternative<document::Undo>(event.action));
        painting->apply(event.action);
    }
    ASSERT_EQ(before.size(), kStrokes);
    for (std::size_t i = kStrokes; i-- > 0;) {
        ASSERT_TRUE(painting->can_undo()) << "after " << kStrokes - i - 1 << " steps";
        painting->apply(document::Undo{});
        ASSERT_EQ(painting->state_hash(), before[i]) << "stroke " << i;
    }
}

}  // namespace
}  // namespace pastoso::recordings
