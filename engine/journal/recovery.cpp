#include "journal/recovery.hpp"

#include "core/error.hpp"
#include "core/looking.hpp"
#include "core/text_file.hpp"
#include "document/painting.hpp"
#include "document/player.hpp"
#include "journal/undo_reach.hpp"
#include "project/pictures.hpp"
#include "recordings/canvas_support.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace pastoso::journal {
namespace {

namespace fs = std::filesystem;

/// Hours of painting.
constexpr std::size_t kMostJournalBytes = std::size_t{1} << 30;

/// What of a recovery loading a checkpoint takes, about.
constexpr double kLoading = 0.3;

JournalContent read_journal(const fs::path& folder) {
    const fs::path path = folder / kStrokesFile;
    const std::string text = core::read_text_file(path, kMostJournalBytes);
    return parse_journal(std::as_bytes(std::span(text)), path.string());
}

/// Where a replay may begin, and how far it gets exactly.
struct Candidate {
    std::string file{};  ///< empty: the bare canvas
    std::uint64_t events = 0;
    std::int64_t tick = 0;
    bool is_start = true;      ///< Undo cannot reach behind it
    const Run* run = nullptr;  ///< that goes on from there; may be null
    std::uint64_t end_event = 0;
};

const Run* run_from(const JournalContent& content, std::uint64_t event) {
    for (const Run& run : content.runs)
        if (run.first_event <= event && event <= run.end_event()) return &run;
    return nullptr;
}

void look_ahead(const JournalContent& content, Candidate& candidate) {
    candidate.run = run_from(content, candidate.events);
    candidate.end_event = candidate.events;
    if (candidate.run == nullptr) return;
    const Run& run = *candidate.run;
    UndoReach reach;
    for (; candidate.end_event < run.end_event(); ++candidate.end_event) {
        reach.note(run.recording.events[candidate.end_event - run.first_event].action);
        if (reach.crossed() && !candidate.is_start) return;
    }
}

/// The best first: those that get furthest, of these the latest.
std::vector<Candidate> candidates(const JournalContent& content) {
    std::vector<Candidate> all;
    if (content.header) all.push_back({content.header->start, 0, content.header->start_tick, true});
    for (const Checkpoint& checkpoint : content.checkpoints)
        all.push_back({checkpoint.file, checkpoint.events, checkpoint.tick, false});
    for (Candidate& candidate : all)
        look_ahead(content, candidate);
    std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
        return a.end_event != b.end_event ? a.end_event > b.end_event : a.events > b.events;
    });
    return all;
}

/// The actions from the candidate on, as far as they follow it.
document::Recording actions_of(const Candidate& candidate) {
    if (candidate.run == nullptr) return {{}, {}, candidate.tick};
    const Run& run = *candidate.run;
    const auto at = [&](std::uint64_t event) {
        return run.recording.events.begin() + static_cast<std::ptrdiff_t>(event - run.first_event);
    };
    document::Recording actions{
        run.recording.canvas, {at(candidate.events), at(candidate.end_event)}, 0};
    const std::int64_t last_tick =
        actions.events.empty() ? candidate.tick : std::max(candidate.tick, actions.events.back().tick);
    const bool whole = candidate.end_event == run.end_event();
    actions.end_tick = whole ? std::max(last_tick, run.recording.end_tick) : last_tick;
    return actions;
}

std::unique_ptr<document::Painting> painting_at(const fs::path& folder, const Candidate& candidate,
                                                const JournalContent& content, core::ThreadPool& pool,
                                                const core::Progress& progress,
                                                std::vector<core::Message>& notes) {
    if (candidate.file.empty()) {
        if (candidate.run == nullptr || candidate.tick != 0)
            throw core::InputError("%1: does not say what was painted on.",
                                   (folder / kStrokesFile).string());
        return recordings::make_painting(content.runs.front().recording.canvas, pool);
    }
    project::LoadedProject start = project::load_project(folder / candidate.file, pool, progress);
    if (start.painting.tick != candidate.tick)
        throw core::InputError("%1: is of another moment.", (folder / candidate.file).string());
    notes.insert(notes.end(), start.notes.begin(), start.notes.end());
    return std::make_unique<document::Painting>(start.painting, pool);
}

/// What could be replayed, with the pen lifted; an action that does not follow ends it.
document::Recording played(document::Painting& painting, document::Recording actions,
                           const core::Progress& progress, std::vector<core::Message>& notes) {
    painting.keep_undo_steps(document::undo_depth(actions));
    std::size_t applied = 0;
    const std::int64_t first_tick = painting.tick();
    try {
        while (true) {
            for (; applied < actions.events.size() && actions.events[applied].tick <= painting.tick();
                 ++applied)
                painting.apply(actions.events[applied].action);
            if (painting.tick() >= actions.end_tick) break;
            painting.advance_tick();
            if (progress)
                progress(static_cast<double>(painting.tick() - first_tick) /
                         static_cast<double>(actions.end_tick - first_tick));
        }
    } catch (const core::InputError& error) {
        notes.push_back(core::message(
            "The painting is recovered up to an action that cannot be repeated: %1", error.message()));
        actions.events.resize(applied);
    }
    if (painting.stroke_in_progress()) {
        painting.apply(document::PenUp{});
        actions.events.push_back({painting.tick(), document::PenUp{}});
    }
    actions.end_tick = painting.tick();
    return actions;
}

core::Message damaged_place(const fs::path& folder, const JournalContent& content) {
    const std::string file = (folder / kStrokesFile).string();
    return content.damaged_at ? core::message("%1, byte %2", file, *content.damaged_at)
                              : core::Message::verbatim(file);
}

/// The start may have been told of already, as a painting.
void add_new(const std::vector<core::Message>& told, std::vector<core::Message>& notes) {
    for (const core::Message& note : told)
        if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
}

/// All strokes since the canvas was bare, if there is no gap among them.
std::optional<document::Recording> strokes_before(const fs::path& folder, const Candidate& candidate,
                                                  const JournalContent& content,
                                                  std::vector<core::Message>& notes) {
    const Run* run = run_from(content, 0);
    if (!content.header || run == nullptr || run->end_event() < candidate.events) return std::nullopt;
    document::Recording strokes{run->recording.canvas, {}, 0};
    if (!content.header->start.empty()) {
        std::vector<core::Message> told;
        strokes = project::load_strokes(folder / content.header->start, told);
        add_new(told, notes);
    }
    strokes.arithmetic = std::min(strokes.arithmetic, run->recording.arithmetic);
    strokes.events.insert(strokes.events.end(), run->recording.events.begin(),
                          run->recording.events.begin() +
                              static_cast<std::ptrdiff_t>(candidate.events - run->first_event));
    return strokes;
}

void add_strokes(const fs::path& folder, const Candidate& candidate, const JournalContent& content,
                 const document::Recording& played, Recovered& recovered) {
    std::optional<document::Recording> before;
    try {
        before = strokes_before(folder, candidate, content, recovered.notes);
    } catch (const core::InputError& error) {
        recovered.notes.push_back(error.message());
    }
    if (before) {
        recovered.strokes = std::move(*before);
        recovered.strokes.events.insert(recovered.strokes.events.end(), played.events.begin(),
                                        played.events.end());
    } else {
        recovered.strokes.canvas = recovered.painting.value.bare->settings;
        recovered.notes.push_back(core::message(
            "%1: is damaged; the painting is there, but some of its strokes are missing, so "
            "that they cannot be replayed.",
            damaged_place(folder, content)));
    }
    recovered.strokes.end_tick = played.end_tick;
}

void tell_arithmetic(const Candidate& candidate, std::vector<core::Message>& notes) {
    if (candidate.run == nullptr || candidate.end_event == candidate.events) return;
    const core::Message older = document::arithmetic_note(candidate.run->recording.arithmetic);
    if (!older.empty()) notes.push_back(core::message("The latest strokes %1", older));
}

void tell_losses(const fs::path& folder, const Candidate& candidate, const JournalContent& content,
                 std::vector<core::Message>& notes) {
    std::uint64_t end = candidate.end_event;
    for (const Run& run : content.runs)
        end = std::max(end, run.end_event());
    if (end == candidate.end_event) return;
    const std::uint64_t lost = end - candidate.end_event;
    const core::Message place = damaged_place(folder, content);
    notes.push_back(lost == 1
                        ? core::message("%1: is damaged; 1 action after it is lost.", place)
                        : core::message("%1: is damaged; %2 actions after it are lost.", place, lost));
}

/// The one that the painter saved it to or opened.
std::string project_file_of(const JournalContent& content) {
    if (content.saved) return content.saved->path;
    return content.header ? content.header->painting : "";
}

Recovered recovered_from(const fs::path& folder, const Candidate& candidate,
                         const JournalContent& content, core::ThreadPool& pool,
                         const core::Progress& progress) {
    Recovered recovered;
    recovered.file = project_file_of(content);
    const double begun = candidate.file.empty() ? 0.0 : kLoading;
    const auto painting = painting_at(folder, candidate, content, pool,
                                      core::part_of(progress, 0.0, begun), recovered.notes);
    const document::Recording actions =
        played(*painting, actions_of(candidate), core::part_of(progress, begun, 1.0), recovered.notes);
    recovered.painting = painting->state();
    add_strokes(folder, candidate, content, actions, recovered);
    tell_arithmetic(candidate, recovered.notes);
    tell_losses(folder, candidate, content, recovered.notes);
    return recovered;
}

/// Those that the painter has not saved.
std::size_t unsaved_changes(const JournalContent& content) {
    const std::uint64_t saved = content.saved ? content.saved->events : 0;
    std::size_t changes = 0;
    for (const Run& run : content.runs) {
        for (std::size_t i = 0; i < run.recording.events.size(); ++i)
            changes +=
                run.first_event + i >= saved && document::traits_of(run.recording.events[i].action).changes_painting ? 1 : 0;
    }
    const bool start_is_saved = content.header && content.header->start_is_saved;
    return changes + (content.saved || start_is_saved ? 0 : 1);
}

/// Of the latest checkpoint that is there, or the start.
std::string thumbnail_in(const fs::path& folder, const JournalContent& content) {
    std::vector<std::string> files;
    for (const Checkpoint& checkpoint : content.checkpoints)
        files.insert(files.begin(), checkpoint.file);
    if (content.header && !content.header->start.empty()) files.push_back(content.header->start);
    for (const std::string& file : files) {
        try {
            return project::load_thumbnail(folder / file);
        } catch (const core::InputError&) {
            continue;
        }
    }
    return {};
}

Unfinished described(const fs::path& folder) {
    Unfinished painting{.folder = folder, .last_painted = last_written(folder)};
    try {
        const JournalContent content = read_journal(folder);
        painting.painting = project_file_of(content);
        painting.changes = unsaved_changes(content);
        painting.damaged = content.damaged_at.has_value();
        if (!content.runs.empty()) {
            painting.canvas = content.runs.back().recording.canvas;
            painting.tick = content.runs.back().recording.end_tick;
        }
        painting.thumbnail = thumbnail_in(folder, content);
    } catch (const core::InputError& error) {
        painting.fault = error.message();
    }
    return painting;
}

}  // namespace

std::vector<Unfinished> unfinished_paintings(const fs::path& root) {
    std::vector<Unfinished> paintings;
    for (const fs::path& folder : abandoned_journals(root)) {
        Unfinished painting = described(folder);
        if (painting.fault.empty() && painting.changes == 0 && !painting.damaged) {
            if (auto claim = Claim::on(folder)) claim->discard();
            continue;
        }
        paintings.push_back(std::move(painting));
    }
    return paintings;
}

Recovered recover(const fs::path& folder, core::ThreadPool& pool, const core::Progress& progress) {
    const JournalContent content = read_journal(folder);
    std::vector<core::Message> faults;
    for (const Candidate& candidate : candidates(content)) {
        if (!candidate.file.empty() && !core::is_there(folder / candidate.file)) continue;
        try {
            Recovered recovered = recovered_from(folder, candidate, content, pool, progress);
            recovered.notes.insert(recovered.notes.begin(), faults.begin(), faults.end());
            return recovered;
        } catch (const core::InputError& error) {
            faults.push_back(error.message());
        }
    }
    if (!faults.empty()) throw core::InputError(faults.front());
    throw core::InputError("%1: does not say what was painted on.", (folder / kStrokesFile).string());
}

std::string recovered_thumbnail(const fs::path& folder, core::ThreadPool& pool,
                                const core::Progress& progress) {
    return project::thumbnail_file(recover(folder, pool, progress).painting, pool);
}

}  // namespace pastoso::journal
