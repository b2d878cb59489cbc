#include "liquid_files/tank_checkpoint.hpp"

#include "core/text_file.hpp"
#include "document/error_of.hpp"
#include "files/temporary_folder.hpp"
#include "tank/liquid_tank.hpp"

#include <cstring>
#include <fstream>
#include <limits>

#include <gmock/gmock.h>

namespace pastoso::liquid_files {
namespace {

using document::error_of;
using tank::Method;
using testing::HasSubstr;

constexpr std::uint64_t kScene = 0x123456789abcdef0U;

/// Of a dam that breaks.
TankCheckpoint checkpoint_after(int steps, Method method = Method::Particles) {
    core::ThreadPool pool(2);
    tank::TankScene scene;
    scene.cells = {8, 9, 10};
    scene.method = method;
    scene.liquids = {{{tank::Block{glm::vec3(-1.0F), {0.02F, 1.0F, 0.03F}}}, glm::vec3(0.0F), 0.5F}};
    tank::LiquidTank tank(scene);
    for (int step = 0; step < steps; ++step)
        tank.step(1.0, pool);
    TankSeriesRow row;
    row.time_s = tank.time_s();
    row.steps = steps;
    return {tank.state(), {TankSeriesRow{}, row}};
}

class TankCheckpointTest : public files::TemporaryFolder {
  protected:
    std::filesystem::path file() const { return tank_checkpoint_path(folder); }
    std::string written(const TankCheckpoint& checkpoint) const {
        write_tank_checkpoint(file(), checkpoint, kScene);
        return core::read_text_file(file());
    }
    std::string complaint(const std::string& bytes) const {
        // Not flushed to the disk: there are hundreds.
        std::ofstream(file(), std::ios::binary) << bytes;
        return error_of([&] { read_tank_checkpoint(file(), kScene); });
    }
};

TEST_F(TankCheckpointTest, StatesOfEveryMethodComeBackToTheLastBit) {
    for (const Method method : {Method::Particles, Method::LevelSet, Method::ParticleLevelSet})
        for (const int steps : {0, 6}) {
            const TankCheckpoint checkpoint = checkpoint_after(steps, method);
            written(checkpoint);
            EXPECT_EQ(read_tank_checkpoint(file(), kScene), checkpoint) << steps;
        }
    EXPECT_EQ(file(), folder / "checkpoint.tank");
}

TEST_F(TankCheckpointTest, TheHeadIsAsDocumented) {
    const TankCheckpoint checkpoint = checkpoint_after(6, Method::ParticleLevelSet);
    const std::string head = written(checkpoint).substr(0, 208);
    EXPECT_EQ(head.substr(0, 16), std::string("TankStat\2\0\0\0\3\0\0\0", 16));
    EXPECT_EQ(head.substr(16, 8), "\xf0\xde\xbc\x9a\x78\x56\x34\x12");
    EXPECT_EQ(head[32], 6);
    EXPECT_EQ(head.substr(48, 12), std::string("\x8\0\0\0\x9\0\0\0\xa\0\0\0", 12));
    const auto number_at = [&](std::size_t at) {
        std::uint64_t number = 0;
        std::memcpy(&number, head.data() + at, sizeof number);
        return number;
    };
    const tank::LevelState& level = *checkpoint.state.liquid.level;
    EXPECT_EQ(number_at(64), 0U);
    EXPECT_EQ(number_at(72), level.particles->positions_m.size());
    EXPECT_EQ(number_at(80), 2U);
    EXPECT_EQ(number_at(104), static_cast<std::uint64_t>(level.steps));
    std::uint64_t parts = 0;
    for (std::size_t part = 0; part < 10; ++part)
        parts += number_at(120 + 8 * part);
    EXPECT_EQ(208 + parts, std::filesystem::file_size(file()));
}

TEST_F(TankCheckpointTest, EveryDamageIsNoticed) {
    const std::string whole = written(checkpoint_after(3));
    for (std::size_t at = 0; at < whole.size(); at += at < 216 ? 1 : 97) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
        EXPECT_THAT(complaint(damaged), HasSubstr("checkpoint.tank: ")) << at;
    }
    for (std::size_t size = 0; size < whole.size(); size += size < 216 ? 9 : 997)
        EXPECT_THAT(complaint(whole.substr(0, size)), HasSubstr("checkpoint.tank: is ")) << size;
    EXPECT_THAT(complaint("PastoTea"), HasSubstr("checkpoint.tank: is no checkpoint of a tank."));
}

TEST_F(TankCheckpointTest, WhatIsNotFiniteOrOfAnotherSceneIsRefused) {
    TankCheckpoint checkpoint = checkpoint_after(2);
    written(checkpoint);
    EXPECT_THAT(error_of([&] { read_tank_checkpoint(file(), 1); }),
                HasSubstr("checkpoint.tank: belongs to another scene."));
    checkpoint.state.liquid.particles[1].velocity_m_s.y = std::numeric_limits<float>::infinity();
    EXPECT_THAT(complaint(written(checkpoint)), HasSubstr("holds a particle whose numbers"));
    checkpoint = checkpoint_after(2);
    checkpoint.state.liquid.velocity.z.at(3, 3, 3) = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(complaint(written(checkpoint)), HasSubstr("holds a value of a cell that is not finite"));
}

TEST(TankSeries, IsATableOfNumbers) {
    TankSeriesRow row;
    row.time_s = 0.1;
    row.volume_m3 = 0.25;
    row.volume_error_rel = -0.01;
    row.front_x_m = 0.5;
    row.fastest_m_s = 1.5;
    row.steps = 7;
    row.pressure_iterations = 5;
    row.step_s = 0.004;
    EXPECT_EQ(
        series_csv({row, {}}),
        "time_s,volume_m3,volume_error_rel,front_x_m,fastest_m_s,steps,pressure_iterations,step_s\n"
        "0.1,0.25,-0.01,0.5,1.5,7,5,0.004\n"
        "0,0,0,0,0,0,0,0\n");
}

}  // namespace
}  // namespace pastoso::liquid_files
