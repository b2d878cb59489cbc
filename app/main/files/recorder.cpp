#include "main/files/recorder.hpp"

#include "main/files/replay_window.hpp"
#include "panels/history/recorder_panel.hpp"

#include <utility>

#include <QMainWindow>

namespace pastoso::main {
namespace {

using commands::Command;

}  // namespace

Recorder::Recorder(Studio& studio, panels::RecorderPanel* panel) : studio_(studio), panel_(panel) {
    studio_.commands().on(Command::Play, [this](bool) { watch(); });
    connect(&studio_, &Studio::session_begun, this,
            [this] { past_strokes_ = studio_.session().record().strokes(); });
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
    const document::Recorder record = studio_.session().record();
    if (!record.changes_painting())
        return studio_.report(tr("Nothing has been painted yet that could be shown again."));
    if (ReplayWindow* open = replay_window()) open->close();
    auto* window = new ReplayWindow(record.recording(), studio_.canvas(), &studio_.window());
    window_ = window;
    window->show();
}

}  // namespace pastoso::main
