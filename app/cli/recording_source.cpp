#include "cli/recording_source.hpp"

#include "cli/brush_choice.hpp"
#include "cli/printing.hpp"
#include "cli/usage_error.hpp"
#include "cli/values.hpp"
#include "core/error.hpp"
#include "core/memory.hpp"
#include "core/text_file.hpp"
#include "document/actions/actions.hpp"
#include "document/canvas.hpp"
#include "pigment/gpl.hpp"
#include "recordings/recording_json.hpp"
#include "recordings/recording_text.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace pastoso::cli {
namespace {

using document::Recording;

/// Free space around a fitted recording, as a share of the shorter side: about half a large brush.
constexpr double kFitMargin = 0.1;

const std::vector<std::string> kDefaultPaints = {"PB29=1+PW6=0.6", "PY35=1+PW6=0.1", "PR108",
                                                 "PG18=1+PW6=0.4", "PW6=1+PY43=0.1"};

/// `support` as given: one of the program's own by name, or the path of an image.
void set_support(document::CanvasSettings& canvas, const std::string& support) {
    const bool is_file = std::filesystem::path(support).has_extension();
    canvas.support = is_file ? "image" : support;
    canvas.support_image = is_file ? support : "";
}

void override_canvas(document::CanvasSettings& canvas, const ReplayOptions& options) {
    if (options.canvas) {
        const CanvasSize size = parse_canvas_size(*options.canvas);
        canvas.width_mm = size.width_mm;
        canvas.height_mm = size.height_mm;
    }
    if (options.px_per_mm) canvas.px_per_mm = *options.px_per_mm;
    if (options.support) set_support(canvas, *options.support);
    if (options.relief_mm) canvas.support_relief_mm = *options.relief_mm;
    document::check_canvas_fits(canvas, core::available_memory_bytes());
}

document::TiltCanvas tilt_of(const ReplayOptions& options) {
    document::TiltCanvas tilt;
    tilt.tilt_deg = options.tilt_deg.value_or(0.0);
    tilt.direction_deg = options.tilt_direction_deg.value_or(tilt.direction_deg);
    return tilt;
}

document::SetDrying drying_of(const ReplayOptions& options) {
    return {{.speed = options.drying_speed.value_or(0.0)}};
}

/// Puts `action` at the start, in the place of all others of its kind.
template <class Kind>
void replace_all(Recording& recording, const Kind& action) {
    std::erase_if(recording.events, [](const document::Event& event) {
        return std::holds_alternative<Kind>(event.action);
    });
    recording.events.insert(recording.events.begin(), {0, action});
}

void set_seconds_after(Recording& recording, double seconds) {
    const std::int64_t last = recording.events.empty() ? 0 : recording.events.back().tick;
    recording.end_tick = last + std::llround(seconds / document::kTick_s);
}

Recording load_json(const ReplayOptions& options) {
    if (options.brush || options.size_mm || !options.paints.empty() || options.palette || options.fit) {
        throw UsageError(
            "--brush, --size-mm, --paint, --palette and --fit are for text recordings; a JSON "
            "recording says these things itself.");
    }
    Recording recording = recordings::read_recording_json(options.strokes);
    override_canvas(recording.canvas, options);
    if (options.medium) replace_all(recording, document::UseMedium{*options.medium});
    if (options.tilt_deg || options.tilt_direction_deg) replace_all(recording, tilt_of(options));
    if (options.drying_speed) replace_all(recording, drying_of(options));
    if (options.seconds) set_seconds_after(recording, *options.seconds);
    return recording;
}

/// Puts colours in the place of their names in the palette.
void name_colours(document::PaintRecipe& paint, const pigment::ColourPalette& palette) {
    for (document::Ingredient& ingredient : paint.ingredients) {
        if (const pigment::NamedColour* colour = pigment::find_colour(palette, ingredient.pigment))
            ingredient.pigment = pigment::hex_colour(colour->colour);
    }
}

recordings::TraceSetup text_setup(const ReplayOptions& options) {
    recordings::TraceSetup setup;
    override_canvas(setup.canvas, options);
    setup.medium = options.medium.value_or(kDefaultMedium);
    setup.tilt = tilt_of(options);
    setup.brush = chosen_brush(options.brush.value_or(kDefaultBrush));
    setup.brush.size_mm = options.size_mm.value_or(0.0);
    for (const std::string& paint : options.paints.empty() ? kDefaultPaints : options.paints) {
        setup.paints.push_back(parse_paint(paint));
    }
    if (options.palette) {
        const auto palette =
            pigment::parse_gpl(core::read_text_file(*options.palette), *options.palette);
        for (document::PaintRecipe& paint : setup.paints)
            name_colours(paint, palette);
    }
    setup.seconds_after = options.seconds.value_or(setup.seconds_after);
    return setup;
}

Recording load_text(const ReplayOptions& options) {
    const recordings::TraceSetup setup = text_setup(options);
    const double width = setup.canvas.width_mm;
    const double height = setup.canvas.height_mm;
    recordings::PenTrace trace = recordings::read_pen_trace(options.strokes);
    if (options.fit)
        trace = recordings::fitted(trace, width, height, kFitMargin * std::min(width, height));
    if (!recordings::touches_canvas(trace, width, height)) {
        throw core::InputError(
            "%1: every stroke misses the canvas; positions are taken as millimetres from its upper left "
            "corner unless --fit is given.",
            options.strokes);
    }
    Recording recording = recordings::recording_from_trace(trace, setup);
    if (options.drying_speed) replace_all(recording, drying_of(options));
    return recording;
}

}  // namespace

bool is_json_recording(const std::string& path) {
    return std::filesystem::path(path).extension() == ".json";
}

void tell_arithmetic(const std::string& path, const Recording& recording) {
    const core::Message older = document::arithmetic_note(recording.arithmetic);
    if (!older.empty()) complain(path + ": its strokes " + older.text());
}

document::Recording load_recording(const ReplayOptions& options) {
    Recording recording = is_json_recording(options.strokes) ? load_json(options) : load_text(options);
    for (const document::Event& event : recording.events)
        document::check_action(event.action);
    return recording;
}

}  // namespace pastoso::cli
