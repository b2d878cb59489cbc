#include "journal/journal_writer.hpp"

#include "core/error.hpp"
#include "core/file_size_limit.hpp"
#include "document/scenes.hpp"
#include "files/temporary_folder.hpp"
#include "journal/recovery.hpp"
#include "project/project.hpp"

#include <fstream>
#include <mutex>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::journal {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class Writer : public files::TemporaryFolder {
  protected:
    Beginning bare() const { return {.canvas = document::small_canvas()}; }
    static void touch(JournalWriter& journal) { journal.note({0, document::DryNow{}}); }
};

TEST_F(Writer, LeavesAJournalUnlessItIsDiscarded) {
    {
        JournalWriter journal(folder, bare());
        touch(journal);
    }
    EXPECT_THAT(unfinished_paintings(folder), SizeIs(1));
    {
        JournalWriter journal(folder, bare());
        touch(journal);
        journal.discard();
    }
    EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(Writer, WhatWasSavedNeedsNoRecovery) {
    {
        JournalWriter journal(folder, bare());
        touch(journal);
        journal.note_saved(folder / "a.pastoso", journal.events());
    }
    EXPECT_THAT(unfinished_paintings(folder), IsEmpty());
}

TEST_F(Writer, WhatWasPaintedAfterSavingDoes) {
    {
        JournalWriter journal(folder, bare());
        touch(journal);
        journal.note_saved(folder / "a.pastoso", journal.events());
        touch(journal);
    }
    const std::vector<Unfinished> paintings = unfinished_paintings(folder);
    ASSERT_THAT(paintings, SizeIs(1));
    EXPECT_EQ(paintings[0].changes, 1U);
    EXPECT_EQ(paintings[0].painting, (folder / "a.pastoso").string());
}

TEST_F(Writer, AStartThatIsNowhereElseIsKept) {
    core::ThreadPool pool(1);
    Beginning recovered = bare();
    recovered.is_saved = false;
    recovered.write_start = [&](const fs::path& path) {
        const document::Painting painting(document::small_canvas(), pool);
        project::save_project(path, {painting.state(), {document::small_canvas(), {}, 0}}, pool);
    };
    { JournalWriter journal(folder, recovered); }
    ASSERT_THAT(unfinished_paintings(folder), SizeIs(1));
    EXPECT_THAT(recover(unfinished_paintings(folder)[0].folder, pool).notes, IsEmpty());
}

TEST_F(Writer, ActionsAreOnTheDiskSoon) {
    JournalWriter journal(folder, bare(), {.flush_s = 0.001});
    const auto size = [&] { return fs::file_size(journal.folder() / kStrokesFile); };
    const auto before = size();
    touch(journal);
    while (size() == before)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_GT(size(), before);
}

TEST_F(Writer, CheckpointsWaitForWorkAndForEachOther) {
    JournalWriter journal(folder, bare(), {.replay_s = 3.0, .rests = 0.0});
    EXPECT_FALSE(journal.wants_checkpoint(2.9));
    EXPECT_TRUE(journal.wants_checkpoint(3.0));
    touch(journal);
    EXPECT_FALSE(journal.wants_checkpoint(2.9));
    journal.note({0, document::Undo{}});
    EXPECT_FALSE(journal.wants_checkpoint(2.9)) << "what was undone was done after the start";
    journal.note({0, document::Undo{}});
    EXPECT_TRUE(journal.wants_checkpoint(2.9)) << "Undo reached behind the start";
}

/// What a journal has told of its trouble.
class Heard {
  public:
    JournalWriter::Told told() {
        return [this](const Trouble& trouble) {
            const std::lock_guard lock(mutex_);
            last_ = trouble;
        };
    }
    Trouble wait_for(bool over) const {
        while (true) {
            {
                const std::lock_guard lock(mutex_);
                if (last_ && last_->reason.empty() == over) return *last_;
            }
            std::this_thread::yield();
        }
    }

  private:
    mutable std::mutex mutex_;
    std::optional<Trouble> last_;
};

constexpr Pace kHasty{.flush_s = 0.001, .retry_s = 0.001};

TEST_F(Writer, WhatCannotBeWrittenIsToldAndWrittenOnceItCanBe) {
    Heard heard;
    std::uint64_t events = 0;
    {
        JournalWriter journal(folder, bare(), kHasty, heard.told());
        const fs::path file = journal.folder() / kStrokesFile;
        const auto whole = fs::file_size(file);
        {
            // Room for a part of a frame, which must not stay.
            const tests::FileSizeLimit limit(whole + 10);
            touch(journal);
            const Trouble trouble = heard.wait_for(false);
            EXPECT_THAT(trouble.reason.text(), HasSubstr(file.string()));
            EXPECT_FALSE(trouble.strokes_are_kept);
            EXPECT_GT(trouble.waiting_bytes, 0U);
            EXPECT_EQ(fs::file_size(file), whole);
            touch(journal);
        }
        heard.wait_for(true);
        touch(journal);
        events = journal.events();
    }
    const std::vector<Unfinished> paintings = unfinished_paintings(folder);
    ASSERT_THAT(paintings, SizeIs(1));
    EXPECT_EQ(paintings[0].changes, events);
    EXPECT_FALSE(paintings[0].damaged);
}

TEST_F(Writer, ACheckpointThatCannotBeWrittenIsToldAndTriedAgain) {
    core::ThreadPool pool(1);
    const document::Painting painting(document::small_canvas(), pool);
    Heard heard;
    JournalWriter journal(folder, bare(), {.flush_s = 0.001, .rests = 0.0, .retry_s = 0.001},
                          heard.told());
    {
        const tests::FileSizeLimit limit(fs::file_size(journal.folder() / kStrokesFile) + 100);
        journal.write_checkpoint(painting.state(), 0.0);
        EXPECT_TRUE(heard.wait_for(false).strokes_are_kept);
    }
    while (!journal.wants_checkpoint(0.0))
        std::this_thread::yield();
    journal.write_checkpoint(painting.state(), 0.0);
    heard.wait_for(true);
    EXPECT_TRUE(fs::exists(journal.folder() / "checkpoint-2.pastoso"));
}

TEST_F(Writer, WithoutAPlaceThereIsNone) {
    std::ofstream(folder / "file") << "x";
    try {
        const JournalWriter journal(folder / "file" / "journals", bare());
        FAIL();
    } catch (const core::InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("can be saved, but not recovered"));
    }
}

}  // namespace
}  // namespace pastoso::journal
