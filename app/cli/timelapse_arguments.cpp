#include "cli/arguments.hpp"
#include "cli/option.hpp"
#include "cli/shared_arguments.hpp"
#include "document/canvas.hpp"

namespace pastoso::cli {

void add_timelapse(CLI::App& program, TimelapseOptions& options) {
    CLI::App& command = *program.add_subcommand(
        "timelapse", "Show how a painting came about: numbered pictures, or a video");
    add_text(command, "SOURCE", options.source,
             "A recording (.json, or text lines), or a painting with its strokes (.pastoso)")
        ->required();
    add_text(command, "-o,--output", options.output,
             "A folder for frame-00001.png and so on; what is there already is kept. Or a video, "
             ".mp4, .mkv or .webm, where the program ffmpeg is installed")
        ->type_name("DIR|FILE")
        ->required();
    add_number(command, "--fps", options.fps, {1.0, 120.0}, "Frames per second of film")
        ->type_name("N")
        ->capture_default_str();
    add_number(command, "--speed", options.speed, {0.01, 100000.0},
               "Seconds of painting in a second of film")
        ->type_name("S")
        ->capture_default_str();
    add_number(command, "--px-per-mm", options.px_per_mm, {document::kMinPxPerMm, document::kMaxPxPerMm},
               "Cells per millimetre")
        ->type_name("N");
    command.add_flag("--flat", options.flat, "Without light and shade");
    add_scale_option(command, options.scale);
    add_picture_options(command, options.picture);
    add_threads_option(command, options.threads);
    add_quiet_flag(command, options.quiet);
    command.footer("Example:\n  pastoso-cli timelapse painting.pastoso -o painting.mp4 --speed 20");
}

}  // namespace pastoso::cli
