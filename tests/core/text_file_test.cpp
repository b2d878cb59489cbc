#include "core/text_file.hpp"

#include "core/error.hpp"
#include "core/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;
using pastoso::core::InputError;
using pastoso::core::read_text_file;
using pastoso::core::write_text_file;
using testing::HasSubstr;

std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    return names;
}

template <class Call>
std::string error_of(const Call& call) {
    try {
        call();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

class TextFile : public testing::Test {
  protected:
    pastoso::tests::TemporaryFolder folder_;
    fs::path file_ = folder_.path() / "a picture.txt";
};

TEST_F(TextFile, KeepsEveryByte) {
    const std::string text("one\r\n\0two\xff", 10);
    write_text_file(file_, text);
    EXPECT_EQ(read_text_file(file_), text);
}

TEST_F(TextFile, WritesNothingButTheFile) {
    write_text_file(file_, "old");
    write_text_file(file_, "new");
    EXPECT_EQ(read_text_file(file_), "new");
    EXPECT_THAT(names_in(folder_.path()), testing::ElementsAre("a picture.txt"));
}

TEST_F(TextFile, AFileAsFolderIsReported) {
    write_text_file(file_, "text");
    EXPECT_THAT(error_of([&] { write_text_file(file_ / "b.txt", "text"); }),
                HasSubstr("Not a directory"));
    EXPECT_THAT(error_of([&] { read_text_file(file_ / "b.txt"); }), HasSubstr("Not a directory"));
}

TEST_F(TextFile, AFolderIsNoFile) {
    EXPECT_THAT(error_of([&] { read_text_file(folder_.path()); }), HasSubstr("is a folder"));
    EXPECT_THAT(error_of([&] { write_text_file(folder_.path(), ""); }), HasSubstr("is a folder"));
}

TEST_F(TextFile, AMissingFileIsNamed) {
    EXPECT_THAT(error_of([&] { read_text_file(file_); }),
                HasSubstr(file_.string() + ": cannot be opened"));
}

TEST_F(TextFile, LargeFilesAreRefused) {
    write_text_file(file_, "12345");
    EXPECT_EQ(read_text_file(file_, 5), "12345");
    EXPECT_THAT(error_of([&] { read_text_file(file_, 4); }), HasSubstr("larger than the 4 bytes"));
}

TEST(FilesIn, ListsThoseOfAnExtensionByName) {
    const pastoso::tests::TemporaryFolder folder;
    for (const char* name : {"b.json", "a.json", "c.txt", "json"})
        pastoso::core::write_text_file(folder.path() / name, "");
    EXPECT_THAT(pastoso::core::files_in(folder.path(), ".json"),
                testing::ElementsAre(folder.path() / "a.json", folder.path() / "b.json"));
    EXPECT_TRUE(pastoso::core::files_in(folder.path() / "none", ".json").empty());
}

}  // namespace
