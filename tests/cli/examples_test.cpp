#include "cli/run_program.hpp"
#include "core/text_file.hpp"
#include "document/actions/actions.hpp"
#include "recordings/recording_json.hpp"
#include "source_file.hpp"

#include <gmock/gmock.h>

namespace pastoso::cli {
namespace {

const std::filesystem::path kExamples = tests::source_file("resources/strokes");

class CliExamples : public CliTest, public testing::WithParamInterface<const char*> {};

TEST_P(CliExamples, AreWhatTheirScriptWrites) {
    ASSERT_EQ(run_program("pastoso-make-examples", {folder.string()}).status, 0);
    EXPECT_EQ(core::read_text_file(folder / GetParam()), core::read_text_file(kExamples / GetParam()))
        << "run pastoso-make-examples resources/strokes";
}

TEST_P(CliExamples, UseKnownNamesAndStaySmall) {
    const document::Recording recording = recordings::read_recording_json(kExamples / GetParam());
    for (const document::Event& event : recording.events)
        document::check_action(event.action);
    EXPECT_LT(std::filesystem::file_size(kExamples / GetParam()), 2'000'000U);
}

TEST_P(CliExamples, AreReplayedInFull) {
    const RunResult run = run_cli(
        {"replay", (kExamples / GetParam()).string(), "--px-per-mm", "1", "-q", "-o", path("out.png")});
    EXPECT_EQ(run.status, 0) << run.errors;
}

INSTANTIATE_TEST_SUITE_P(All, CliExamples,
                         testing::Values("evening.json", "palette.json", "poppies.json", "sampler.json",
                                         "sheet.json", "still-life.json", "surf.json"),
                         [](const auto& example) {
                             std::string name = example.param;
                             std::erase_if(name, [](char c) { return std::isalpha(c) == 0; });
                             return name;
                         });

}  // namespace
}  // namespace pastoso::cli
