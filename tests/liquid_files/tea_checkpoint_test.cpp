#include "liquid_files/tea_checkpoint.hpp"

#include "core/text_file.hpp"
#include "document/error_of.hpp"
#include "files/temporary_folder.hpp"
#include "liquid/tea/milk_tea.hpp"
#include "source_file.hpp"

#include <cstring>
#include <fstream>
#include <limits>

#include <gmock/gmock.h>

namespace pastoso::liquid_files {
namespace {

using document::error_of;
using liquid::TeaState;
using testing::HasSubstr;

constexpr std::uint64_t kScene = 0x123456789abcdef0U;

/// Of a glass that a hand pours into and a ball has formed in.
TeaState state_after(int steps) {
    core::ThreadPool pool(2);
    liquid::TeaSettings settings;
    settings.cells = 12;
    settings.parcels = 300;
    settings.pour_s = 0.3;
    settings.first_ball_s = 0.2;
    liquid::MilkTea tea(settings);
    if (steps > 0) tea.pour_by_hand(glm::vec2(0.04F, 0.05F));
    for (int i = 0; i < steps; ++i)
        tea.step(pool);
    return tea.state();
}

class TeaCheckpointTest : public files::TemporaryFolder {
  protected:
    std::filesystem::path file() const { return tea_checkpoint_path(folder); }
    std::string written(const TeaState& state) const {
        write_tea_checkpoint(file(), state, kScene);
        return core::read_text_file(file());
    }
    std::string complaint(const std::string& bytes) const {
        // Not flushed to the disk: there are hundreds.
        std::ofstream(file(), std::ios::binary) << bytes;
        return error_of([&] { read_tea_checkpoint(file(), kScene); });
    }
};

TEST_F(TeaCheckpointTest, StatesComeBackToTheLastBit) {
    for (const int steps : {0, 1, 12}) {
        const TeaState state = state_after(steps);
        ASSERT_EQ(state.balls.count > 0, steps == 12);
        written(state);
        EXPECT_EQ(read_tea_checkpoint(file(), kScene), state) << steps;
    }
    EXPECT_EQ(file(), folder / "checkpoint.tea");
}

TEST_F(TeaCheckpointTest, TheHeadIsAsDocumented) {
    const TeaState state = state_after(12);
    const std::string head = written(state).substr(0, 264);
    EXPECT_EQ(head.substr(0, 16), std::string("TeaState\3\0\0\0\1\0\0\0", 16));
    EXPECT_EQ(head.substr(16, 8), "\xf0\xde\xbc\x9a\x78\x56\x34\x12");
    EXPECT_EQ(head[24], 12);
    EXPECT_EQ(head.substr(32, 12), std::string("\xc\0\0\0\xc\0\0\0\xc\0\0\0", 12));
    const auto number_at = [&](std::size_t at) {
        std::uint64_t number = 0;
        std::memcpy(&number, head.data() + at, sizeof number);
        return number;
    };
    EXPECT_EQ(number_at(48), state.parcels.size());
    EXPECT_EQ(number_at(56), 2U);
    EXPECT_EQ(number_at(128), state.jug.places);
    std::uint64_t parts = 0;
    for (std::size_t part = 0; part < 12; ++part)
        parts += number_at(160 + 8 * part);
    EXPECT_EQ(264 + parts, std::filesystem::file_size(file()));
}

/// Of the run that tea_cache_test.cpp has a frame of.
TEST_F(TeaCheckpointTest, OnesOfVersion1GoOnWithRoundParcels) {
    const std::filesystem::path path = tests::source_file("tests/data/liquid/checkpoint-version-1.tea");
    std::uint64_t scene = 0;
    std::memcpy(&scene, core::read_text_file(path).data() + 16, sizeof scene);
    liquid::TeaSettings settings;
    settings.cells = 8;
    settings.parcels = 40;
    settings.pour_s = 0.2;
    liquid::MilkTea tea(settings);
    tea.set_state(read_tea_checkpoint(path, scene));
    ASSERT_EQ(tea.parcels().size(), 40U);
    EXPECT_EQ(tea.parcels()[7].shape, liquid::ParcelShape());
    core::ThreadPool pool(1);
    tea.step(pool);
    EXPECT_EQ(tea.steps(), 10);
    EXPECT_NE(tea.parcels()[7].shape, liquid::ParcelShape());
}

TEST_F(TeaCheckpointTest, EveryDamageIsNoticed) {
    const std::string whole = written(state_after(3));
    for (std::size_t at = 0; at < whole.size(); at += at < 264 ? 1 : 97) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
        EXPECT_THAT(complaint(damaged), HasSubstr("checkpoint.tea: is ")) << at;
    }
    for (std::size_t size = 0; size < whole.size(); size += size < 264 ? 9 : 997)
        EXPECT_THAT(complaint(whole.substr(0, size)), HasSubstr("checkpoint.tea: is ")) << size;
}

TEST_F(TeaCheckpointTest, SaysWhatAFileIsInstead) {
    const std::string whole = written(state_after(1));
    EXPECT_THAT(error_of([&] { read_tea_checkpoint(file(), 1); }),
                HasSubstr("checkpoint.tea: belongs to another scene."));
    EXPECT_THAT(complaint("PastoTea"), HasSubstr("checkpoint.tea: is no checkpoint of tea."));
    EXPECT_THAT(error_of([&] { read_tea_checkpoint(folder / "none.tea", kScene); }),
                HasSubstr("none.tea: cannot be opened"));
}

TEST_F(TeaCheckpointTest, WhatIsNotFiniteIsRefused) {
    TeaState state = state_after(3);
    state.flow.velocity.z.at(5, 5, 5) = std::numeric_limits<float>::infinity();
    EXPECT_THAT(complaint(written(state)), HasSubstr("holds a value of a cell that is not finite"));
    state = state_after(3);
    state.parcels[1].coldness = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(complaint(written(state)), HasSubstr("holds a parcel (number 1)"));
}

}  // namespace
}  // namespace pastoso::liquid_files
