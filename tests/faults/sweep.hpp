// A writer on a disk that fails, call by call and byte by byte.
#pragma once

#include "core/temporary_folder.hpp"
#include "faults/writers.hpp"

#include <map>
#include <string>
#include <vector>

namespace pastoso::cli {
struct RunResult;
}

namespace pastoso::faults {

/// Whatever call fails and wherever the disk ends: a file is the old one or the whole new one, the status and one
/// sentence say that it failed, nothing else is left, and another run makes it good. Every check is one of GoogleTest's.
class Sweep {
  public:
    /// Runs the writer once without a fault.
    Sweep(const Writer& writer, const std::filesystem::path& inputs);

    /// How many calls can fail, from 1, and how many bytes it writes.
    long calls() const { return calls_; }
    long bytes() const { return bytes_; }

    void fail_call(long call) const;
    void fail_behind(long bytes) const;

  private:
    void put_old_files() const;
    cli::RunResult run(const std::string& call, const std::string& bytes) const;
    void fail(const std::string& call, const std::string& bytes) const;
    std::vector<std::string> arguments() const;
    void check_sentence(const cli::RunResult& run) const;
    void check_files(bool new_alone) const;

    const Writer& writer_;
    std::filesystem::path inputs_;
    tests::TemporaryFolder folder_;
    std::filesystem::path outputs_;
    std::map<std::string, std::string> new_;  ///< what it writes, by name
    long calls_ = 0, bytes_ = 0;
};

}  // namespace pastoso::faults
