// Saving over an older file: whatever happens, one of the two is there, whole.
#include "core/error.hpp"
#include "files/temporary_folder.hpp"
#include "project/paintings.hpp"

#include <csignal>
#include <set>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gmock/gmock.h>

namespace pastoso::project {
namespace {

using testing::HasSubstr;

class SavingAProject : public files::TemporaryFolder {
  protected:
    std::filesystem::path path() const { return folder / "a.pastoso"; }
    core::ThreadPool pool{1};
};

/// Runs `work` in a process of its own, whose exit status says whether it was done.
template <class Work>
int status_in_child(const Work& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        work();
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return status;
}

TEST_F(SavingAProject, AFullDiskLeavesTheOldFile) {
    save_project(path(), busy_project(pool), pool);
    const auto before = bytes_in(path());
    const auto sentence_path = folder / "sentence";
    const int status = status_in_child([&] {
        // No file may grow beyond 20 kB: writing fails as on a full disk.
        ::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{20000, 20000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        core::ThreadPool own(1);
        try {
            save_project(path(), busy_project(own), own);
        } catch (const core::InputError& error) {
            ::_exit(std::string(error.what()).find(path().string() + ": cannot be written (") == 0 ? 7
                                                                                                   : 8);
        }
    });
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 7);
    EXPECT_EQ(bytes_in(path()), before);
    EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(SavingAProject, AKilledSaveLeavesOneOfTheTwoFiles) {
    const document::Recording recording = busy_session();
    const Project old_one = project_of(*played(recording, 26, pool), recording);
    const Project new_one = busy_project(pool);
    const std::set<std::uint64_t> hashes = {document::state_hash(old_one.painting),
                                            document::state_hash(new_one.painting)};
    save_project(path(), old_one, pool);
    for (int turn = 0; turn < 25; ++turn) {
        const pid_t child = ::fork();
        if (child == 0) {
            core::ThreadPool own(1);
            while (true) {
                save_project(path(), new_one, own);
                save_project(path(), old_one, own);
            }
        }
        ::usleep(static_cast<useconds_t>(3000 + 7919 * turn % 100000));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        EXPECT_TRUE(hashes.contains(document::state_hash(load_project(path(), pool).painting)));
    }
}

TEST_F(SavingAProject, PlacesThatCannotBeWrittenAreToldOf) {
    const Project project = busy_project(pool);
    const auto error_at = [&](const std::filesystem::path& place) -> std::string {
        try {
            save_project(place, project, pool);
        } catch (const core::InputError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_THAT(error_at(folder / "none" / "a.pastoso"), HasSubstr("cannot be written (No such file"));
    EXPECT_EQ(error_at(folder), folder.string() + ": is a folder, not a file.");
    EXPECT_EQ(files_in_folder(), 0U);
}

}  // namespace
}  // namespace pastoso::project
