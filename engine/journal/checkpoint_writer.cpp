#include "journal/checkpoint_writer.hpp"

#include "core/background_thread.hpp"
#include "core/check.hpp"
#include "core/thread_pool.hpp"
#include "project/project.hpp"

#include <chrono>
#include <exception>
#include <utility>

namespace pastoso::journal {
namespace {

/// One that Undo has reached behind serves no more; then the one before it does.
constexpr std::size_t kKept = 3;

/// Checkpoints take only time that nobody needs.
constexpr int kNice = 15;

}  // namespace

void CheckpointWriter::write(document::PaintingState state, std::uint64_t events) {
    PASTOSO_CHECK(!busy_);
    wait();
    busy_ = true;
    thread_ = std::thread([this, state = std::move(state), events] {
        core::lower_priority(kNice);
        const auto begin = std::chrono::steady_clock::now();
        write_file(state, events);
        last_took_s_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        busy_ = false;
    });
}

void CheckpointWriter::wait() {
    if (thread_.joinable()) thread_.join();
}

/// Without strokes: those are in the journal already.
void CheckpointWriter::write_file(const document::PaintingState& state, std::uint64_t events) {
    const Checkpoint checkpoint{"checkpoint-" + std::to_string(++count_) + ".pastoso", events,
                                state.tick};
    try {
        core::ThreadPool pool(1);
        project::save_project(folder_ / checkpoint.file, {state, {state.settings, {}, state.tick}},
                              pool);
        written_(checkpoint, {});
        files_.push_back(checkpoint.file);
        remove_older();
    } catch (const std::exception& failure) {
        written_(checkpoint, failure.what());
    }
}

void CheckpointWriter::remove_older() {
    for (; files_.size() > kKept; files_.pop_front()) {
        std::error_code ignored;
        std::filesystem::remove(folder_ / files_.front(), ignored);
    }
}

}  // namespace pastoso::journal
