// What is shown of painting files that cannot be opened, and the list that remembers them.
#include "start/painting_reader.hpp"

#include "commands/recent_paintings.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"

#include <cstdlib>

#include <gmock/gmock.h>

namespace pastoso::start {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

TEST(PaintingReader, SaysWhyThereIsNoPicture) {
    const tests::TemporaryFolder folder;
    const PaintingFile gone = read_painting_file(folder.path() / "gone.pastoso");
    EXPECT_EQ(gone.fault.toStdString(), "This file is not there any more.");
    EXPECT_TRUE(gone.picture.isNull());
    const auto path = folder.path() / "torn.pastoso";
    core::write_text_file(path, "PK");
    const PaintingFile torn = read_painting_file(path);
    EXPECT_EQ(torn.fault.toStdString(), "This file cannot be read.");
    EXPECT_THAT(torn.reason.toStdString(), HasSubstr("torn.pastoso"));
    EXPECT_TRUE(torn.saved.isValid());
}

class RecentPaintings : public testing::Test {
  protected:
    void SetUp() override { ::setenv("XDG_DATA_HOME", home_.path().c_str(), 1); }
    void TearDown() override { ::unsetenv("XDG_DATA_HOME"); }

    tests::TemporaryFolder home_;
};

TEST_F(RecentPaintings, ThoseThatAreGoneAreKnownUntilTheyAreForgotten) {
    const auto there = home_.path() / "there.pastoso", gone = home_.path() / "gone.pastoso";
    core::write_text_file(there, "");
    commands::remember_painting(gone);
    commands::remember_painting(there);
    EXPECT_THAT(commands::known_paintings(), ElementsAre(there, gone));
    EXPECT_THAT(commands::recent_paintings(), ElementsAre(there));
    commands::forget_painting(gone);
    EXPECT_THAT(commands::known_paintings(), ElementsAre(there));
    commands::forget_painting(there);
    EXPECT_THAT(commands::known_paintings(), IsEmpty());
}

TEST_F(RecentPaintings, OnlyTheLatestAreKept) {
    for (std::size_t i = 0; i < commands::kMostRecent + 3; ++i)
        commands::remember_painting(home_.path() / (std::to_string(i) + ".pastoso"));
    EXPECT_THAT(commands::known_paintings(), SizeIs(commands::kMostRecent));
    EXPECT_EQ(commands::known_paintings().front().filename(), "12.pastoso");
}

}  // namespace
}  // namespace pastoso::start
