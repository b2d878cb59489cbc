// The names of numbered versions.
#include "commands/painting_version.hpp"

#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"

#include <gtest/gtest.h>

namespace pastoso::commands {
namespace {

class PaintingVersion : public ::testing::Test {
  protected:
    void put(const char* name) { core::write_text_file(folder_.path() / name, "a painting"); }
    std::string next(const char* name) {
        return next_version(folder_.path() / name).filename().string();
    }

    tests::TemporaryFolder folder_;
};

TEST_F(PaintingVersion, CountsFromOne) {
    put("rose.pastoso");
    EXPECT_EQ(next("rose.pastoso"), "rose_001.pastoso");
    EXPECT_EQ(next_version(folder_.path() / "rose.pastoso").parent_path(), folder_.path());
}

TEST_F(PaintingVersion, IsHigherThanAllThatStandThere) {
    for (const char* name : {"rose.pastoso", "rose_001.pastoso", "rose_7.pastoso"})
        put(name);
    EXPECT_EQ(next("rose.pastoso"), "rose_008.pastoso");
    EXPECT_EQ(next("rose_001.pastoso"), "rose_008.pastoso");
    put("rose_999.pastoso");
    EXPECT_EQ(next("rose_001.pastoso"), "rose_1000.pastoso");
    put("rose_1000.pastoso");
    EXPECT_EQ(next("rose_1000.pastoso"), "rose_1001.pastoso");
}

TEST_F(PaintingVersion, LeavesOtherNamesAlone) {
    for (const char* name :
         {"rose_009.ora", "rosebud_009.pastoso", "rose_20261129.pastoso", "_3.pastoso"})
        put(name);
    EXPECT_EQ(next("rose.pastoso"), "rose_001.pastoso");
    EXPECT_EQ(next("rose_20261129.pastoso"), "rose_20261129_001.pastoso");
    EXPECT_EQ(next("rose_final.pastoso"), "rose_final_001.pastoso");
    EXPECT_EQ(next("_3.pastoso"), "_3_001.pastoso");
    EXPECT_EQ(next("rose_.pastoso"), "rose__001.pastoso");
}

TEST_F(PaintingVersion, CountsAFolderAndALinkOfThatName) {
    std::filesystem::create_directory(folder_.path() / "rose_001.pastoso");
    std::filesystem::create_symlink("nowhere", folder_.path() / "rose_002.pastoso");
    EXPECT_EQ(next("rose.pastoso"), "rose_003.pastoso");
}

}  // namespace
}  // namespace pastoso::commands
