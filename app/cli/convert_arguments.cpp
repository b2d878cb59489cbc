#include "cli/arguments.hpp"
#include "cli/shared_arguments.hpp"

#include <CLI/CLI.hpp>

namespace pastoso::cli {

void add_convert(CLI::App& program, ConvertOptions& options) {
    CLI::App& command = *program.add_subcommand(
        "convert", "Bring a picture or an OpenRaster file onto a new canvas; or export a painting");
    command
        .add_option("SOURCE", options.source,
                    "A picture (.png, .jpg, .tif and others), an OpenRaster file (.ora), or a painting")
        ->required();
    command
        .add_option("OUTPUT,-o,--output", options.output,
                    "The painting, FILE.pastoso; of a painting: a picture or a relief")
        ->type_name("FILE")
        ->required();
    command
        .add_option("--as", options.as,
                    "What a picture becomes: a layer of dry paint, or the heights of the support")
        ->type_name("paint|support")
        ->capture_default_str()
        ->check(CLI::IsMember({"paint", "support"}));
    command.add_option("--px-per-mm", options.px_per_mm, "Cells of the canvas per millimetre")
        ->type_name("N")
        ->capture_default_str();
    command
        .add_option("--width-mm", options.width_mm,
                    "Width of the canvas (default: as the picture's resolution says, otherwise 300 mm "
                    "along the longer side)")
        ->type_name("MM")
        ->check(CLI::Range(1.0, 5000.0));
    command.add_option("--support", options.support, "Below the paint: linen, cotton duck or panel")
        ->type_name("NAME")
        ->capture_default_str()
        ->check(CLI::IsMember({"linen", "cotton duck", "panel"}));
    command
        .add_option("--relief-mm", options.relief_mm,
                    "Height of the support's crowns or of an image's white")
        ->type_name("MM")
        ->check(CLI::Range(0.0, 20.0));
    add_scale_option(command, options.scale);
    add_picture_options(command, options.picture);
    add_threads_option(command, options.threads);
    add_quiet_flag(command, options.quiet);
    command.footer(
        "Example:\n  pastoso-cli convert photo.jpg painting.pastoso --width-mm 400\n"
        "  pastoso-cli convert layers.ora painting.pastoso --support panel");
}

}  // namespace pastoso::cli
