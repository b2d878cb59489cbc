#include "cli/arguments.hpp"
#include "cli/option.hpp"
#include "cli/shared_arguments.hpp"
#include "document/canvas.hpp"

namespace pastoso::cli {
namespace {

void add_relief_options(CLI::App& command, ExportOptions& options) {
    add_number(command, "--base-mm", options.base_mm, {0.1, 100.0},
               "Reliefs: thickness below the canvas's lowest level")
        ->type_name("MM")
        ->capture_default_str();
    add_number(command, "--exaggerate", options.exaggeration, {0.01, 100.0},
               "Reliefs: heights are multiplied by this")
        ->type_name("FACTOR")
        ->capture_default_str();
    add_number(command, "--resolution-mm", options.resolution_mm, {0.0, 1000.0},
               "Reliefs: distance of points (default: a cell, or 1/1000 of the longer side where "
               "that is more)")
        ->type_name("MM");
}

}  // namespace

void add_export(CLI::App& program, ExportOptions& options) {
    CLI::App& command = *program.add_subcommand(
        "export", "Make a picture, maps or a printable relief of a project file");
    add_text(command, "PROJECT", options.project, "A painting: FILE.pastoso")->required();
    add_text(command, "-o,--output", options.output,
             "The picture: .png, .tif, .jpg, .webp or .exr; its layers as pictures for other programs: "
             ".ora or .psd; or a relief for 3D printing, in millimetres: .stl, .ply or .obj. With "
             "--again also a painting: .pastoso")
        ->type_name("FILE");
    add_number(command, "--again", options.again_px_per_mm,
               {document::kMinPxPerMm, document::kMaxPxPerMm},
               "Paint it again from its strokes, on so many cells per millimetre")
        ->type_name("PX_PER_MM");
    add_text(command, "--well", options.well, "A picture of the mixing well")->type_name("FILE");
    command.add_flag("--layers", options.layers,
                     "Into .exr, beside the picture: lit, albedo, normal, height_mm, wetness, gloss and "
                     "cover of every layer");
    command.add_flag("--maps", options.maps,
                     "Maps for 3D programs instead of the picture, FILE-basecolor, FILE-normal "
                     "(OpenGL, +Y up), FILE-height and FILE-roughness: .png, .tif or .exr");
    command.add_flag("--flat", options.flat,
                     "Pictures without light and shade: the paint's own colours, no relief");
    add_number(command, "--scale", options.scale, {0.0625, 64.0},
               "Pixels per cell; at most 32768 pixels a side")
        ->type_name("S")
        ->capture_default_str();
    add_picture_options(command, options.picture);
    add_relief_options(command, options);
    add_threads_option(command, options.threads);
    add_quiet_flag(command, options.quiet);
    command.footer(
        "Example:\n  pastoso-cli export painting.pastoso -o painting.tif --depth 16 --scale 2\n"
        "  pastoso-cli export painting.pastoso -o painting.psd\n"
        "  pastoso-cli export painting.pastoso -o painting.stl --base-mm 3 --exaggerate 2\n"
        "  pastoso-cli export painting.pastoso --again 16 -o finer.pastoso");
}

}  // namespace pastoso::cli
