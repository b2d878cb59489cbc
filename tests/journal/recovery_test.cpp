#include "journal/recovery.hpp"

#include "core/error.hpp"
#include "core/message_text.hpp"
#include "core/text_file.hpp"
#include "document/well_session.hpp"
#include "files/temporary_folder.hpp"
#include "journal/journals.hpp"
#include "source_file.hpp"

#include <algorithm>
#include <fstream>
#include <span>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::journal {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Five strokes; after each, the number of actions so far.
document::Recording five_strokes(std::vector<std::size_t>& ends) {
    using namespace document;
    Recording recording;
    recording.canvas = small_canvas();
    recording.events = {{0, UseMedium{"soft-body acrylic"}},
                        {0, TiltCanvas{40, 90}},
                        {0, TakeBrush{"flat", 8, 1}},
                        {0, LoadPaint{.paint = {{{"PB29", 1.0}}}}}};
    std::int64_t tick = 0;
    for (int i = 0; i < 5; ++i) {
        const auto start_s = static_cast<double>(tick) * kTick_s;
        for (const Action& action : line_on(Surface::Canvas, start_s, 6, 34, 6 + 4.0 * i))
            recording.events.push_back({tick++, action});
        ends.push_back(recording.events.size());
    }
    recording.end_tick = tick + 10;
    return recording;
}

void expect_recording(const Recovered& recovered, const document::Recording& recording,
                      core::ThreadPool& pool) {
    EXPECT_EQ(recovered.strokes, recording);
    EXPECT_EQ(document::state_hash(recovered.painting), hash_of_replay(recording, pool));
    EXPECT_EQ(recovered.painting.tick, recording.end_tick);
    EXPECT_THAT(recovered.notes, IsEmpty());
}

class Recovery : public files::TemporaryFolder {
  protected:
    void change(const fs::path& file, const std::function<void(std::string&)>& change) {
        std::string bytes = core::read_text_file(file);
        change(bytes);
        std::ofstream(file, std::ios::binary) << bytes;
    }

    core::ThreadPool pool{1};
    std::vector<std::size_t> ends;
    document::Recording recording = five_strokes(ends);
};

TEST_F(Recovery, FromTheBareCanvas) {
    expect_recording(recover(left_behind(folder, recording, {}, pool), pool), recording, pool);
}

TEST_F(Recovery, FromTheLatestCheckpointAlone) {
    const fs::path journal = left_behind(folder, recording, {ends[0], ends[1], ends[3]}, pool);
    EXPECT_TRUE(fs::exists(journal / "checkpoint-3.pastoso"));
    std::vector<double> shares;
    expect_recording(recover(journal, pool, [&](double share) { shares.push_back(share); }), recording,
                     pool);
    EXPECT_LT(shares.size(), static_cast<std::size_t>(recording.end_tick) / 2);
    EXPECT_EQ(shares.back(), 1.0);
}

TEST_F(Recovery, OldCheckpointsGo) {
    const fs::path journal = left_behind(folder, recording, {ends.begin(), ends.end()}, pool);
    EXPECT_FALSE(fs::exists(journal / "checkpoint-1.pastoso"));
    EXPECT_FALSE(fs::exists(journal / "checkpoint-2.pastoso"));
    EXPECT_TRUE(fs::exists(journal / "checkpoint-3.pastoso"));
    EXPECT_TRUE(fs::exists(journal / "checkpoint-5.pastoso"));
}

TEST_F(Recovery, UndoBehindTheLatestCheckpointFallsBackOnOneBefore) {
    recording.events.push_back({recording.end_tick, document::Undo{}});
    recording.events.push_back({recording.end_tick, document::Undo{}});
    recording.end_tick += 5;
    expect_recording(recover(left_behind(folder, recording, {ends[1], ends[3]}, pool), pool), recording,
                     pool);
}

TEST_F(Recovery, AMissingCheckpointCostsTimeOnly) {
    const fs::path journal = left_behind(folder, recording, {ends[1], ends[3]}, pool);
    fs::remove(journal / "checkpoint-2.pastoso");
    expect_recording(recover(journal, pool), recording, pool);
}

TEST_F(Recovery, ADamagedCheckpointIsToldOf) {
    const fs::path journal = left_behind(folder, recording, {ends[3]}, pool);
    fs::resize_file(journal / "checkpoint-1.pastoso", 1000);
    const Recovered recovered = recover(journal, pool);
    EXPECT_EQ(document::state_hash(recovered.painting), hash_of_replay(recording, pool));
    EXPECT_THAT(core::texts_of(recovered.notes), ElementsAre(HasSubstr("checkpoint-1.pastoso")));
}

/// How many actions a frame holds depends on the writer's pace: four each from now on, so that a place in
/// the file is one in the painting.
void put_in_even_frames(std::string& bytes) {
    constexpr std::size_t kActions = 4;
    const JournalContent content = parse_journal(std::as_bytes(std::span(bytes)), "journal");
    const document::Recording& all = content.runs.at(0).recording;
    bytes = header_frame(content.header.value());
    for (std::size_t begin = 0; begin < all.events.size(); begin += kActions) {
        const std::size_t end = std::min(begin + kActions, all.events.size());
        document::Recording part = all;
        part.events.assign(all.events.begin() + static_cast<std::ptrdiff_t>(begin),
                           all.events.begin() + static_cast<std::ptrdiff_t>(end));
        if (end < all.events.size()) part.end_tick = part.events.back().tick;
        bytes += strokes_frame(begin, part.events.front().tick, part);
        for (const Checkpoint& checkpoint : content.checkpoints)
            if (begin < checkpoint.events && checkpoint.events <= end)
                bytes += checkpoint_frame(checkpoint);
    }
}

TEST_F(Recovery, DamageCostsWhatComesAfterIt) {
    const fs::path journal = left_behind(folder, recording, {}, pool);
    change(journal / kStrokesFile, put_in_even_frames);
    change(journal / kStrokesFile, [](std::string& bytes) { bytes[bytes.size() * 3 / 4] ^= 1; });
    const Recovered recovered = recover(journal, pool);
    EXPECT_EQ(document::state_hash(recovered.painting), hash_of_replay(recovered.strokes, pool));
    EXPECT_GT(recovered.strokes.events.size(), recording.events.size() / 4);
    ASSERT_THAT(recovered.notes, SizeIs(1));
    EXPECT_THAT(recovered.notes[0].text(), HasSubstr("strokes.journal, byte "));
    EXPECT_THAT(recovered.notes[0].text(), HasSubstr("actions after it are lost."));
}

TEST_F(Recovery, DamageBeforeACheckpointCostsTheStrokesAlone) {
    const fs::path journal = left_behind(folder, recording, {ends[3]}, pool);
    change(journal / kStrokesFile, put_in_even_frames);
    change(journal / kStrokesFile, [](std::string& bytes) { bytes[bytes.size() / 4] ^= 1; });
    const Recovered recovered = recover(journal, pool);
    EXPECT_EQ(document::state_hash(recovered.painting), hash_of_replay(recording, pool));
    EXPECT_THAT(recovered.strokes.events, IsEmpty());
    EXPECT_THAT(core::texts_of(recovered.notes),
                ElementsAre(HasSubstr("some of its strokes are missing")));
}

TEST_F(Recovery, ThatAPaintingIsOfAnEarlierArithmeticIsSaidOnce) {
    const fs::path old = tests::source_file("tests/project/format-3.pastoso");
    const document::PaintingState painting = project::load_project(old, pool).painting;
    fs::path journal;
    {
        JournalWriter writer(folder,
                             {.canvas = painting.value.bare->settings,
                              .tick = painting.tick,
                              .painting = old,
                              .write_start = [&](const fs::path& path) { fs::copy_file(old, path); }});
        writer.note({painting.tick, document::CleanBrush{}});
        journal = writer.folder();
    }
    EXPECT_THAT(core::texts_of(recover(journal, pool).notes),
                ElementsAre(HasSubstr("were painted with an earlier version of the program")));
}

TEST_F(Recovery, AStrokeInProgressEndsThere) {
    recording.events.resize(ends[2] - 10);
    recording.end_tick = recording.events.back().tick;
    const Recovered recovered = recover(left_behind(folder, recording, {ends[1]}, pool), pool);
    recording.events.push_back({recording.end_tick, document::PenUp{}});
    expect_recording(recovered, recording, pool);
}

TEST_F(Recovery, TellsWhatIsUnfinished) {
    left_behind(folder, recording, {ends[0]}, pool);
    const std::vector<Unfinished> paintings = unfinished_paintings(folder);
    ASSERT_THAT(paintings, SizeIs(1));
    EXPECT_EQ(paintings[0].changes, 5U);
    EXPECT_EQ(paintings[0].canvas, recording.canvas);
    EXPECT_EQ(paintings[0].tick, recording.end_tick);
    EXPECT_TRUE(paintings[0].thumbnail.starts_with("\x89PNG"));
    EXPECT_THAT(paintings[0].fault.text(), IsEmpty());
}

TEST_F(Recovery, UntouchedAndSavedPaintingsAreNoLongerThere) {
    recording.events.resize(4);
    left_behind(folder, recording, {}, pool);
    EXPECT_THAT(unfinished_paintings(folder), IsEmpty());
    EXPECT_EQ(files_in_folder(), 0U);
}

TEST_F(Recovery, WhatCannotBeReadIsToldAndStays) {
    const fs::path journal = left_behind(folder, recording, {}, pool);
    std::ofstream(journal / kStrokesFile) << "nothing";
    const std::vector<Unfinished> paintings = unfinished_paintings(folder);
    ASSERT_THAT(paintings, SizeIs(1));
    EXPECT_THAT(paintings[0].fault.text(), HasSubstr("strokes.journal: holds no actions"));
    EXPECT_THROW(recover(journal, pool), core::InputError);
}

}  // namespace
}  // namespace pastoso::journal
