// Tools of the painter's own on the command line.
#include "brush/preset.hpp"
#include "cli/run_program.hpp"
#include "core/text_file.hpp"

#include <cstdlib>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace pastoso::cli {
namespace {

using testing::HasSubstr;

class CliBrush : public CliTest {
  protected:
    void SetUp() override {
        CliTest::SetUp();
        ::setenv("XDG_DATA_HOME", folder.c_str(), 1);
        pen = write("pen.dat", "0 5 5 0.5\n0.1 15 5 0.5\n0.2 25 5 0.5\n");
    }
    void TearDown() override {
        ::unsetenv("XDG_DATA_HOME");
        CliTest::TearDown();
    }

    RunResult replay_with(const std::string& brush) {
        return run_cli({"replay", pen, "--canvas", "30x10mm", "--px-per-mm", "2", "--seconds", "0",
                        "--brush", brush, "-q", "-o", path("out.png"), "--stats", path("stats.json")});
    }
    std::string picture_hash() {
        return nlohmann::json::parse(core::read_text_file(path("stats.json")))["image_hash"].dump();
    }
    brush::Preset own(double width_mm) const {
        brush::Preset preset = brush::find_preset("flat");
        preset.name = "My flat";
        preset.tip.width_mm = width_mm;
        return preset;
    }

    std::string pen;
};

TEST_F(CliBrush, TakesAPresetFile) {
    const std::string file = write("mine.json", brush::preset_to_json(own(4.0)));
    ASSERT_EQ(replay_with("flat").status, 0);
    const std::string bundled = picture_hash();
    const RunResult run = replay_with(file);
    ASSERT_EQ(run.status, 0) << run.errors;
    EXPECT_NE(picture_hash(), bundled);
}

TEST_F(CliBrush, FindsThePaintersOwnByName) {
    std::filesystem::create_directories(folder / "pastoso" / "brushes");
    core::write_text_file(folder / "pastoso" / "brushes" / "mine.json", brush::preset_to_json(own(4.0)));
    const RunResult run = replay_with("my FLAT");
    EXPECT_EQ(run.status, 0) << run.errors;
}

TEST_F(CliBrush, AFaultyPresetIsTold) {
    const std::string file = write("bad.json", "{\"version\": 2,\n \"kind\": \"contact\"");
    const RunResult run = replay_with(file);
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.errors, HasSubstr("bad.json, line 2: this is not valid JSON."));
    std::filesystem::create_directories(folder / "pastoso" / "brushes");
    std::filesystem::copy_file(file, folder / "pastoso" / "brushes" / "bad.json");
    EXPECT_THAT(replay_with("My flat").errors, HasSubstr("Left out: "));
    EXPECT_FALSE(std::filesystem::exists(path("out.png")));
}

}  // namespace
}  // namespace pastoso::cli
