// restless_painter FOLDER SEED [PROJECT]: paints in a session with a journal until it is killed, saving
// now and then, and tells in a file how far it is: lines of "actions events ticks" of what is certainly
// applied. An action that changes nothing, as Undo at the beginning, is no event of the recording.
#include "journal/restless_painter.hpp"

#include "document/hasty_painter.hpp"
#include "journal/recovery.hpp"
#include "project/project.hpp"
#include "session/paint_session.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <thread>

namespace pastoso {
namespace {

namespace fs = std::filesystem;

/// Many checkpoints in little time, by a painter as fast as a machine.
constexpr journal::Pace kHurried = {.flush_s = 0.06, .replay_s = 0.005, .idle_s = 0.05, .rests = 0.5};
constexpr std::chrono::milliseconds kBetweenActions{1};

std::unique_ptr<session::PaintSession> started(const fs::path& folder, const fs::path& project) {
    auto pool = std::make_unique<core::ThreadPool>(2);
    journal::Beginning beginning{.canvas = document::hasty_canvas()};
    std::unique_ptr<document::Painting> painting;
    document::Recording past;
    if (project.empty()) {
        painting = std::make_unique<document::Painting>(beginning.canvas, *pool);
    } else {
        project::LoadedProject loaded = project::load_project(project, *pool);
        painting = std::make_unique<document::Painting>(loaded.painting, *pool);
        past = loaded.strokes;
        beginning.tick = painting->tick();
        beginning.write_start = [&](const fs::path& path) { fs::copy_file(project, path); };
        beginning.is_saved = false;
    }
    auto writer =
        std::make_unique<journal::JournalWriter>(folder / journal::kJournalsName, beginning, kHurried);
    return std::make_unique<session::PaintSession>(std::move(pool), std::move(painting), nullptr,
                                                   std::move(past), false, std::move(writer));
}

class Saver {
  public:
    Saver(session::PaintSession& session, fs::path path) : session_(session), path_(std::move(path)) {}

    void save() {
        if (thread_.joinable()) thread_.join();
        thread_ = std::thread([this, capture = session_.capture()] {
            core::ThreadPool pool(1);
            project::save_project(path_, {capture.painting, capture.record.recording()}, pool);
            session_.note_saved(path_, capture.journal_events);
        });
    }

  private:
    session::PaintSession& session_;
    const fs::path path_;
    std::thread thread_;
};

[[noreturn]] void paint(const fs::path& folder, std::uint32_t seed, const fs::path& project) {
    const auto session = started(folder, project);
    document::HastyPainter painter(seed);
    Saver saver(*session, folder / journal::kSavedName);
    std::ofstream progress(folder / journal::kProgressName);
    std::size_t done = 0;
    for (int turn = 0;; ++turn) {
        for (const document::Action& action : painter.next()) {
            session->post(action);
            std::this_thread::sleep_for(kBetweenActions);
            if (++done % 8 != 0) continue;
            session->wait_until_applied();
            progress << done << ' ' << session->recording().events.size() << ' '
                     << session->status().tick << std::endl;
        }
        if (turn % 6 == 5) saver.save();
        for (const core::Message& error : session->take_errors())
            std::cerr << error.text() << std::endl;
    }
}

}  // namespace
}  // namespace pastoso

int main(int argc, char** argv) {
    if (argc < 3) return EXIT_FAILURE;
    pastoso::paint(argv[1], static_cast<std::uint32_t>(std::atoi(argv[2])), argc > 3 ? argv[3] : "");
}
