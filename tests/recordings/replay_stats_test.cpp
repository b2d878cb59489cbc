#include "recordings/replay_stats.hpp"

#include "core/memory.hpp"

#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace pastoso::recordings {
namespace {

TEST(ReplayStats, IsOneFlatObjectOfExactlyTheseEntries) {
    ReplayStats stats;
    stats.film.steps = 7;
    stats.account.taken.volume_mm3 = 2.0;
    stats.account.canvas.volume_mm3 = 1.5;
    stats.state_hash = 0x1234;
    stats.version = "1.2.3";
    const auto json = nlohmann::json::parse(stats_json(stats));
    std::set<std::string> keys;
    for (const auto& item : json.items()) {
        keys.insert(item.key());
        EXPECT_TRUE(item.value().is_primitive()) << item.key();
    }
    const std::set<std::string> expected = {"wall_s",
                                            "brush_s",
                                            "film_s",
                                            "shade_s",
                                            "io_s",
                                            "steps",
                                            "cells_stepped",
                                            "wet_cells",
                                            "volume_in_mm3",
                                            "volume_canvas_mm3",
                                            "volume_dried_mm3",
                                            "volume_brush_mm3",
                                            "volume_well_mm3",
                                            "volume_ledger_mm3",
                                            "volume_error_rel",
                                            "pigment_error_rel",
                                            "clamped_faces",
                                            "state_hash",
                                            "image_hash",
                                            "peak_rss_mib",
                                            "threads",
                                            "version"};
    EXPECT_EQ(keys, expected);
    EXPECT_EQ(json["steps"], 7);
    EXPECT_EQ(json["volume_error_rel"], 0.25);
    EXPECT_EQ(json["state_hash"], "0000000000001234");
    EXPECT_EQ(json["version"], "1.2.3");
}

TEST(ReplayStats, MeasuresThePeakOfMemory) {
    EXPECT_GT(core::peak_rss_mib(), 1.0);
}

}  // namespace
}  // namespace pastoso::recordings
