#include "core/regular_file.hpp"

#include "core/error.hpp"
#include "core/looking.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::core {
namespace {

namespace fs = std::filesystem;
using testing::UnorderedElementsAre;

class RegularFileTest : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

    /// What read_text_file() says, which opens files as all readers do.
    static std::string refusal(const fs::path& path) {
        try {
            read_text_file(path);
        } catch (const InputError& error) {
            return error.what();
        }
        return "no error";
    }

    tests::TemporaryFolder folder_;
};

TEST_F(RegularFileTest, GivesItsBytesFromAnyPlace) {
    write_text_file(path("a"), "0123456789");
    const RegularFile file(path("a"));
    EXPECT_EQ(file.bytes(), 10U);
    EXPECT_EQ(file.text_at(2, 3), "234");
    EXPECT_EQ(file.text_at(8, 100), "89");
    EXPECT_EQ(file.text_at(10, 1), "");
    EXPECT_EQ(file.text_at(~std::uint64_t{0}, 1), "");
}

/// None of these may wait for somebody who writes into it.
TEST_F(RegularFileTest, APipeIsRefusedAtOnce) {
    ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
    EXPECT_EQ(refusal(path("pipe")), path("pipe") + ": is a named pipe, not a file.");
    fs::create_symlink("pipe", path("link"));
    EXPECT_EQ(refusal(path("link")), path("link") + ": is a named pipe, not a file.");
}

TEST_F(RegularFileTest, DevicesAndFoldersAreRefused) {
    EXPECT_EQ(refusal("/dev/zero"), "/dev/zero: is a device, not a file.");
    EXPECT_EQ(refusal("/dev/full"), "/dev/full: is a device, not a file.");
    EXPECT_EQ(refusal(folder_.path()), folder_.path().string() + ": is a folder, not a file.");
}

TEST_F(RegularFileTest, ASocketIsRefused) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string name = path("socket");
    ASSERT_LT(name.size(), sizeof address.sun_path);
    name.copy(address.sun_path, name.size());
    const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
    ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(refusal(name), name + ": is a socket, not a file.");
    ::close(socket);
}

TEST_F(RegularFileTest, WhatMayNotBeLookedAtIsToldInASentence) {
    fs::create_symlink("loop", path("loop"));
    EXPECT_EQ(refusal(path("loop")),
              path("loop") + ": cannot be opened (Too many levels of symbolic links).");
    const std::string longest = path(std::string(300, 'a'));
    EXPECT_EQ(refusal(longest), longest + ": cannot be opened (File name too long).");
    EXPECT_EQ(refusal(path("none")), path("none") + ": cannot be opened (No such file or directory).");
}

TEST_F(RegularFileTest, LookingThrowsNothing) {
    fs::create_symlink("loop", path("loop"));
    write_text_file(path("a"), "");
    for (const std::string& unseen : {path("loop"), path(std::string(300, 'a')), path("loop/b")}) {
        EXPECT_FALSE(is_there(unseen));
        EXPECT_FALSE(is_folder(unseen));
        EXPECT_FALSE(is_regular_file(unseen));
        EXPECT_TRUE(entries_of(unseen).empty());
    }
    EXPECT_TRUE(is_there(path("a")) && is_regular_file(path("a")) && is_folder(folder_.path()));
    EXPECT_THAT(entries_of(folder_.path()), UnorderedElementsAre(path("a"), path("loop")));
    EXPECT_TRUE(absolute_path("a").is_absolute());
}

TEST_F(RegularFileTest, LookingFromAFolderThatIsGoneThrowsNothing) {
    const fs::path here = fs::current_path();
    fs::create_directory(path("gone"));
    fs::current_path(path("gone"));
    fs::remove(path("gone"));
    EXPECT_EQ(absolute_path("a"), "a");
    fs::current_path(here);
}

}  // namespace
}  // namespace pastoso::core
