// The programs as they are installed, in a folder that is no more than moved there.
#pragma once

#include "cli/run_program.hpp"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace pastoso::install {

class Installed : public cli::CliTest {
  protected:
    /// Installs `components`, or all without one, as packages do: into a folder that stands for the
    /// root, as if for /usr. What is the /usr there is then moved to `prefix`, so that nothing can hold
    /// on to a place.
    void install(const std::filesystem::path& prefix,
                 const std::vector<std::string>& components = {}) const;

    /// An installed program or one of the system, away from the build: nothing but HOME tells it where
    /// to look.
    cli::RunResult run(const std::string& program, const std::vector<std::string>& arguments) const;
};

/// All files below it, as paths from there.
std::set<std::string> files_below(const std::filesystem::path& folder);

}  // namespace pastoso::install
