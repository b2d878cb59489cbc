// The small picture of a painting from the command line.
#include "cli/run_program.hpp"
#include "core/text_file.hpp"
#include "files/image.hpp"

#include <gmock/gmock.h>

namespace pastoso::cli {
namespace {

class CliThumbnail : public CliTest {
  protected:
    void SetUp() override {
        CliTest::SetUp();
        const RunResult run =
            run_cli(small({"replay", short_recording(), "--save", path("a.pastoso"), "-q"}));
        ASSERT_EQ(run.status, 0) << run.errors;
    }

    pigment::Picture picture(const std::vector<std::string>& size) const {
        std::vector<std::string> words = {"thumbnail", path("a.pastoso"), "-o", path("small")};
        words.insert(words.end(), size.begin(), size.end());
        const RunResult run = run_cli(words);
        EXPECT_EQ(run.status, 0);
        EXPECT_EQ(run.output + run.errors, "");
        return files::decode_png(core::read_text_file(path("small")));
    }
};

TEST_F(CliThumbnail, IsTheOneInTheFileOrSmaller) {
    const pigment::Picture whole = picture({});
    EXPECT_EQ(whole.width, 80);  // 40 mm of 2 cells each
    EXPECT_EQ(picture({"--size", "1024"}), whole);
    const pigment::Picture small = picture({"--size", "40"});
    EXPECT_EQ(small.width, 40);
    EXPECT_EQ(small.height, 30);
}

TEST_F(CliThumbnail, OfNothingElse) {
    expect_refusal({"thumbnail", write("b.pastoso", "nothing"), "-o", path("small")}, 1,
                   path("b.pastoso") + ": ");
    expect_refusal({"thumbnail", path("a.pastoso"), "-o", path("none/small")}, 1, path("none"));
}

/// What the type of the file is told by (packaging/desktop).
TEST_F(CliThumbnail, ThePaintingBeginsWithWhatItIs) {
    const std::string file = core::read_text_file(path("a.pastoso"));
    EXPECT_EQ(file.substr(0, 4), "PK\3\4");
    EXPECT_EQ(file.substr(30, 24), "mimetypeimage/openraster");
    EXPECT_EQ(file.substr(84, 18), "pastoso/setup.json");
}

}  // namespace
}  // namespace pastoso::cli
