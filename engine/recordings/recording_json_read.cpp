#include "core/text_file.hpp"
#include "document/canvas.hpp"
#include "document/cloth.hpp"
#include "files/json_place.hpp"
#include "recordings/action_json.hpp"
#include "recordings/recording_json.hpp"
#include "recordings/stroke_ticks.hpp"

#include <cmath>

namespace pastoso::recordings {
namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{512} << 20;

/// A hundred days of paint time: of a painting that grows for weeks, some of it at 20 times real time.
constexpr std::int64_t kMaxTick = 100LL * 24 * 3600 * 60;

document::ClothMap read_map(const files::JsonPlace& place) {
    if (place.size() != 4) place.fail("a map has 4 numbers; here are %1.", place.size());
    return {place.element(0).number(), place.element(1).number(), place.element(2).number(),
            place.element(3).number()};
}

document::CanvasSettings read_canvas(const files::JsonPlace& place) {
    place.allow_only({"width_mm", "height_mm", "px_per_mm", "support", "support_image",
                      "support_relief_mm", "support_mirrored", "support_quarter_turns",
                      "support_askew_deg", "support_map", "support_x_mm", "support_y_mm"});
    document::CanvasSettings canvas;
    canvas.width_mm = place.entry("width_mm").number();
    canvas.height_mm = place.entry("height_mm").number();
    canvas.px_per_mm = place.number_or("px_per_mm", canvas.px_per_mm);
    if (const auto support = place.optional_entry("support")) canvas.support = support->text();
    if (const auto image = place.optional_entry("support_image")) canvas.support_image = image->text();
    canvas.support_relief_mm = place.number_or("support_relief_mm", 0.0);
    canvas.support_turn.mirrored = place.boolean_or("support_mirrored", false);
    if (const auto turns = place.optional_entry("support_quarter_turns"))
        canvas.support_turn.quarter_turns = static_cast<int>(turns->integer(0, 3));
    if (const auto angle = place.optional_entry("support_askew_deg"))
        canvas.support_map = document::cloth_turned_by(angle->number());
    if (const auto map = place.optional_entry("support_map")) canvas.support_map = read_map(*map);
    canvas.support_x_mm = place.number_or("support_x_mm", 0.0);
    canvas.support_y_mm = place.number_or("support_y_mm", 0.0);
    place.guard([&] { document::check_canvas(canvas); });
    return canvas;
}

/// [time, x, y, pressure, tilt_x, tilt_y, rotation, wheel]; what is left out at the end is 0.
brush::PenSample read_sample(const files::JsonPlace& place) {
    const std::size_t count = place.size();
    if (count < 4 || count > 8) {
        place.fail(
            "a sample has 4 to 8 numbers, time, x, y, pressure, tilt_x, tilt_y, rotation, wheel; "
            "here are %1.",
            count);
    }
    double numbers[8] = {};
    for (std::size_t i = 0; i < count; ++i)
        numbers[i] = place.element(i).number();
    const brush::PenSample sample{numbers[0], numbers[1], numbers[2], numbers[3],
                                  numbers[4], numbers[5], numbers[6], numbers[7]};
    place.guard([&] { document::check_sample(sample); });
    return sample;
}

/// Expands the entries of a file into events, keeping watch over their order.
class EventReader {
  public:
    explicit EventReader(Names names) : names_(names) {}

    std::vector<document::Event> events;

    void read(const files::JsonPlace& entry) {
        const std::int64_t tick = read_tick(entry.entry("tick"));
        if (const auto stroke = entry.optional_entry("stroke")) {
            entry.allow_only({"tick", "stroke"});
            read_stroke(*stroke, tick);
        } else {
            read_single(entry, tick);
        }
    }

    std::int64_t read_tick(const files::JsonPlace& place) {
        const std::int64_t tick = place.integer(0, kMaxTick);
        if (tick < last_tick_) place.fail("the tick %1 is earlier than %2 before it.", tick, last_tick_);
        last_tick_ = tick;
        return tick;
    }

  private:
    void read_single(const files::JsonPlace& entry, std::int64_t tick) {
        const FoundAction found = read_action(entry, values_);
        if (names_ == Names::MustBeKnown)
            found.content.guard([&] { document::check_action(found.action); });
        events.push_back({tick, found.action});
    }

    void read_stroke(const files::JsonPlace& stroke, std::int64_t first_tick) {
        stroke.allow_only({"surface", "beside", "samples", "ticks", "continued", "lifted", "lift_tick"});
        const files::JsonPlace samples = stroke.entry("samples");
        const bool continued = stroke.boolean_or("continued", false);
        const auto named = stroke.optional_entry("surface");
        if (named && continued) named->fail("a stroke that goes on stays on its surface.");
        document::Surface surface = document::Surface::Canvas;
        if (named) values_.read(*named, stroke, surface);
        const bool beside = stroke.boolean_or("beside", false);
        if (beside && continued)
            stroke.entry("beside").fail("a stroke that goes on says nothing of where it began.");
        if (samples.size() == 0 && !continued) samples.fail("a stroke needs at least one sample.");
        const auto ticks = stroke.optional_entry("ticks");
        if (ticks && ticks->size() != samples.size())
            ticks->fail("there are %1 ticks for %2 samples.", ticks->size(), samples.size());
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const files::JsonPlace place = samples.element(i);
            const brush::PenSample sample = read_sample(place);
            const bool down = i == 0 && !continued;
            if (!down) place.guard([&] { document::check_time_order(last_sample_, sample); });
            const std::int64_t tick = ticks ? read_tick(ticks->element(i)) : implied_tick(sample);
            if (down)
                events.push_back({tick, document::PenDown{sample, surface, beside}});
            else
                events.push_back({tick, document::PenMove{sample}});
            last_sample_ = sample;
        }
        if (stroke.boolean_or("lifted", true)) {
            const auto lift = stroke.optional_entry("lift_tick");
            const std::int64_t lift_tick = lift ? read_tick(*lift) : std::max(first_tick, last_tick_);
            events.push_back({lift_tick, document::PenUp{}});
        }
    }

    std::int64_t implied_tick(const brush::PenSample& sample) {
        last_tick_ = tick_of_time(sample.time_s, last_tick_);
        return last_tick_;
    }

    Names names_;
    std::int64_t last_tick_ = 0;
    ValueReader values_;
    brush::PenSample last_sample_;
};

/// Versions before 9 say nothing of it.
int read_arithmetic(const files::JsonPlace& root) {
    const auto arithmetic = root.optional_entry("arithmetic");
    return arithmetic ? static_cast<int>(arithmetic->integer(1, document::kArithmetic)) : 1;
}

constexpr files::FileFormat kFormat{"pastoso-strokes", core::Pattern<0>("a stroke recording"),
                                    core::Pattern<0>("stroke format"), kStrokeFormatVersion};

}  // namespace

document::Recording recording_from_json(std::string_view text, const std::string& name, Names names) {
    const files::Json json = files::parse_json(text, name);
    const files::JsonPlace root(json, name);
    files::check_format(root, kFormat);
    root.allow_only({"format", "version", "arithmetic", "canvas", "end_tick", "events"});
    document::Recording recording;
    recording.arithmetic = read_arithmetic(root);
    recording.canvas = read_canvas(root.entry("canvas"));
    EventReader reader(names);
    const files::JsonPlace entries = root.entry("events");
    for (std::size_t i = 0; i < entries.size(); ++i)
        reader.read(entries.element(i));
    recording.end_tick = reader.read_tick(root.entry("end_tick"));
    recording.events = std::move(reader.events);
    return recording;
}

document::Recording read_recording_json(const std::filesystem::path& path) {
    document::Recording recording =
        recording_from_json(core::read_text_file(path, kMaxFileBytes), path.string());
    std::string& image = recording.canvas.support_image;
    if (!image.empty()) image = (path.parent_path() / image).string();
    return recording;
}

}  // namespace pastoso::recordings
