// A program that paints, saves, undoes and writes checkpoints is killed after a number of actions that
// follows from a seed: its journal soon holds what was done, and what it holds comes back, to the bit.
#include "core/random.hpp"
#include "core/text_file.hpp"
#include "document/hasty_painter.hpp"
#include "document/painting.hpp"
#include "document/player.hpp"
#include "files/temporary_folder.hpp"
#include "journal/journal_file.hpp"
#include "journal/recovery.hpp"
#include "journal/restless_painter.hpp"
#include "patience.hpp"

#include <fstream>
#include <optional>
#include <signal.h>
#include <span>
#include <sys/wait.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::journal {
namespace {

namespace fs = std::filesystem;
using document::Action;
using document::Event;
using testing::IsEmpty;
using testing::SizeIs;

/// What a painting has certainly come to.
struct Progress {
    std::size_t actions = 0;  ///< of the painter
    std::size_t events = 0;   ///< of the recording, its past included
    std::int64_t tick = 0;
};

/// As the program told last.
Progress told(const fs::path& file) {
    std::ifstream lines(file);
    Progress latest, line;
    while (lines >> line.actions >> line.events >> line.tick)
        latest = line;
    return latest;
}

/// As the journal has it that is being written, after `past_events`.
Progress written(const fs::path& file, std::size_t past_events) {
    const std::string text = core::read_text_file(file);
    const JournalContent content = parse_journal(std::as_bytes(std::span(text)), file.string());
    if (content.runs.empty()) return {};
    const Run& run = content.runs.back();
    return {0, past_events + run.end_event(), run.recording.end_tick};
}

/// The program that paints; killed where this ends.
class PainterProgram {
  public:
    PainterProgram(const fs::path& folder, std::uint32_t seed, const fs::path& project) {
        const std::string seed_text = std::to_string(seed);
        pid_ = ::fork();
        if (pid_ != 0) return;
        ::execl(PASTOSO_PAINTER, PASTOSO_PAINTER, folder.c_str(), seed_text.c_str(),
                project.empty() ? nullptr : project.c_str(), nullptr);
        ::_exit(127);
    }
    ~PainterProgram() {
        ::kill(pid_, SIGKILL);
        ::waitpid(pid_, nullptr, 0);
    }
    PainterProgram(const PainterProgram&) = delete;
    PainterProgram& operator=(const PainterProgram&) = delete;

    /// Waits until the condition holds; false when it never will, because the program has ended.
    template <class Condition>
    bool comes_to(const Condition& condition) const {
        return tests::comes_true([&] { return condition() || has_ended(); }) && !has_ended();
    }

  private:
    bool has_ended() const {
        siginfo_t info{};
        return ::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
               info.si_pid != 0;
    }

    pid_t pid_ = -1;
};

class Kill : public files::TemporaryFolder {
  protected:
    void SetUp() override {
        files::TemporaryFolder::SetUp();
        root = folder / kJournalsName;
    }

    /// Has a painter paint until it is killed: after so many of its actions and some more, once those
    /// are in its journal. Returns what was there by then.
    Progress paint_and_kill(std::uint32_t seed, const fs::path& project, std::size_t past_events,
                            std::size_t actions, std::size_t more) {
        fs::remove(folder / kProgressName);
        const PainterProgram painter(folder, seed, project);
        const auto has_done = [&](std::size_t wanted) {
            return painter.comes_to([&] { return told(folder / kProgressName).actions >= wanted; });
        };
        EXPECT_TRUE(has_done(actions));
        const Progress done = told(folder / kProgressName);
        EXPECT_TRUE(painter.comes_to([&] {
            const Progress kept = written(journal_file(), past_events);
            return kept.events >= done.events && kept.tick >= done.tick;
        }));
        EXPECT_TRUE(has_done(told(folder / kProgressName).actions + more));
        return done;
    }
    fs::path journal_file() const { return fs::directory_iterator(root)->path() / kStrokesFile; }

    std::uint64_t hash_of_replay(const document::Recording& recording) {
        document::Painting painting(recording.canvas, pool);
        document::Player player(painting, recording);
        while (!player.finished())
            player.play_tick();
        return painting.state_hash();
    }

    /// The actions after the past are what this painter does one after the other, but for Undo and Redo
    /// with nothing to return to, and a lift of the pen at the end that recovery adds. Returns how many
    /// of the painter's actions that are.
    std::size_t expect_hasty(const document::Recording& strokes, const document::Recording& past,
                             std::uint32_t seed) {
        EXPECT_TRUE(std::equal(past.events.begin(), past.events.end(), strokes.events.begin()));
        document::HastyPainter painter(seed);
        std::vector<Action> actions;
        std::size_t done = 0;
        const auto skip_to = [&](const Action* wanted) {
            for (;; ++done) {
                while (done >= actions.size())
                    for (Action& action : painter.next())
                        actions.push_back(std::move(action));
                if (wanted != nullptr && actions[done] == *wanted) return true;
                const bool may_be_idle = std::holds_alternative<document::Undo>(actions[done]) ||
                                         std::holds_alternative<document::Redo>(actions[done]);
                if (!may_be_idle) return false;
            }
        };
        for (std::size_t i = past.events.size(); i < strokes.events.size(); ++i) {
            const Action& action = strokes.events[i].action;
            const bool lifted = i + 1 == strokes.events.size() && action == Action(document::PenUp{});
            const bool expected = skip_to(&action);
            EXPECT_TRUE(expected || lifted) << "action " << i << " of seed " << seed;
            if (!expected) break;
            ++done;
        }
        skip_to(nullptr);
        return done;
    }

    void expect_whole_save(std::uint32_t seed, const document::Recording& past) {
        if (!fs::exists(folder / kSavedName)) return;
        const project::LoadedProject saved = project::load_project(folder / kSavedName, pool);
        EXPECT_THAT(saved.notes, IsEmpty());
        expect_hasty(saved.strokes, past, seed);
        EXPECT_EQ(hash_of_replay(saved.strokes), document::state_hash(saved.painting));
    }

    fs::path root;
    core::ThreadPool pool{1};
};

TEST_F(Kill, WhatWasDoneIsSoonKeptAndComesBack) {
    std::optional<Recovered> before;
    for (std::uint32_t seed = 0; seed < PASTOSO_KILLS; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        // Every other painting goes on from what was recovered of the one before.
        const fs::path start = before && seed % 4 != 0 ? folder / "start.pastoso" : fs::path();
        if (!start.empty()) project::save_project(start, *before, pool);
        const document::Recording past = start.empty() ? document::Recording{} : before->strokes;
        fs::remove(folder / kSavedName);

        // Up to a second of painting, and any moment between two writes of the journal.
        const auto actions = static_cast<std::size_t>(1.0 + 600.0 * core::uniform_noise(seed, 77));
        const auto more = static_cast<std::size_t>(100.0 * core::uniform_noise(seed, 78));
        const Progress least = paint_and_kill(seed, start, past.events.size(), actions, more);
        ASSERT_FALSE(HasFailure());
        const std::vector<fs::path> journals = abandoned_journals(root);
        ASSERT_THAT(journals, SizeIs(1));
        auto claim = Claim::on(journals.front());
        ASSERT_TRUE(claim);
        before = recover(claim->folder(), pool);
        EXPECT_THAT(before->notes, IsEmpty());

        EXPECT_GE(expect_hasty(before->strokes, past, seed), least.actions);
        EXPECT_GE(before->strokes.events.size(), least.events);
        EXPECT_GE(before->painting.tick, least.tick);
        EXPECT_EQ(hash_of_replay(before->strokes), document::state_hash(before->painting));
        expect_whole_save(seed, past);
        claim->discard();
        ASSERT_FALSE(HasFailure());
    }
}

}  // namespace
}  // namespace pastoso::journal
