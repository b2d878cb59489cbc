#include "journal/checkpoint_writer.hpp"

#include "core/check.hpp"
#include "core/thread_pool.hpp"
#include "project/project.hpp"

#include <chrono>
#include <utility>

namespace pastoso::journal {
namespace {

/// One that Undo has reached behind serves no more; then the one before it does.
constexpr std::size_t kKept = 3;

/// Checkpoints take only time that nobody needs.
constexpr int kNice = 15;

}  // namespace

CheckpointWriter::CheckpointWriter(std::filesystem::path folder, Written written)
    : folder_(std::move(folder)),
      written_(std::move(written)),
      worker_([this](Job& job) { write_file(job); },
              [this](Job& job, const core::Message& fault) { written_(job.checkpoint, fault); }, kNice) {
}

void CheckpointWriter::write(document::PaintingState state, std::uint64_t events) {
    PASTOSO_CHECK(!busy());
    const Checkpoint checkpoint{"checkpoint-" + std::to_string(++count_) + ".pastoso", events,
                                state.tick};
    worker_.add({std::move(state), checkpoint});
}

/// Without strokes: those are in the journal already.
void CheckpointWriter::write_file(const Job& job) {
    const auto begin = std::chrono::steady_clock::now();
    const document::PaintingState& state = job.state;
    core::ThreadPool pool(1);
    project::save_project(folder_ / job.checkpoint.file, {state, {state.value.bare->settings, {}, state.tick}},
                          pool);
    written_(job.checkpoint, {});
    files_.push_back(job.checkpoint.file);
    remove_older();
    last_took_s_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void CheckpointWriter::remove_older() {
    for (; files_.size() > kKept; files_.pop_front()) {
        std::error_code ignored;
        std::filesystem::remove(folder_ / files_.front(), ignored);
    }
}

}  // namespace pastoso::journal
