#include "main/files/recorder.hpp"

#include "journal/undo_reach.hpp"
#include "main/files/replay_window.hpp"
#include "panels/history/recorder_panel.hpp"

#include <algorithm>
#include <utility>

#include <QMainWindow>

namespace pastoso::main {
namespace {

using commands::Command;

std::int64_t strokes_in(const document::Recording& recording) {
    return std::count_if(recording.events.begin(), recording.events.end(), [](const auto& event) {
        return std::holds_alternative<document::PenDown>(event.action);
    });
}

}  // namespace

Recorder::Recorder(Studio& studio, panels::RecorderPanel* panel) : studio_(studio), panel_(panel) {
    studio_.commands().on(Command::Play, [this](bool) { watch(); });
    connect(&studio_, &Studio::session_begun, this,
            [this] { past_strokes_ = strokes_in(studio_.session().recording()); });
    connect(&studio_, &Studio::published, this, [this](const auto&, const session::Status& status) {
        panel_->show_recorded(past_strokes_ + status.strokes,
                              static_cast<double>(status.tick) * document::kTick_s);
    });
}

ReplayWindow* Recorder::replay_window() const {
    return qobject_cast<ReplayWindow*>(window_.data());
}

/// As it is recorded until now; what is painted while it is watched is not in it.
void Recorder::watch() {
    document::Recording recording = studio_.session().recording();
    const auto& events = recording.events;
    const bool has_strokes = std::any_of(events.begin(), events.end(), [](const auto& event) {
        return document::traits_of(event.action).changes_painting;
    });
    if (!has_strokes)
        return studio_.report(tr("Nothing has been painted yet that could be shown again."));
    if (ReplayWindow* open = replay_window()) open->close();
    auto* window = new ReplayWindow(std::move(recording), studio_.canvas(), &studio_.window());
    window_ = window;
    window->show();
}

}  // namespace pastoso::main
