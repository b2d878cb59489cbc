// The part of ProjectFiles that puts up what the painter chooses, and first sees to what is on the
// easel.

#include "main/files/project_files.hpp"
#include "main/wait_cursor.hpp"
#include "recordings/recording_json.hpp"

#include <QAction>

namespace pastoso::main {
namespace {

/// Holds nothing that the painting does not know: a recording says itself how the canvas stands.
tools::Hand hand_at_first(tools::Hand hand) {
    hand.tilt = {};
    hand.air = {};
    hand.symmetry = {};
    hand.ruler.reset();
    hand.ellipse.reset();
    hand.guide = {};
    return hand;
}

}  // namespace

void ProjectFiles::watch(const document::Recording& recording) {
    const tools::Hand after = tools::hand_after(hand_at_first(studio_.easel().hand()), recording.events);
    start(recording.canvas);
    std::vector<document::Event> events = recording.events;
    const std::int64_t end = events.empty() ? 0 : events.back().tick;
    events.push_back({end, document::SetStabiliser{after.stabiliser}});
    QAction* pause = studio_.commands().action(commands::Command::Pause);
    if (pause->isChecked()) pause->trigger();
    watched_ = true;
    studio_.session().play(events, true);
    studio_.easel().lend_brush(true);
    studio_.easel().adopt(after);
    studio_.show_hand();
    studio_.show_published();
    tell_arithmetic(recording);
}

void ProjectFiles::ask_to_put_up(const document::CanvasSettings& canvas) {
    if (may_discard()) studio_.attempt(tr("New canvas"), [&] { new_canvas(canvas); });
}

bool ProjectFiles::ask_to_put_up_unsaved(std::shared_ptr<const project::Project> project) {
    if (!may_discard()) return false;
    return studio_.attempt(tr("Paint it again"), [&] {
        const WaitCursor waiting;
        put_up_unsaved(std::move(project));
    });
}

void ProjectFiles::ask_to_open(const QString& path) {
    if (may_discard()) try_to_open(path);
}

void ProjectFiles::ask_to_recover(const std::filesystem::path& journal) {
    if (!may_discard()) return;
    studio_.attempt(tr("Recover"), [&] {
        const WaitCursor waiting;
        recover_painting(journal);
    });
}

void ProjectFiles::ask_to_watch(const std::filesystem::path& recording) {
    if (!may_discard()) return;
    studio_.attempt(tr("Open"), [&] {
        watch(recordings::read_recording_json(recording));
        studio_.report(tr("Painted from its strokes; the brush is yours when it is done."));
    });
}

bool ProjectFiles::begun() const {
    return !path_.isEmpty() || saved_changes_ < 0 || studio_.session().status().changes > 0;
}

}  // namespace pastoso::main
