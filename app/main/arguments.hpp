// What stands on the command line.
#pragma once

#include <filesystem>
#include <optional>

namespace pastoso::main {

struct Arguments {
    std::optional<std::filesystem::path> file;  ///< a painting to open, or a recording to replay
    std::optional<std::filesystem::path>
        screenshot;        ///< where to save a picture of the window before leaving
    double after_s = 3.0;  ///< when to take it
    bool profile = false;  ///< tell at the end how long the painter waited
};

/// Reads the command line. Prints what --help or --version ask for, or what is wrong, and gives the exit
/// status to leave with.
struct ParsedArguments {
    Arguments arguments;
    std::optional<int> exit_status;
};
ParsedArguments parse_arguments(int argc, char** argv);

}  // namespace pastoso::main
