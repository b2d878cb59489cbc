#include "cli/arguments.hpp"
#include "cli/option.hpp"
#include "cli/shared_arguments.hpp"
#include "core/text.hpp"
#include "liquid_files/tank_json.hpp"

namespace pastoso::cli {

void add_tank(CLI::App& program, TankOptions& options) {
    CLI::App& command =
        *program.add_subcommand("tank", "Let liquid move in a glass tank, measure it and draw it");
    add_text(command, "SCENE", options.scene,
             "A scene file (.json), or the name of one that comes with the program")
        ->required();
    add_time_options(command, options.seconds, options.fps);
    add_text(command, "--method", options.method,
             "How the liquid is followed, in place of what the scene says: " +
                 core::listed(liquid_files::tank_method_names()))
        ->type_name("NAME")
        ->check(CLI::IsMember(liquid_files::tank_method_names()));
    add_text(command, "--frames", options.frames,
             "Folder for liquid_0001.png and so on, and for series.csv, what is measured at each "
             "frame; a run that was stopped goes on there")
        ->type_name("DIR");
    add_checkpoint_option(command, options.checkpoint_s);
    add_frame_file_options(
        command, options.files, {"png", "exr", "jpg", "tif", "webp", "obj", "ply", "stl", "pbrt", "vdb"},
        "Pictures: png, exr, jpg, tif, webp; the liquid's surface: obj, ply, stl, pbrt; or volumes, "
        "where built with OpenVDB: vdb");
    add_threads_option(command, options.threads);
    add_stats_option(command, options.stats);
    add_quiet_flag(command, options.quiet);
    command.footer([] {
        return "docs/tank-format.md describes scene files. Scenes that come with the program: " +
               core::listed(liquid_files::bundled_tank_names()) +
               ".\nExample:\n  pastoso-cli tank falling-liquid --seconds 2 --frames falling\n"
               "  pastoso-cli tank two-liquids --frames two --format obj --stats two.json";
    });
}

}  // namespace pastoso::cli
