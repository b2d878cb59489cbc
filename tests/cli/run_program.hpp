// Runs the real programs of the build.
#pragma once

#include "files/temporary_folder.hpp"

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

namespace pastoso::cli {

struct RunResult {
    int status = 0;
    std::string output, errors;
};

/// Runs `name` from the folder of the running test with its output and errors caught.
RunResult run_program(const std::string& name, const std::vector<std::string>& arguments);

/// Starts `name` and interrupts it, as Ctrl-C does or by another signal, as soon as `sign_of_work`
/// exists.
RunResult interrupt_program(const std::string& name, const std::vector<std::string>& arguments,
                            const std::filesystem::path& sign_of_work, int signal = SIGINT);

/// pastoso-cli with these arguments.
inline RunResult run_cli(const std::vector<std::string>& arguments) {
    return run_program("pastoso-cli", arguments);
}

/// A folder of its own, and files in it.
class CliTest : public files::TemporaryFolder {
  protected:
    std::string path(const std::string& name) const { return (folder / name).string(); }
    std::string write(const std::string& name, const std::string& text) const;

    /// A text recording of one short stroke in the middle of a small canvas.
    std::string short_recording() const;

    /// pastoso-cli fails with this status and one sentence on the error stream, and leaves no file
    /// behind.
    void expect_refusal(const std::vector<std::string>& arguments, int status,
                        const std::string& sentence) const;
};

/// Options that make a replay small and quick.
std::vector<std::string> small(const std::vector<std::string>& arguments);

}  // namespace pastoso::cli
