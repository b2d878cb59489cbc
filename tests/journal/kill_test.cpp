// A program that paints, saves, undoes and writes checkpoints is killed at random moments: what its
// journal gives is the painting of at most a second before, to the bit.
#include "core/random.hpp"
#include "document/painting.hpp"
#include "document/player.hpp"
#include "io/temporary_folder.hpp"
#include "journal/hasty_actions.hpp"
#include "journal/recovery.hpp"

#include <fstream>
#include <optional>
#include <signal.h>
#include <sys/wait.h>
#include <thread>
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

std::int64_t now_ns() {
    return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// What the killed program had certainly done at a moment.
struct Progress {
    std::size_t actions = 0;
    std::int64_t tick = 0;
};

Progress progress_at(const fs::path& file, std::int64_t when_ns) {
    std::ifstream lines(file);
    Progress latest, line;
    std::int64_t time_ns = 0;
    while (lines >> time_ns >> line.actions >> line.tick)
        if (time_ns <= when_ns) latest = line;
    return latest;
}

class Kill : public io::TemporaryFolder {
  protected:
    void SetUp() override {
        io::TemporaryFolder::SetUp();
        root = folder / kJournalsName;
    }

    /// Starts the painter, and kills it so long after its first actions. Returns the moment.
    std::int64_t paint_and_kill(std::uint32_t seed, const fs::path& project, double after_s) {
        fs::remove(folder / kProgressName);
        const std::string seed_text = std::to_string(seed);
        const pid_t child = ::fork();
        if (child == 0) {
            ::execl(PASTOSO_PAINTER, PASTOSO_PAINTER, folder.c_str(), seed_text.c_str(),
                    project.empty() ? nullptr : project.c_str(), nullptr);
            ::_exit(127);
        }
        while (progress_at(folder / kProgressName, now_ns()).actions == 0) {
            if (::waitpid(child, nullptr, WNOHANG) != 0) ADD_FAILURE() << "the painter ended by itself";
            if (HasFailure()) return 0;
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        std::this_thread::sleep_for(std::chrono::duration<double>(after_s));
        const std::int64_t killed_ns = now_ns();
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        return killed_ns;
    }

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
        HastyPainter painter(seed);
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

TEST_F(Kill, LosesAtMostTheLastSecond) {
    constexpr std::int64_t kSecond_ns = 1'000'000'000;
    std::optional<Recovered> before;
    for (std::uint32_t seed = 0; seed < PASTOSO_KILLS; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        // Every other painting goes on from what was recovered of the one before.
        const fs::path start = before && seed % 4 != 0 ? folder / "start.pastoso" : fs::path();
        if (!start.empty()) project::save_project(start, *before, pool);
        const document::Recording past = start.empty() ? document::Recording{} : before->strokes;
        fs::remove(folder / kSavedName);

        const double after_s = 3.0 * core::uniform_noise(seed, 77);
        const std::int64_t killed_ns = paint_and_kill(seed, start, after_s);
        ASSERT_FALSE(HasFailure());
        const std::vector<fs::path> journals = abandoned_journals(root);
        ASSERT_THAT(journals, SizeIs(1));
        auto claim = Claim::on(journals.front());
        ASSERT_TRUE(claim);
        before = recover(claim->folder(), pool);
        EXPECT_THAT(before->notes, IsEmpty());

        const Progress least = progress_at(folder / kProgressName, killed_ns - kSecond_ns);
        EXPECT_GE(expect_hasty(before->strokes, past, seed), least.actions);
        EXPECT_GE(before->painting.tick, least.tick);
        EXPECT_EQ(hash_of_replay(before->strokes), document::state_hash(before->painting));
        expect_whole_save(seed, past);
        claim->discard();
        ASSERT_FALSE(HasFailure());
    }
}

}  // namespace
}  // namespace pastoso::journal
