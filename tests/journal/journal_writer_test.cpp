#include "journal/journal_writer.hpp"

#include "core/error.hpp"
#include "document/scenes.hpp"
#include "files/temporary_folder.hpp"
#include "journal/recovery.hpp"
#include "project/project.hpp"

#include <fstream>

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
