// Writes whole paintings into a journal's folder, on a thread that takes only time that nobody needs.
#pragma once

#include "core/worker.hpp"
#include "document/painting_state.hpp"
#include "journal/journal_file.hpp"

#include <atomic>
#include <deque>
#include <filesystem>
#include <functional>
#include <string>

namespace pastoso::journal {

class CheckpointWriter {
  public:
    /// Called on the writer's thread when a checkpoint is whole on the disk, or with what went wrong.
    using Written = std::function<void(const Checkpoint& checkpoint, const core::Message& error)>;

    CheckpointWriter(std::filesystem::path folder, Written written);
    /// What is being written becomes whole.
    ~CheckpointWriter() { wait(); }

    bool busy() const { return worker_.busy(); }

    /// How long the last one took; 0 before the first.
    double last_took_s() const { return last_took_s_; }

    /// The state after `events` actions. Not while busy().
    void write(document::PaintingState state, std::uint64_t events);

    void wait() { worker_.wait(); }

  private:
    struct Job {
        document::PaintingState state;
        Checkpoint checkpoint;
    };

    void write_file(const Job& job);
    void remove_older();

    const std::filesystem::path folder_;
    const Written written_;
    int count_ = 0;
    std::deque<std::string> files_;  ///< of the checkpoints that are kept
    std::atomic<double> last_took_s_ = 0.0;
    core::Worker<Job> worker_;
};

}  // namespace pastoso::journal
