#include "cli/arguments.hpp"
#include "cli/option.hpp"
#include "cli/shared_arguments.hpp"
#include "core/text.hpp"
#include "recordings/scene_json.hpp"

#include <string>

namespace pastoso::cli {

void add_simulate(CLI::App& program, SimulateOptions& options) {
    CLI::App& command = *program.add_subcommand(
        "simulate", "Let a film of paint run without a brush, and write what is measured and seen");
    add_text(command, "SCENE", options.scene,
             "A scene file (.json), or the name of a scene that comes with the program")
        ->required();
    add_text(command, "-o,--output", options.output, "Folder for tables, heights and pictures")
        ->type_name("DIR")
        ->required();
    add_number(command, "--seconds", options.seconds, {0.0, 1e6},
               "Stop after this time; what the scene asks for later is left out")
        ->type_name("S");
    add_number(command, "--threads", options.threads, {0, 256},
               "Threads to use; 0: one per processor (default: the scene's own)")
        ->type_name("N");
    add_stats_option(command, options.stats);
    add_picture_options(command, options.picture);
    add_quiet_flag(command, options.quiet);
    command.footer([] {
        return "docs/scene-format.md describes scene files. Scenes that come with the program: " +
               core::listed(recordings::bundled_scene_names()) +
               ".\nExample:\n  pastoso-cli simulate paper-fig2 -o fig2";
    });
}

}  // namespace pastoso::cli
