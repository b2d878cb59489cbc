#include "cli/arguments.hpp"
#include "cli/option.hpp"
#include "cli/shared_arguments.hpp"
#include "core/text.hpp"
#include "document/canvas.hpp"
#include "film/support/support.hpp"

namespace pastoso::cli {

void add_convert(CLI::App& program, ConvertOptions& options) {
    CLI::App& command = *program.add_subcommand(
        "convert", "Bring a picture or an OpenRaster file onto a new canvas; or export a painting");
    add_text(command, "SOURCE", options.source,
             "A picture (.png, .jpg, .tif and others), an OpenRaster file (.ora), or a painting")
        ->required();
    add_text(command, "OUTPUT,-o,--output", options.output,
             "The painting, FILE.pastoso; of a painting: a picture or a relief")
        ->type_name("FILE")
        ->required();
    add_text(command, "--as", options.as,
             "What a picture becomes: a layer of dry paint, or the heights of the support")
        ->type_name("paint|support")
        ->capture_default_str()
        ->check(CLI::IsMember({"paint", "support"}));
    add_number(command, "--px-per-mm", options.px_per_mm, {document::kMinPxPerMm, document::kMaxPxPerMm},
               "Cells of the canvas per millimetre")
        ->type_name("N")
        ->capture_default_str();
    add_number(command, "--width-mm", options.width_mm, {1.0, 5000.0},
               "Width of the canvas (default: as the picture's resolution says, otherwise 300 mm "
               "along the longer side)")
        ->type_name("MM");
    add_text(command, "--support", options.support,
             "Below the paint: " + core::listed(film::support_names()))
        ->type_name("NAME")
        ->capture_default_str()
        ->check(CLI::IsMember(film::support_names()));
    add_number(command, "--relief-mm", options.relief_mm, {0.0, 20.0},
               "Height of the support's crowns or of an image's white")
        ->type_name("MM");
    add_scale_option(command, options.scale);
    add_picture_options(command, options.picture);
    add_threads_option(command, options.threads);
    add_quiet_flag(command, options.quiet);
    command.footer(
        "Example:\n  pastoso-cli convert photo.jpg painting.pastoso --width-mm 400\n"
        "  pastoso-cli convert layers.ora painting.pastoso --support panel");
}

}  // namespace pastoso::cli
