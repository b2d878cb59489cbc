#include "arguments/argument_fault.hpp"
#include "cli/convert.hpp"
#include "cli/export.hpp"
#include "cli/info.hpp"
#include "cli/interrupt.hpp"
#include "cli/options.hpp"
#include "cli/recover.hpp"
#include "cli/replay.hpp"
#include "cli/simulate.hpp"
#include "cli/timelapse.hpp"
#include "cli/usage_error.hpp"
#include "core/error.hpp"
#include "io/scene_json.hpp"

#include <cstdio>
#include <new>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

namespace pastoso::cli {
namespace {

enum ExitStatus { kDone = 0, kBadInput = 1, kBadUsage = 2, kStopped = 130 };

void add_paint_options(CLI::App& command, ReplayOptions& options) {
    command
        .add_option("--brush", options.brush,
                    "Text recordings: the tool, by name, or a preset file of your own, NAME.json "
                    "(default: Flat bristle 20)")
        ->type_name("NAME");
    command.add_option("--size-mm", options.size_mm, "Text recordings: width of the brush's tip")
        ->type_name("MM");
    command
        .add_option(
            "--paint", options.paints,
            "Text recordings: PB29, or a mixture by parts PB29=1+PW6=0.5, or thinned PB29@0.3, "
            "or a colour \"#c03020\", or clear for the medium alone; several are taken in turn, one a "
            "stroke, the brush being cleaned in between")
        ->type_name("PAINT");
    command
        .add_option("--palette", options.palette,
                    "Text recordings: a .gpl file; the names of its colours may stand in --paint")
        ->type_name("FILE");
    command.add_flag(
        "--fit", options.fit,
        "Text recordings: scale and centre the strokes on the canvas (otherwise x and y are "
        "millimetres from its upper left corner)");
}

void add_canvas_options(CLI::App& command, ReplayOptions& options) {
    command.add_option("--canvas", options.canvas, "Size of the canvas (text recordings: 300x200mm)")
        ->type_name("WxHmm");
    command.add_option("--px-per-mm", options.px_per_mm, "Cells per millimetre (text recordings: 4)")
        ->type_name("N");
    command
        .add_option("--support", options.support, "linen, cotton duck, panel, or a height image's path")
        ->type_name("NAME");
    command
        .add_option("--relief-mm", options.relief_mm,
                    "Height of the support's crowns or of an image's white")
        ->type_name("MM");
    command.add_option("--medium", options.medium, "Kind of paint (text recordings: heavy-body oil)")
        ->type_name("NAME");
    command
        .add_option("--tilt", options.tilt_deg,
                    "Tilt of the canvas, 0 flat to 90 upright (text recordings: 0)")
        ->type_name("DEG");
    command
        .add_option("--tilt-direction", options.tilt_direction_deg,
                    "Where down points: 0 right, 90 lower edge (default: 90)")
        ->type_name("DEG");
    command
        .add_option("--drying", options.drying_speed,
                    "Seconds of drying in a second of painting, 0 (text recordings) to 100000")
        ->type_name("SPEED");
    command
        .add_option("--seconds", options.seconds,
                    "How long the paint runs after the last event (text recordings: 2)")
        ->type_name("S")
        ->check(CLI::Range(0.0, 86400.0));
}

void add_picture_options(CLI::App& command, PictureOptions& options) {
    command
        .add_option("--light", options.light,
                    "The light that pictures are seen in: D65, D50, A, LED, or a CSV file of "
                    "wavelength_nm,power; the paint is the same")
        ->type_name("LIGHT")
        ->capture_default_str();
    command
        .add_option("--profile", options.profile,
                    "The colours of pictures: srgb, display-p3, or an ICC profile to convert them to; "
                    "it is embedded")
        ->type_name("PROFILE")
        ->capture_default_str();
    command
        .add_option("--depth", options.depth_bits,
                    "Bits of a channel in .png and .tif: 8 or 16; 32 for linear light in .tif")
        ->type_name("BITS")
        ->capture_default_str()
        ->check(CLI::IsMember({8, 16, 32}));
    command.add_option("--quality", options.quality, "Of .jpg and .webp: 1 small to 100 fine")
        ->type_name("Q")
        ->capture_default_str()
        ->check(CLI::Range(1, 100));
}

void add_scale_option(CLI::App& command, double& scale) {
    command.add_option("--scale", scale, "Pixels per cell of every picture")
        ->type_name("S")
        ->capture_default_str()
        ->check(CLI::Range(0.0625, 16.0));
}

void add_threads_option(CLI::App& command, int& threads) {
    command.add_option("--threads", threads, "Threads to use; 0: one per processor")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(0, 256));
}

void add_output_options(CLI::App& command, ReplayOptions& options) {
    command.add_option("-o,--output", options.output, "The picture: .png, .tif, .jpg, .webp or .exr")
        ->type_name("FILE");
    command
        .add_option("--well", options.well,
                    "A picture of the mixing well at the end, 3 cells per mm whatever the canvas has")
        ->type_name("FILE");
    add_scale_option(command, options.scale);
    add_picture_options(command, options.picture);
    command
        .add_option("--save", options.save,
                    "Keep the painting, wet as it is at the end, as a project file, FILE.pastoso")
        ->type_name("FILE");
    command.add_option("--frames", options.frames, "Write frame-00001.png and so on into this folder")
        ->type_name("DIR");
    command.add_option("--fps", options.fps, "Frames per second of paint time")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(0.01, 60.0));
    command.add_option("--stats", options.stats, "Write the figures of the run as one JSON object")
        ->type_name("FILE");
    add_threads_option(command, options.threads);
    command.add_flag("-q,--quiet", options.quiet, "Show no progress");
}

void add_replay(CLI::App& app, ReplayOptions& options) {
    CLI::App& command =
        *app.add_subcommand("replay", "Paint a pen recording, let the paint run, render it");
    command
        .add_option("STROKES", options.strokes,
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
void add_sheet(CLI::App& app, ReplayOptions& options) {
    CLI::App& command =
        *app.add_subcommand("sheet", "Paint the reference sheet: what every tool does, and colours");
    command.add_option("--px-per-mm", options.px_per_mm, "Cells per millimetre (5)")->type_name("N");
    add_output_options(command, options);
    command.footer("Example:\n  pastoso-cli sheet -o sheet.png");
}

void add_relief_options(CLI::App& command, ExportOptions& options) {
    command
        .add_option("--base-mm", options.base_mm, "Reliefs: thickness below the canvas's lowest level")
        ->type_name("MM")
        ->capture_default_str();
    command.add_option("--exaggerate", options.exaggeration, "Reliefs: heights are multiplied by this")
        ->type_name("FACTOR")
        ->capture_default_str();
    command
        .add_option("--resolution-mm", options.resolution_mm,
                    "Reliefs: distance of points (default: a cell, or 1/1000 of the longer side where "
                    "that is more)")
        ->type_name("MM");
}

void add_export(CLI::App& app, ExportOptions& options) {
    CLI::App& command =
        *app.add_subcommand("export", "Make a picture, maps or a printable relief of a project file");
    command.add_option("PROJECT", options.project, "A painting: FILE.pastoso")->required();
    command
        .add_option("-o,--output", options.output,
                    "The picture: .png, .tif, .jpg, .webp or .exr; or a relief for 3D printing, in "
                    "millimetres: .stl, .ply or .obj")
        ->type_name("FILE");
    command.add_option("--well", options.well, "A picture of the mixing well")->type_name("FILE");
    command.add_flag("--layers", options.layers,
                     "Into .exr, beside the picture: lit, albedo, normal, height_mm, wetness and gloss");
    command.add_flag("--maps", options.maps,
                     "Maps for 3D programs instead of the picture, FILE-basecolor, FILE-normal "
                     "(OpenGL, +Y up), FILE-height and FILE-roughness: .png, .tif or .exr");
    command.add_option("--scale", options.scale, "Pixels per cell; at most 32768 pixels a side")
        ->type_name("S")
        ->capture_default_str()
        ->check(CLI::Range(0.0625, 64.0));
    add_picture_options(command, options.picture);
    add_relief_options(command, options);
    add_threads_option(command, options.threads);
    command.add_flag("-q,--quiet", options.quiet, "Show no progress");
    command.footer(
        "Example:\n  pastoso-cli export painting.pastoso -o painting.tif --depth 16 --scale 2\n"
        "  pastoso-cli export painting.pastoso -o painting.stl --base-mm 3 --exaggerate 2");
}

void add_convert(CLI::App& app, ConvertOptions& options) {
    CLI::App& command = *app.add_subcommand(
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
    command.add_flag("-q,--quiet", options.quiet, "Show no progress");
    command.footer(
        "Example:\n  pastoso-cli convert photo.jpg painting.pastoso --width-mm 400\n"
        "  pastoso-cli convert layers.ora painting.pastoso --support panel");
}

void add_timelapse(CLI::App& app, TimelapseOptions& options) {
    CLI::App& command = *app.add_subcommand(
        "timelapse", "Show how a painting came about: numbered pictures, or a video");
    command
        .add_option("SOURCE", options.source,
                    "A recording (.json, or text lines), or a painting with its strokes (.pastoso)")
        ->required();
    command
        .add_option("-o,--output", options.output,
                    "A folder for frame-00001.png and so on; what is there already is kept. Or a video, "
                    ".mp4, .mkv or .webm, where the program ffmpeg is installed")
        ->type_name("DIR|FILE")
        ->required();
    command.add_option("--fps", options.fps, "Frames per second of film")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(1.0, 120.0));
    command.add_option("--speed", options.speed, "Seconds of painting in a second of film")
        ->type_name("S")
        ->capture_default_str()
        ->check(CLI::Range(0.01, 100000.0));
    command.add_option("--px-per-mm", options.px_per_mm, "Cells per millimetre")->type_name("N");
    add_scale_option(command, options.scale);
    add_picture_options(command, options.picture);
    add_threads_option(command, options.threads);
    command.add_flag("-q,--quiet", options.quiet, "Show no progress");
    command.footer("Example:\n  pastoso-cli timelapse painting.pastoso -o painting.mp4 --speed 20");
}

void add_recover(CLI::App& app, RecoverOptions& options) {
    CLI::App& command = *app.add_subcommand(
        "recover", "Bring back paintings that were not saved when the window was stopped");
    command.add_option("NAME", options.name, "Which one, as --list names it (default: the latest)");
    command.add_flag("--list", options.list, "Show what there is");
    command
        .add_option("-o,--output", options.output,
                    "Paint it again and keep it as a project file, FILE.pastoso")
        ->type_name("FILE");
    command.add_flag("--discard", options.discard, "Forget it for good");
    command.add_flag("--keep", options.keep, "With -o: leave it to be recovered again");
    add_threads_option(command, options.threads);
    command.add_flag("-q,--quiet", options.quiet, "Show no progress");
    command.footer("Example:\n  pastoso-cli recover -o recovered.pastoso");
}

std::string bundled_scenes_text() {
    std::string text;
    for (const std::string& name : io::bundled_scene_names())
        text += (text.empty() ? " " : ", ") + name;
    return text;
}

void add_simulate(CLI::App& app, SimulateOptions& options) {
    CLI::App& command = *app.add_subcommand(
        "simulate", "Let a film of paint run without a brush, and write what is measured and seen");
    command
        .add_option("SCENE", options.scene,
                    "A scene file (.json), or the name of a scene that comes with the program")
        ->required();
    command.add_option("-o,--output", options.output, "Folder for tables, heights and pictures")
        ->type_name("DIR")
        ->required();
    command
        .add_option("--seconds", options.seconds,
                    "Stop after this time; what the scene asks for later is left out")
        ->type_name("S")
        ->check(CLI::Range(0.0, 1e6));
    command
        .add_option("--threads", options.threads,
                    "Threads to use; 0: one per processor (default: the scene's own)")
        ->type_name("N")
        ->check(CLI::Range(0, 256));
    command.add_option("--stats", options.stats, "Write times and counts as one JSON object")
        ->type_name("FILE");
    add_picture_options(command, options.picture);
    command.add_flag("-q,--quiet", options.quiet, "Show no progress");
    command.footer([] {
        return "docs/scene-format.md describes scene files. Scenes that come with the program:" +
               bundled_scenes_text() + ".\nExample:\n  pastoso-cli simulate paper-fig2 -o fig2";
    });
}

void add_info(CLI::App& app, InfoOptions& options) {
    CLI::App& command = *app.add_subcommand(
        "info",
        "Describe a painting, a recording or an image, paints and colours, or the program itself");
    command
        .add_option(
            "ABOUT", options.about,
            "A file; or \"paints\"; \"paint NAME\"; \"closest COLOUR\" for the recipe of a colour, "
            "out of the box or out of the paints named after it; \"palette FILE.gpl\". Without: "
            "version, brushes, pigments, media and supports")
        ->type_name("");
    command.footer(
        "Example:\n  pastoso-cli info strokes.json\n  pastoso-cli info paint PB29\n"
        "  pastoso-cli info closest \"#7a5c3e\" PW6 PY43 PBr7-BU PB29");
}

int run(int argc, char** argv) {
    ReplayOptions replay, sheet;
    ExportOptions exporting;
    ConvertOptions convert;
    TimelapseOptions timelapse;
    RecoverOptions recover;
    SimulateOptions simulate;
    InfoOptions info;
    CLI::App app("Paints with thick wet paint, without a screen.", "pastoso-cli");
    app.set_version_flag("--version", "pastoso-cli " PASTOSO_VERSION);
    app.require_subcommand(1);
    app.footer("Example:\n  pastoso-cli replay strokes.json -o picture.png");
    add_replay(app, replay);
    add_sheet(app, sheet);
    add_export(app, exporting);
    add_convert(app, convert);
    add_timelapse(app, timelapse);
    add_recover(app, recover);
    add_simulate(app, simulate);
    add_info(app, info);
    const std::string first = argc > 1 ? argv[1] : "-";
    const auto is_named = [&](const CLI::App* command) { return command->check_name(first); };
    if (!first.starts_with('-') && app.get_subcommands(is_named).empty()) {
        throw UsageError("there is no subcommand \"" + first +
                         "\", only replay, sheet, export, timelapse, recover, simulate and info.");
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& wanted) {
        return app.exit(wanted);
    } catch (const CLI::ParseError& error) {
        throw UsageError(arguments::argument_fault(app, error));
    }
    if (app.got_subcommand("replay"))
        run_replay(replay);
    else if (app.got_subcommand("sheet"))
        run_sheet(std::move(sheet));
    else if (app.got_subcommand("export"))
        run_export(exporting);
    else if (app.got_subcommand("convert"))
        run_convert(convert);
    else if (app.got_subcommand("timelapse"))
        run_timelapse(timelapse);
    else if (app.got_subcommand("recover"))
        run_recover(recover);
    else if (app.got_subcommand("simulate"))
        run_simulate(simulate);
    else
        run_info(info);
    return kDone;
}

int fail(const std::string& message, ExitStatus status) {
    std::fprintf(stderr, "pastoso-cli: %s\n", message.c_str());
    return status;
}

}  // namespace
}  // namespace pastoso::cli

int main(int argc, char** argv) {
    using namespace pastoso::cli;
    try {
        return run(argc, argv);
    } catch (const UsageError& error) {
        return fail(error.what(), kBadUsage);
    } catch (const pastoso::core::InputError& error) {
        return fail(error.what(), kBadInput);
    } catch (const Interrupted&) {
        return fail("stopped.", kStopped);
    } catch (const std::bad_alloc&) {
        return fail("there is not enough memory for this.", kBadInput);
    } catch (const std::exception& error) {
        return fail(error.what(), kBadInput);
    }
}
