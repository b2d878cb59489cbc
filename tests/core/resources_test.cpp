#include "core/resources.hpp"

#include "core/error.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

namespace {

using pastoso::core::InputError;
using pastoso::core::resource_path;

class ResourceFolder : public testing::Test {
  protected:
    void SetUp() override { ::setenv("PASTOSO_RESOURCES", folder_.path().c_str(), 1); }
    void TearDown() override { ::unsetenv("PASTOSO_RESOURCES"); }

    pastoso::tests::TemporaryFolder folder_;
};

TEST(Resources, TheBuildTreeHoldsTheProgramsData) {
    EXPECT_FALSE(pastoso::core::read_text_file(resource_path("media.json")).empty());
}

TEST(Resources, TheProgramFolderHoldsThisTest) {
    EXPECT_TRUE(std::filesystem::exists(pastoso::core::program_folder() / "core_test"));
}

TEST_F(ResourceFolder, OfTheEnvironmentComesFirst) {
    pastoso::core::write_text_file(folder_.path() / "own.txt", "own");
    EXPECT_EQ(pastoso::core::read_text_file(resource_path("own.txt")), "own");
}

TEST(Resources, ProgramsOfOthersNameThePrefix) {
    const pastoso::tests::TemporaryFolder folder;
    EXPECT_EQ(pastoso::core::installed_prefix(), pastoso::core::program_folder().parent_path());
    pastoso::core::set_installed_prefix(folder.path());
    std::filesystem::create_directories(folder.path() / "share" / "pastoso");
    pastoso::core::write_text_file(folder.path() / "share" / "pastoso" / "own.txt", "own");
    EXPECT_EQ(pastoso::core::read_text_file(resource_path("own.txt")), "own");
    pastoso::core::set_installed_prefix({});
    EXPECT_EQ(pastoso::core::installed_prefix(), pastoso::core::program_folder().parent_path());
}

TEST_F(ResourceFolder, MissingFilesAreNamed) {
    try {
        resource_path("media.json");
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find((folder_.path() / "media.json").string()),
                  std::string::npos);
    }
}

}  // namespace
