// What tests of the liquids' subcommands have in common: looking at the files they leave.
#pragma once

#include "cli/run_program.hpp"
#include "core/resources.hpp"
#include "core/text_file.hpp"
#include "files/json_place.hpp"

#include <algorithm>

namespace pastoso::cli {

class LiquidTest : public CliTest {
  protected:
    std::vector<std::string> files_in(const std::string& name) const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(path(name)))
            names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        return names;
    }
    files::Json json(const std::string& name) const {
        return files::parse_json(core::read_text_file(path(name)), name);
    }
    std::string bytes(const std::string& name) const { return core::read_text_file(path(name)); }
};

/// pastoso-cli where no file may be larger than so many KiB, as on a disk that is full.
inline RunResult run_cli_on_full_disk(int most_kib, const std::vector<std::string>& arguments) {
    std::vector<std::string> limited = {
        "-c", "ulimit -f " + std::to_string(most_kib) + "; exec \"$@\"", "sh",
        (core::program_folder() / "pastoso-cli").string()};
    limited.insert(limited.end(), arguments.begin(), arguments.end());
    return run_program("/bin/bash", limited);
}

}  // namespace pastoso::cli
