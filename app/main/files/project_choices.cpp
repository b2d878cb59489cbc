// The part of ProjectFiles that puts up what the painter chooses, and first sees to what is on the
// easel.

#include "main/files/project_files.hpp"
#include "recordings/recording_json.hpp"

#include <QAction>

namespace pastoso::main {
namespace {

/// Holds nothing that the painting does not know: a recording says itself how the canvas stands.
tools::Hand hand_at_first(tools::Hand hand) {
    hand.tilt = {};
    hand.air = {};
    hand.symmetry = {};
    hand.laid = {};
    hand.guide = {};
    return hand;
}

}  // namespace

void ProjectFiles::replay(const document::Recording& recording) {
    const auto play = [this, recording] {
        studio_.session().play(recording.events);
        studio_.easel().lend_brush(true);
        studio_.easel().adopt(tools::hand_after(studio_.easel().hand(), recording.events));
        studio_.show_hand();
        tell_arithmetic(recording);
    };
    if (recording.canvas == studio_.session().canvas()) return play();
    new_canvas(recording.canvas, play);
}

void ProjectFiles::replay_file(const std::filesystem::path& recording) {
    make_canvas_of(recording, [this](PreparedPainting& painting, const document::Recording& read) {
        put_up_new(painting);
        replay(read);
    });
}

void ProjectFiles::make_canvas_of(const std::filesystem::path& recording, const PutUpWith& put_up) {
    const QString name = QString::fromStdString(recording.filename().string());
    make(tr("Opening %1").arg(name), [=, terms = journal_terms()](const auto&) {
        const document::Recording read = recordings::read_recording_json(recording);
        const auto painting =
            std::make_shared<PreparedPainting>(bare_painting(read.canvas), journal::Beginning{}, terms);
        return [=] { put_up(*painting, read); };
    });
}

void ProjectFiles::put_up_watched(PreparedPainting& painting, const document::Recording& recording) {
    const tools::Hand after = tools::hand_after(hand_at_first(studio_.easel().hand()), recording.events);
    put_up(painting);
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
    if (may_discard()) new_canvas(canvas);
}

void ProjectFiles::ask_to_put_up_unsaved(std::shared_ptr<const project::Project> project,
                                         const Then& then) {
    if (may_discard()) put_up_unsaved(std::move(project), then);
}

void ProjectFiles::ask_to_close(const Then& then) {
    if (may_discard()) new_canvas(studio_.session().canvas(), then);
}

void ProjectFiles::ask_to_open(const QString& path) {
    if (may_discard()) open_painting(path);
}

void ProjectFiles::ask_to_recover(const std::filesystem::path& journal) {
    if (may_discard()) recover_painting(journal);
}

void ProjectFiles::ask_to_watch(const std::filesystem::path& recording) {
    if (!may_discard()) return;
    make_canvas_of(recording, [this](PreparedPainting& painting, const document::Recording& read) {
        put_up_watched(painting, read);
        studio_.report(tr("Painted from its strokes; the brush is yours when it is done."));
    });
}

bool ProjectFiles::begun() const {
    return !path_.isEmpty() || saved_changes_ < 0 || studio_.session().status().changes > 0;
}

}  // namespace pastoso::main
