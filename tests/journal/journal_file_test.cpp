#include "journal/journal_file.hpp"

#include "core/error.hpp"
#include "document/well_session.hpp"
#include "journal/frames.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pastoso::journal {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

JournalContent parsed(const std::string& file) {
    return parse_journal(std::as_bytes(std::span(file)), "journal");
}

std::string complaint(const std::string& file) {
    try {
        parsed(file);
    } catch (const core::InputError& error) {
        return error.what();
    }
    return "";
}

document::Recording part(const document::Recording& whole, std::size_t begin, std::size_t end) {
    const auto first = whole.events.begin();
    const bool last = end == whole.events.size();
    return {whole.canvas,
            {first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(end)},
            last ? whole.end_tick : whole.events[end - 1].tick};
}

/// The session's frames, three actions each, so that strokes are cut anywhere.
std::vector<std::string> frames_of_session(const document::Recording& session) {
    std::vector<std::string> frames;
    for (std::size_t begin = 0; begin < session.events.size(); begin += 3) {
        const std::size_t end = std::min(session.events.size(), begin + 3);
        frames.push_back(strokes_frame(begin, session.events[begin].tick, part(session, begin, end)));
    }
    return frames;
}

std::string joined(const std::vector<std::string>& frames) {
    std::string file;
    for (const std::string& frame : frames)
        file += frame;
    return file;
}

TEST(JournalFile, BatchesMakeTheWholeSession) {
    const document::Recording session = document::mixing_session();
    const JournalContent content = parsed(joined(frames_of_session(session)));
    ASSERT_THAT(content.runs, SizeIs(1));
    EXPECT_EQ(content.runs[0].recording, session);
}

TEST(JournalFile, TicksMayLieDaysAfterTheStart) {
    document::Recording late = document::mixing_session();
    constexpr std::int64_t kTenDays = 10LL * 86400 * 60;
    for (document::Event& event : late.events)
        event.tick += kTenDays;
    late.end_tick += kTenDays;
    const JournalContent content = parsed(joined(frames_of_session(late)));
    EXPECT_EQ(content.runs.at(0).recording, late);
}

TEST(JournalFile, AMissingBatchLeavesAGap) {
    const document::Recording session = document::mixing_session();
    std::vector<std::string> frames = frames_of_session(session);
    frames[4][30] ^= 1;
    const JournalContent content = parsed(joined(frames));
    ASSERT_THAT(content.runs, SizeIs(2));
    EXPECT_EQ(content.runs[0].end_event(), 12U);
    EXPECT_EQ(content.runs[1].first_event, 15U);
    EXPECT_EQ(content.damaged_at, joined({frames.begin(), frames.begin() + 4}).size());
}

TEST(JournalFile, HeaderCheckpointsAndSavesComeBack) {
    const Header header{"0.1.0", "/home/vera/still life.pastoso", "start.pastoso", 77, false};
    const JournalContent content =
        parsed(header_frame(header) + checkpoint_frame({"checkpoint-1.pastoso", 5, 90}) +
               saved_frame({"/a", 3}) + saved_frame({"/b", 6}));
    ASSERT_TRUE(content.header);
    EXPECT_EQ(content.header->painting, header.painting);
    EXPECT_EQ(content.header->start, header.start);
    EXPECT_EQ(content.header->start_tick, 77);
    EXPECT_FALSE(content.header->start_is_saved);
    ASSERT_THAT(content.checkpoints, SizeIs(1));
    EXPECT_EQ(content.checkpoints[0].events, 5U);
    EXPECT_EQ(content.checkpoints[0].tick, 90);
    EXPECT_EQ(content.saved->path, "/b");
    EXPECT_EQ(content.saved->events, 6U);
}

TEST(JournalFile, WhatNoneCanSayIsRefusedWithItsPlace) {
    EXPECT_EQ(complaint("not at all"), "journal: holds no actions of a painting.");
    EXPECT_EQ(complaint(""), "journal: holds no actions of a painting.");
    EXPECT_THAT(complaint(framed(FrameKind::Header, R"({"format": "pastoso-journal", "version": 9})")),
                HasSubstr("journal, byte 0: this was written by a newer Pastoso (journal format 9"));
    EXPECT_THAT(complaint(checkpoint_frame({"../../etc/passwd", 1, 1})),
                HasSubstr("expected the name of a file in the journal's folder"));
    EXPECT_THAT(complaint(framed(FrameKind::Strokes, "short")), HasSubstr("a batch is too short"));
    EXPECT_THAT(complaint(framed(static_cast<FrameKind>(9), "{}")),
                HasSubstr("there is no kind of frame 9"));
}

}  // namespace
}  // namespace pastoso::journal
