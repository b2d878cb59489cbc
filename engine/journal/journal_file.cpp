#include "journal/journal_file.hpp"

#include "core/error.hpp"
#include "files/json_place.hpp"
#include "journal/frames.hpp"
#include "recordings/recording_json.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <limits>
#include <utility>

namespace pastoso::journal {
namespace {

using files::Json;
using files::JsonPlace;

constexpr const char* kFormat = "pastoso-journal";
constexpr std::int64_t kMostCounted = std::numeric_limits<std::int64_t>::max() / 4;

/// Stands before the recording in a frame of strokes.
struct BatchHead {
    std::uint64_t first_event;
    std::int64_t first_tick;
};

std::string text_of(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Files in the journal's folder have plain names: nothing else is ever opened.
std::string read_file_name(const JsonPlace& place) {
    std::string name = place.text();
    if (name.find('/') != std::string::npos || name.starts_with("."))
        place.fail("expected the name of a file in the journal's folder.");
    return name;
}

Header read_header(const JsonPlace& root) {
    if (root.entry("format").text() != kFormat) root.fail("this is no journal of a painting.");
    const std::int64_t version = root.entry("version").integer(1, INT32_MAX);
    if (version > kJournalFormatVersion) {
        root.fail(
            "this was written by a newer Pastoso (journal format %1; this program reads up to %2).",
            version, kJournalFormatVersion);
    }
    root.allow_only(
        {"format", "version", "program", "painting", "start", "start_tick", "start_is_saved"});
    Header header;
    header.program = root.entry("program").text();
    header.painting = root.entry("painting").text();
    header.start = read_file_name(root.entry("start"));
    header.start_tick = root.entry("start_tick").integer(0, kMostCounted);
    header.start_is_saved = root.entry("start_is_saved").boolean();
    return header;
}

Checkpoint read_checkpoint(const JsonPlace& root) {
    root.allow_only({"file", "events", "tick"});
    return {.file = read_file_name(root.entry("file")),
            .events = static_cast<std::uint64_t>(root.entry("events").integer(0, kMostCounted)),
            .tick = root.entry("tick").integer(0, kMostCounted)};
}

Saved read_saved(const JsonPlace& root) {
    root.allow_only({"path", "events"});
    return {.path = root.entry("path").text(),
            .events = static_cast<std::uint64_t>(root.entry("events").integer(0, kMostCounted))};
}

Run read_batch(const Frame& frame, const std::string& place) {
    BatchHead head{};
    if (frame.content.size() < sizeof head) throw core::InputError("%1: a batch is too short.", place);
    std::memcpy(&head, frame.content.data(), sizeof head);
    if (head.first_event > static_cast<std::uint64_t>(kMostCounted) || head.first_tick < 0 ||
        head.first_tick > kMostCounted)
        throw core::InputError("%1: a batch begins at an action or tick that cannot be.", place);
    Run batch{head.first_event,
              recordings::recording_from_json(frame.content.substr(sizeof head), place,
                                              recordings::Names::MayBeUnknown),
              frame.offset};
    for (document::Event& event : batch.recording.events)
        event.tick += head.first_tick;
    batch.recording.end_tick += head.first_tick;
    return batch;
}

void append(Run batch, std::vector<Run>& runs) {
    if (runs.empty() || runs.back().end_event() != batch.first_event ||
        runs.back().recording.end_tick > (batch.recording.events.empty()
                                              ? batch.recording.end_tick
                                              : batch.recording.events.front().tick)) {
        runs.push_back(std::move(batch));
        return;
    }
    document::Recording& last = runs.back().recording;
    last.events.insert(last.events.end(), std::make_move_iterator(batch.recording.events.begin()),
                       std::make_move_iterator(batch.recording.events.end()));
    last.end_tick = batch.recording.end_tick;
    last.arithmetic = std::min(last.arithmetic, batch.recording.arithmetic);
    runs.back().last_frame_at = batch.last_frame_at;
}

void add_frame(const Frame& frame, const std::string& name, JournalContent& content) {
    const std::string place = name + ", byte " + std::to_string(frame.offset);
    if (frame.kind == FrameKind::Strokes) return append(read_batch(frame, place), content.runs);
    const Json json = files::parse_json(frame.content, place);
    const JsonPlace root(json, place);
    switch (frame.kind) {
        case FrameKind::Header:
            content.header = read_header(root);
            return;
        case FrameKind::Checkpoint:
            content.checkpoints.push_back(read_checkpoint(root));
            return;
        case FrameKind::Saved:
            content.saved = read_saved(root);
            return;
        default:
            root.fail("there is no kind of frame %1.", static_cast<int>(frame.kind));
    }
}

}  // namespace

std::string header_frame(const Header& header) {
    return framed(FrameKind::Header, text_of({{"format", kFormat},
                                              {"version", kJournalFormatVersion},
                                              {"program", header.program},
                                              {"painting", header.painting},
                                              {"start", header.start},
                                              {"start_tick", header.start_tick},
                                              {"start_is_saved", header.start_is_saved}}));
}

std::string strokes_frame(std::uint64_t first_event, std::int64_t first_tick,
                          const document::Recording& batch) {
    document::Recording relative = batch;
    for (document::Event& event : relative.events)
        event.tick -= first_tick;
    relative.end_tick -= first_tick;
    const BatchHead head{first_event, first_tick};
    std::string content(reinterpret_cast<const char*>(&head), sizeof head);
    return framed(FrameKind::Strokes, content.append(recordings::recording_to_json(relative)));
}

std::string checkpoint_frame(const Checkpoint& checkpoint) {
    return framed(
        FrameKind::Checkpoint,
        text_of({{"file", checkpoint.file}, {"events", checkpoint.events}, {"tick", checkpoint.tick}}));
}

std::string saved_frame(const Saved& saved) {
    return framed(FrameKind::Saved, text_of({{"path", saved.path}, {"events", saved.events}}));
}

JournalContent parse_journal(std::span<const std::byte> file, const std::string& name) {
    const Frames frames = frames_of(file);
    if (frames.whole.empty()) throw core::InputError("%1: holds no actions of a painting.", name);
    JournalContent content;
    content.damaged_at = frames.damaged_at;
    for (const Frame& frame : frames.whole)
        add_frame(frame, name, content);
    return content;
}

}  // namespace pastoso::journal
