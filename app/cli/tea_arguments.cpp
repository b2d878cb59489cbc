#include "cli/arguments.hpp"
#include "cli/option.hpp"
#include "cli/shared_arguments.hpp"
#include "core/text.hpp"
#include "liquid/tea/tea_settings.hpp"
#include "liquid_files/tea_json.hpp"

namespace pastoso::cli {
namespace {

void add_tea_file_options(CLI::App& command, FrameFileOptions& options) {
    add_frame_file_options(
        command, options,
        {"png", "exr", "jpg", "tif", "webp", "obj", "ply", "stl", "pbrt", "pbrt-scene", "vdb"},
        "Pictures: png, exr, jpg, tif, webp; the milk's surface: obj, ply, stl, pbrt; a whole scene for "
        "PBRT: pbrt-scene; or volumes, where built with OpenVDB: vdb");
    add_number(command, "--pbrt", options.pbrt_syntax, {2, 4},
               "PBRT's version that .pbrt files are for: 4, 3, 2")
        ->type_name("N")
        ->capture_default_str();
}

void add_milk_option(CLI::App& command, std::string& milk) {
    add_text(
        command, "--milk", milk,
        "How pictures draw milk that has not dissolved: as a share of the liquid, or as a body with "
        "a surface")
        ->type_name("medium|surface")
        ->capture_default_str()
        ->check(CLI::IsMember({"medium", "surface"}));
}

void add_render(CLI::App& tea, TeaRenderOptions& options) {
    CLI::App& command = *tea.add_subcommand("render", "Draw frames that were kept, or any part of them");
    add_text(command, "CACHE", options.cache, "The folder that \"tea --cache\" filled")->required();
    add_text(command, "--range", options.range, "Frames to draw, for example 1-1350; all otherwise")
        ->type_name("A-B");
    add_text(command, "--frames", options.frames,
             "Folder for milk_0001.png and so on; what is there already is kept")
        ->type_name("DIR")
        ->required();
    add_tea_file_options(command, options.files);
    add_milk_option(command, options.milk);
    add_threads_option(command, options.threads);
    add_stats_option(command, options.stats);
    add_quiet_flag(command, options.quiet);
    command.footer("Example:\n  pastoso-cli tea render kept --range 1-450 --frames tea");
}

}  // namespace

void add_tea(CLI::App& program, TeaOptions& options, TeaRenderOptions& render) {
    CLI::App& command =
        *program.add_subcommand("tea", "Pour milk into a glass of tea, and draw what becomes of it");
    add_text(command, "SCENE", options.scene,
             "A scene file (.json), or the name of one that comes with the program; otherwise "
             "the usual glass");
    add_time_options(command, options.seconds, options.fps);
    add_number(command, "--grid", options.cells, {liquid::kMinTeaCells, liquid::kMaxTeaCells},
               "Cells along each side of the box")
        ->type_name("N");
    add_number(command, "--parcels", options.parcels, {1.0, static_cast<double>(liquid::kMaxParcels)},
               "Parcels that the milk is divided into")
        ->type_name("N");
    add_number(command, "--seed", options.seed, {0.0, 4294967295.0}, "Another number, another glass")
        ->type_name("N");
    command.add_flag(
        "--classic", options.classic,
        "The system of 2010 as it was, 6 cells a side and 1000 particles in a periodic box; "
        "with --grid the same on today's solver");
    add_text(command, "--frames", options.frames,
             "Folder for milk_0001.png and so on; what is there already is kept")
        ->type_name("DIR");
    add_text(command, "--cache", options.cache, "Folder to keep frames in, for \"tea render\"")
        ->type_name("DIR");
    add_checkpoint_option(command, options.checkpoint_s);
    add_tea_file_options(command, options.files);
    add_milk_option(command, options.milk);
    add_threads_option(command, options.threads);
    add_stats_option(command, options.stats);
    add_quiet_flag(command, options.quiet);
    add_render(command, render);
    command.footer([] {
        return "docs/tea-format.md describes scene files. Scenes that come with the program: " +
               core::listed(liquid_files::bundled_tea_names()) +
               ".\nExample:\n  pastoso-cli tea --frames tea --every 30\n"
               "  pastoso-cli tea --cache kept\n"
               "  pastoso-cli tea render kept --frames tea";
    });
}

}  // namespace pastoso::cli
