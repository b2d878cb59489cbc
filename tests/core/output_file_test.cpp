#include "core/output_file.hpp"

#include "core/error.hpp"
#include "core/file_size_limit.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"

#include <cstdlib>
#include <fstream>
#include <random>
#include <stdexcept>
#include <sys/stat.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;
using pastoso::core::InputError;
using pastoso::core::OutputFile;
using pastoso::core::read_text_file;
using pastoso::core::Replaced;
using pastoso::core::write_aside;
using pastoso::core::write_text_file;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

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

mode_t rights_of(const fs::path& path) {
    struct stat status {};
    EXPECT_EQ(::stat(path.c_str(), &status), 0);
    return status.st_mode & 07777;
}

/// Root may write everywhere; as "nobody" the test is refused like any user.
class WithoutRoot {
  public:
    WithoutRoot() { refused_ = ::geteuid() == 0 && ::seteuid(kNobody) != 0; }
    ~WithoutRoot() {
        if (::getuid() == 0 && ::seteuid(0) != 0) std::abort();
    }
    bool refused() const { return refused_; }

  private:
    static constexpr uid_t kNobody = 65534;
    bool refused_ = false;
};

class OutputFileTest : public testing::Test {
  protected:
    pastoso::tests::TemporaryFolder folder_;
    fs::path file_ = folder_.path() / "a picture.txt";
};

TEST_F(OutputFileTest, TheOldFileStaysWhileTheNewOneIsWritten) {
    write_text_file(file_, "old");
    write_aside(file_, [&](OutputFile& file) {
        EXPECT_EQ(file.part().extension(), ".txt");
        file.append("new");
        EXPECT_EQ(read_text_file(file_), "old");
    });
    EXPECT_EQ(read_text_file(file_), "new");
    EXPECT_THAT(names_in(folder_.path()), UnorderedElementsAre("a picture.txt"));
}

TEST_F(OutputFileTest, AnotherProgramMayWriteThePart) {
    write_aside(file_, [&](OutputFile& file) { std::ofstream(file.part()) << "by its name"; });
    EXPECT_EQ(read_text_file(file_), "by its name");
}

TEST_F(OutputFileTest, TheOldFileStaysWhenTheWriterThrows) {
    write_text_file(file_, "old");
    const auto write = [](OutputFile& file) {
        file.append("half of the n");
        throw std::runtime_error("the writer failed");
    };
    EXPECT_THROW(write_aside(file_, write), std::runtime_error);
    EXPECT_EQ(read_text_file(file_), "old");
    EXPECT_THAT(names_in(folder_.path()), UnorderedElementsAre("a picture.txt"));
}

TEST_F(OutputFileTest, TheOldFileStaysWhenTheWriterGivesUp) {
    write_text_file(file_, "old");
    EXPECT_FALSE(pastoso::core::write_aside_unless(file_, [](OutputFile& file) {
        file.append("new");
        return false;
    }));
    EXPECT_EQ(read_text_file(file_), "old");
    EXPECT_THAT(names_in(folder_.path()), UnorderedElementsAre("a picture.txt"));
}

TEST_F(OutputFileTest, MissingFoldersAreReportedBeforeAnyWork) {
    const fs::path lost = folder_.path() / "no such folder" / "a.txt";
    bool worked = false;
    const std::string message = error_of([&] { write_aside(lost, [&](OutputFile&) { worked = true; }); });
    EXPECT_THAT(message, HasSubstr(lost.string()));
    EXPECT_THAT(message, HasSubstr("No such file or directory"));
    EXPECT_FALSE(worked);
}

TEST_F(OutputFileTest, FoldersWithoutWritePermissionAreReported) {
    fs::permissions(folder_.path(), fs::perms::owner_read | fs::perms::owner_exec);
    const WithoutRoot user;
    if (user.refused()) GTEST_SKIP() << "root cannot become another user here, and may write everywhere";
    EXPECT_THAT(error_of([&] { write_text_file(file_, "text"); }), HasSubstr("Permission denied"));
}

TEST_F(OutputFileTest, PiecesLandWhereTheyBelongInAnyOrder) {
    std::mt19937 random(11);
    const auto below = [&](std::size_t end) { return random() % end; };
    std::string wanted;
    write_aside(file_, [&](OutputFile& file) {
        for (int piece = 0; piece < 400; ++piece) {
            const std::size_t bytes = below(piece % 50 == 0 ? 200'000 : 300);
            const std::string text(bytes, static_cast<char>('a' + piece % 26));
            const std::size_t place = piece % 3 == 0 ? below(wanted.size() + 1) : wanted.size();
            if (wanted.size() < place + bytes) wanted.resize(place + bytes);
            wanted.replace(place, bytes, text);
            file.write_at(place, std::as_bytes(std::span(text)));
            EXPECT_EQ(file.size(), wanted.size());
        }
    });
    EXPECT_EQ(read_text_file(file_), wanted);
}

TEST_F(OutputFileTest, AFullDiskLeavesTheOldFileAtEveryByte) {
    write_text_file(file_, "old");
    const std::string text(100'000, 'n');
    for (const rlim_t bytes : {0, 1, 4096, 65'536, 99'999}) {
        const pastoso::tests::FileSizeLimit disk(bytes);
        EXPECT_EQ(error_of([&] { write_text_file(file_, text); }),
                  file_.string() + ": cannot be written (File too large).");
        EXPECT_EQ(read_text_file(file_), "old");
        EXPECT_THAT(names_in(folder_.path()), UnorderedElementsAre("a picture.txt"));
    }
    const pastoso::tests::FileSizeLimit just_enough(text.size());
    write_text_file(file_, text);
    EXPECT_EQ(read_text_file(file_), text);
}

TEST_F(OutputFileTest, AFailureIsKeptUntilItIsAskedFor) {
    const pastoso::tests::FileSizeLimit disk(10);
    OutputFile file(file_);
    file.append(std::string(200'000, 'a'));
    file.append("b");
    EXPECT_THROW(file.check(), InputError);
    EXPECT_THROW(file.put_in_place(), InputError);
    EXPECT_FALSE(fs::exists(file_));
}

TEST_F(OutputFileTest, RightsOfTheOldFileAreKept) {
    for (const mode_t rights : {0600, 0640, 0755, 0200}) {
        write_text_file(file_, "old");
        ASSERT_EQ(::chmod(file_.c_str(), rights), 0);
        write_text_file(file_, "new");
        EXPECT_EQ(rights_of(file_), rights);
    }
}

TEST_F(OutputFileTest, TheOwnerOfTheOldFileIsKept) {
    if (::geteuid() != 0) GTEST_SKIP() << "only root may give files away";
    write_text_file(file_, "old");
    ASSERT_EQ(::chown(file_.c_str(), 12345, 23456), 0);
    ASSERT_EQ(::chmod(file_.c_str(), 0640), 0);
    write_text_file(file_, "new");
    struct stat status {};
    ASSERT_EQ(::stat(file_.c_str(), &status), 0);
    EXPECT_EQ(status.st_uid, 12345U);
    EXPECT_EQ(status.st_gid, 23456U);
    EXPECT_EQ(rights_of(file_), 0640U);
}

TEST_F(OutputFileTest, WriteProtectedFilesAreReplacedOnlyWhenThatIsAskedFor) {
    write_text_file(file_, "old");
    ASSERT_EQ(::chmod(file_.c_str(), 0444), 0);
    EXPECT_TRUE(pastoso::core::is_write_protected(file_));
    EXPECT_THAT(error_of([&] { write_text_file(file_, "new"); }),
                HasSubstr(file_.string() + ": is write-protected"));
    EXPECT_EQ(read_text_file(file_), "old");
    write_aside(
        file_, [](OutputFile& file) { file.append("new"); }, Replaced::Any);
    EXPECT_EQ(read_text_file(file_), "new");
    EXPECT_EQ(rights_of(file_), 0444U);
}

TEST_F(OutputFileTest, WhatMayReplaceNothingLeavesWhatStandsThere) {
    write_aside(
        file_, [](OutputFile& file) { file.append("first"); }, Replaced::None);
    EXPECT_EQ(read_text_file(file_), "first");
    EXPECT_THAT(error_of([&] {
                    write_aside(
                        file_, [](OutputFile& file) { file.append("second"); }, Replaced::None);
                }),
                HasSubstr(file_.string() + ": cannot be written (File exists)"));
    EXPECT_EQ(read_text_file(file_), "first");

    fs::remove(file_);
    EXPECT_THAT(error_of([&] {
                    write_aside(
                        file_,
                        [this](OutputFile& file) {
                            file.append("third");
                            write_text_file(file_, "another program's");
                        },
                        Replaced::None);
                }),
                HasSubstr("File exists"));
    EXPECT_EQ(read_text_file(file_), "another program's");
    EXPECT_THAT(names_in(folder_.path()), UnorderedElementsAre(file_.filename().string()));
}

TEST_F(OutputFileTest, LinksStayAndWhatTheyLeadToIsReplaced) {
    fs::create_directory(folder_.path() / "far");
    const fs::path target = folder_.path() / "far" / "target.txt";
    const fs::path link = folder_.path() / "link.txt";
    fs::create_symlink("far/second.txt", link);
    fs::create_symlink("target.txt", folder_.path() / "far" / "second.txt");
    for (const char* text : {"the first makes it", "the second replaces it"}) {
        write_text_file(link, text);
        EXPECT_TRUE(fs::is_symlink(link));
        EXPECT_FALSE(fs::is_symlink(target));
        EXPECT_EQ(read_text_file(target), text);
    }
    EXPECT_THAT(names_in(folder_.path() / "far"), UnorderedElementsAre("target.txt", "second.txt"));
}

TEST_F(OutputFileTest, ALinkToItselfIsRefused) {
    fs::create_symlink("round.txt", folder_.path() / "round.txt");
    EXPECT_THAT(error_of([&] { write_text_file(folder_.path() / "round.txt", ""); }),
                HasSubstr("round.txt: cannot be written (Too many levels of symbolic links)"));
}

TEST_F(OutputFileTest, WhatIsNoFileIsRefusedAndStays) {
    ASSERT_EQ(::mkfifo(file_.c_str(), 0600), 0);
    EXPECT_EQ(error_of([&] { write_text_file(file_, ""); }),
              file_.string() + ": is a named pipe, not a file.");
    EXPECT_TRUE(fs::is_fifo(file_));
    EXPECT_EQ(error_of([] { write_text_file("/dev/full", ""); }), "/dev/full: is a device, not a file.");
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
    fs::create_symlink("/dev/null", folder_.path() / "link");
    EXPECT_THAT(error_of([&] { write_text_file(folder_.path() / "link", ""); }), HasSubstr("is a device"));
    EXPECT_THAT(error_of([&] { write_text_file(folder_.path(), ""); }), HasSubstr("is a folder"));
}

TEST_F(OutputFileTest, ForeseenNamesOfPartsAreNotFollowed) {
    const fs::path victim = folder_.path() / "victim";
    write_text_file(victim, "untouched");
    for (int n = 0; n < 200; ++n)
        fs::create_symlink("victim", folder_.path() / (".a picture-" + std::to_string(::getpid()) + "-" +
                                                       std::to_string(n) + ".part.txt"));
    write_text_file(file_, "new");
    EXPECT_EQ(read_text_file(victim), "untouched");
    EXPECT_EQ(read_text_file(file_), "new");
}

TEST_F(OutputFileTest, TheLongestNamesCanBeWritten) {
    const fs::path longest = folder_.path() / (std::string(251, 'n') + ".txt");
    write_text_file(longest, "text");
    EXPECT_EQ(read_text_file(longest), "text");
    const fs::path too_long = folder_.path() / std::string(256, 'n');
    EXPECT_THAT(error_of([&] { write_text_file(too_long, "text"); }), HasSubstr("File name too long"));
}

}  // namespace
