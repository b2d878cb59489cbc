#include "cli/arguments.hpp"
#include "cli/option.hpp"
#include "cli/shared_arguments.hpp"
#include "core/text.hpp"
#include "document/canvas.hpp"
#include "film/support/support.hpp"

namespace pastoso::cli {
namespace {

void add_paint_options(CLI::App& command, ReplayOptions& options) {
    add_text(command, "--brush", options.brush,
             "Text recordings: the tool, by name, or a preset file of your own, NAME.json "
             "(default: Flat bristle 20)")
        ->type_name("NAME");
    add_number(command, "--size-mm", options.size_mm, {0.5, 200.0},
               "Text recordings: width of the brush's tip")
        ->type_name("MM");
    add_texts(command, "--paint", options.paints,
              "Text recordings: PB29, or a mixture by parts PB29=1+PW6=0.5, or thinned PB29@0.3, "
              "or a colour \"#c03020\", or clear for the medium alone; several are taken in turn, one a "
              "stroke, the brush being cleaned in between")
        ->type_name("PAINT");
    add_text(command, "--palette", options.palette,
             "Text recordings: a .gpl file; the names of its colours may stand in --paint")
        ->type_name("FILE");
    command.add_flag(
        "--fit", options.fit,
        "Text recordings: scale and centre the strokes on the canvas (otherwise x and y are "
        "millimetres from its upper left corner)");
}

void add_canvas_options(CLI::App& command, ReplayOptions& options) {
    add_text(command, "--canvas", options.canvas, "Size of the canvas (text recordings: 300x200mm)")
        ->type_name("WxHmm");
    add_number(command, "--px-per-mm", options.px_per_mm, {document::kMinPxPerMm, document::kMaxPxPerMm},
               "Cells per millimetre (text recordings: 4)")
        ->type_name("N");
    add_text(command, "--support", options.support,
             core::listed(film::support_names()) + ", or a height image's path")
        ->type_name("NAME");
    add_number(command, "--relief-mm", options.relief_mm, {0.0, 20.0},
               "Height of the support's crowns or of an image's white")
        ->type_name("MM");
    add_text(command, "--medium", options.medium, "Kind of paint (text recordings: heavy-body oil)")
        ->type_name("NAME");
    add_number(command, "--tilt", options.tilt_deg, {0.0, 90.0},
               "Tilt of the canvas, 0 flat to 90 upright (text recordings: 0)")
        ->type_name("DEG");
    add_number(command, "--tilt-direction", options.tilt_direction_deg, {-360.0, 360.0},
               "Where down points: 0 right, 90 lower edge (default: 90)")
        ->type_name("DEG");
    add_number(command, "--drying", options.drying_speed, {0.0, 100000.0},
               "Seconds of drying in a second of painting, 0 (text recordings) to 100000")
        ->type_name("SPEED");
    add_number(command, "--seconds", options.seconds, {0.0, 86400.0},
               "How long the paint runs after the last event (text recordings: 2)")
        ->type_name("S");
}

void add_output_options(CLI::App& command, ReplayOptions& options) {
    add_text(command, "-o,--output", options.output, "The picture: .png, .tif, .jpg, .webp or .exr")
        ->type_name("FILE");
    add_text(command, "--well", options.well,
             "A picture of the mixing well at the end, 3 cells per mm whatever the canvas has")
        ->type_name("FILE");
    add_scale_option(command, options.scale);
    add_picture_options(command, options.picture);
    add_text(command, "--save", options.save,
             "Keep the painting, wet as it is at the end, as a project file, FILE.pastoso")
        ->type_name("FILE");
    add_text(command, "--frames", options.frames, "Write frame-00001.png and so on into this folder")
        ->type_name("DIR");
    add_number(command, "--fps", options.fps, {0.01, 60.0}, "Frames per second of paint time")
        ->type_name("N")
        ->capture_default_str();
    add_text(command, "--stats", options.stats, "Write the figures of the run as one JSON object")
        ->type_name("FILE");
    add_threads_option(command, options.threads);
    add_quiet_flag(command, options.quiet);
}

}  // namespace

void add_replay(CLI::App& program, ReplayOptions& options) {
    CLI::App& command =
        *program.add_subcommand("replay", "Paint a pen recording, let the paint run, render it");
    add_text(command, "STROKES", options.strokes,
             "A recording: .json, or text lines \"seconds x y pressure\"")
        ->required();
    add_paint_options(command, options);
    add_canvas_options(command, options);
    add_output_options(command, options);
    command.footer(
        "A JSON recording says itself which canvas, brushes and paints it uses; an option given here "
        "overrides it.\nExample:\n  pastoso-cli replay pen.dat --fit --brush \"Flat bristle 20\" "
        "--paint PB29=1+PW6=0.5 PY35 \\\n      --canvas 300x200mm --tilt 60 --seconds 8 -o out.png");
}

/// The reference sheet is a recording that comes with the program.
void add_sheet(CLI::App& program, ReplayOptions& options) {
    CLI::App& command =
        *program.add_subcommand("sheet", "Paint the reference sheet: what every tool does, and colours");
    add_number(command, "--px-per-mm", options.px_per_mm, {document::kMinPxPerMm, document::kMaxPxPerMm},
               "Cells per millimetre (5)")
        ->type_name("N");
    add_output_options(command, options);
    command.footer("Example:\n  pastoso-cli sheet -o sheet.png");
}

}  // namespace pastoso::cli
