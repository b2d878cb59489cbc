// Writes whole paintings into a journal's folder, on a thread that takes only time that nobody needs.
#pragma once

#include "document/painting_state.hpp"
#include "journal/journal_file.hpp"

#include <atomic>
#include <deque>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>

namespace pastoso::journal {

class CheckpointWriter {
  public:
    /// Called on the writer's thread when a checkpoint is whole on the disk, or with what went wrong.
    using Written = std::function<void(const Checkpoint& checkpoint, const std::string& error)>;

    CheckpointWriter(std::filesystem::path folder, Written written)
        : folder_(std::move(folder)), written_(std::move(written)) {}
    ~CheckpointWriter() { wait(); }
    CheckpointWriter(const CheckpointWriter&) = delete;
    CheckpointWriter& operator=(const CheckpointWriter&) = delete;

    bool busy() const { return busy_; }

    /// How long the last one took; 0 before the first.
    double last_took_s() const { return last_took_s_; }

    /// The state after `events` actions. Not while busy().
    void write(document::PaintingState state, std::uint64_t events);

    void wait();

  private:
    void write_file(const document::PaintingState& state, std::uint64_t events);
    void remove_older();

    const std::filesystem::path folder_;
    const Written written_;
    int count_ = 0;
    std::deque<std::string> files_;  ///< of the checkpoints that are kept
    std::atomic<bool> busy_ = false;
    std::atomic<double> last_took_s_ = 0.0;
    std::thread thread_;
};

}  // namespace pastoso::journal
