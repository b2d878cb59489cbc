#include "brush/preset.hpp"
#include "core/text_file.hpp"
#include "document/action_checks.hpp"
#include "document/canvas.hpp"
#include "files/json_place.hpp"
#include "recordings/hand_aids_json.hpp"
#include "recordings/layers_json.hpp"
#include "recordings/paint_json.hpp"
#include "recordings/picture_json.hpp"
#include "recordings/recording_json.hpp"
#include "recordings/selection_json.hpp"
#include "recordings/stroke_ticks.hpp"

#include <cmath>

namespace pastoso::recordings {
namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{512} << 20;

/// A day of paint time.
constexpr std::int64_t kMaxTick = 24LL * 3600 * 60;

document::CanvasSettings read_canvas(const files::JsonPlace& place) {
    place.allow_only({"width_mm", "height_mm", "px_per_mm", "support", "support_image",
                      "support_relief_mm", "support_x_mm", "support_y_mm"});
    document::CanvasSettings canvas;
    canvas.width_mm = place.entry("width_mm").number();
    canvas.height_mm = place.entry("height_mm").number();
    canvas.px_per_mm = place.number_or("px_per_mm", canvas.px_per_mm);
    if (const auto support = place.optional_entry("support")) canvas.support = support->text();
    if (const auto image = place.optional_entry("support_image")) canvas.support_image = image->text();
    canvas.support_relief_mm = place.number_or("support_relief_mm", 0.0);
    canvas.support_x_mm = place.number_or("support_x_mm", 0.0);
    canvas.support_y_mm = place.number_or("support_y_mm", 0.0);
    place.guard([&] { document::check_canvas(canvas); });
    return canvas;
}

/// A preset's name, or all of it.
void read_preset(const files::JsonPlace& place, document::TakeBrush& take) {
    if (!place.value().is_object()) {
        take.preset = place.text();
        return;
    }
    place.guard([&] {
        const brush::Preset preset = brush::parse_preset(place.value().dump(), "the preset");
        take.preset = preset.name;
        take.definition = brush::preset_to_json(preset);
    });
}

document::Action read_take_brush(const files::JsonPlace& place) {
    place.allow_only({"preset", "size_mm", "seed"});
    document::TakeBrush take;
    read_preset(place.entry("preset"), take);
    take.size_mm = place.number_or("size_mm", 0.0);
    if (const auto seed = place.optional_entry("seed")) {
        take.seed = static_cast<std::uint32_t>(seed->integer(0, UINT32_MAX));
    }
    return take;
}

document::Action read_load_paint(const files::JsonPlace& place) {
    place.allow_only(
        {"paint", "second", "second_share", "share_variation", "side_by_side", "tip_only", "fill"});
    document::LoadPaint load;
    load.paint = read_paint(place.entry("paint"));
    if (const auto second = place.optional_entry("second")) load.second = read_paint(*second);
    load.second_share = place.number_or("second_share", 0.0);
    load.share_variation = place.number_or("share_variation", 0.0);
    load.side_by_side = place.boolean_or("side_by_side", false);
    load.tip_only = place.boolean_or("tip_only", false);
    load.fill = place.number_or("fill", 1.0);
    return load;
}

document::Action read_clean_brush(const files::JsonPlace& place) {
    place.allow_only({"share"});
    return document::CleanBrush{place.number_or("share", 1.0)};
}

document::Action read_tilt(const files::JsonPlace& place) {
    place.allow_only({"tilt_deg", "direction_deg"});
    document::TiltCanvas tilt;
    tilt.tilt_deg = place.entry("tilt_deg").number();
    tilt.direction_deg = place.number_or("direction_deg", tilt.direction_deg);
    return tilt;
}

document::Action read_medium(const files::JsonPlace& place) {
    place.allow_only({"name", "numbers"});
    document::UseMedium use{place.entry("name").text()};
    const auto numbers = place.optional_entry("numbers");
    if (!numbers) return use;
    film::Medium like;
    place.entry("name").guard([&] { like = film::find_medium(use.name); });
    use.own = read_medium_numbers(*numbers, like);
    use.name = like.name;
    return use;
}

document::Action read_drying(const files::JsonPlace& place) {
    place.allow_only({"speed", "fan", "fan_x_mm", "fan_y_mm", "fan_radius_mm"});
    film::DryingAir air;
    air.speed = place.entry("speed").number();
    air.fan = place.number_or("fan", air.fan);
    air.fan_x_mm = place.number_or("fan_x_mm", air.fan_x_mm);
    air.fan_y_mm = place.number_or("fan_y_mm", air.fan_y_mm);
    air.fan_radius_mm = place.number_or("fan_radius_mm", air.fan_radius_mm);
    return document::SetDrying{air};
}

document::Action read_picture(const files::JsonPlace& place, double& pixels) {
    return read_paint_picture(place, pixels);
}

document::Action read_tracing(const files::JsonPlace& place, double& pixels) {
    return read_lay_tracing(place, pixels);
}

document::Action read_tracing_setting(const files::JsonPlace& place) {
    return read_set_tracing(place);
}

document::Action read_squeeze(const files::JsonPlace& place) {
    place.allow_only({"paint", "volume_mm3", "x_mm", "y_mm"});
    document::SqueezePaint squeeze;
    squeeze.paint = read_paint(place.entry("paint"));
    squeeze.volume_mm3 = place.number_or("volume_mm3", squeeze.volume_mm3);
    squeeze.x_mm = place.entry("x_mm").number();
    squeeze.y_mm = place.entry("y_mm").number();
    return squeeze;
}

document::Action read_resize(const files::JsonPlace& place) {
    place.allow_only({"x_mm", "y_mm", "width_mm", "height_mm"});
    return document::ResizeCanvas{place.number_or("x_mm", 0.0), place.number_or("y_mm", 0.0),
                                  place.entry("width_mm").number(), place.entry("height_mm").number()};
}

document::Surface read_surface(const files::JsonPlace& place) {
    const std::string name = place.text();
    if (name == "canvas") return document::Surface::Canvas;
    if (name == "well") return document::Surface::Well;
    place.fail("there is no surface \"" + name + "\"; a stroke is on the \"canvas\" or the \"well\".");
}

template <class Plain>
document::Action read_plain(const files::JsonPlace& place) {
    place.allow_only({});
    return Plain{};
}

struct Kind {
    const char* key;
    document::Action (*read)(const files::JsonPlace&);
};
constexpr Kind kKinds[] = {
    {"take_brush", read_take_brush},
    {"load_paint", read_load_paint},
    {"clean_brush", read_clean_brush},
    {"use_medium", read_medium},
    {"tilt_canvas", read_tilt},
    {"set_drying", read_drying},
    {"dry_now", read_plain<document::DryNow>},
    {"undo", read_plain<document::Undo>},
    {"redo", read_plain<document::Redo>},
    {"set_stabiliser", read_stabiliser},
    {"set_guide", read_guide},
    {"set_symmetry", read_symmetry},
    {"squeeze_paint", read_squeeze},
    {"clean_well", read_plain<document::CleanWell>},
    {"add_layer", read_add_layer},
    {"select_layer", read_of_layer<document::SelectLayer>},
    {"set_layer", read_set_layer},
    {"duplicate_layer", read_of_layer<document::DuplicateLayer>},
    {"remove_layer", read_of_layer<document::RemoveLayer>},
    {"clear_layer", read_of_layer<document::ClearLayer>},
    {"transform_layer", read_transform_layer},
    {"move_layer", read_move_layer},
    {"merge_down", read_of_layer<document::MergeDown>},
    {"flatten_layers", read_plain<document::FlattenLayers>},
    {"group_layers", read_group_layers},
    {"set_group", read_set_group},
    {"move_group", read_move_group},
    {"ungroup_layers", read_ungroup_layers},
    {"select_area", read_select_area},
    {"select_by_height", read_select_by_height},
    {"select_by_wetness", read_select_by_wetness},
    {"invert_selection", read_plain<document::InvertSelection>},
    {"resize_canvas", read_resize},
    {"set_tracing", read_tracing_setting},
    {"select_all", read_plain<document::SelectAll>},
};

/// What holds a picture, and counts its pixels.
struct PictureKind {
    const char* key;
    document::Action (*read)(const files::JsonPlace& place, double& pixels);
};

constexpr PictureKind kPictureKinds[] = {
    {"paint_picture", read_picture},
    {"lay_tracing", read_tracing},
};

/// [time, x, y, pressure, tilt_x, tilt_y, rotation]; angles left out at the end are 0.
brush::PenSample read_sample(const files::JsonPlace& place) {
    const std::size_t count = place.size();
    if (count < 4 || count > 7) {
        place.fail(
            "a sample has 4 to 7 numbers, time, x, y, pressure, tilt_x, tilt_y, rotation; here are " +
            std::to_string(count) + ".");
    }
    double numbers[7] = {};
    for (std::size_t i = 0; i < count; ++i)
        numbers[i] = place.element(i).number();
    const brush::PenSample sample{numbers[0], numbers[1], numbers[2], numbers[3],
                                  numbers[4], numbers[5], numbers[6]};
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
        if (tick < last_tick_) {
            place.fail("the tick " + std::to_string(tick) + " is earlier than " +
                       std::to_string(last_tick_) + " before it.");
        }
        last_tick_ = tick;
        return tick;
    }

  private:
    void read_single(const files::JsonPlace& entry, std::int64_t tick) {
        for (const Kind& kind : kKinds) {
            const auto content = entry.optional_entry(kind.key);
            if (!content) continue;
            entry.allow_only({"tick", kind.key});
            add(tick, kind.read(*content), *content);
            return;
        }
        for (const PictureKind& kind : kPictureKinds) {
            const auto content = entry.optional_entry(kind.key);
            if (!content) continue;
            entry.allow_only({"tick", kind.key});
            add(tick, kind.read(*content, picture_pixels_), *content);
            return;
        }
        std::string kinds = "stroke";
        for (const PictureKind& kind : kPictureKinds)
            kinds += std::string(", ") + kind.key;
        for (const Kind& kind : kKinds)
            kinds += std::string(", ") + kind.key;
        entry.fail("expected one of " + kinds + " beside the tick.");
    }

    void add(std::int64_t tick, const document::Action& action, const files::JsonPlace& content) {
        if (names_ == Names::MustBeKnown) content.guard([&] { document::check_action(action); });
        events.push_back({tick, action});
    }

    void read_stroke(const files::JsonPlace& stroke, std::int64_t first_tick) {
        stroke.allow_only({"surface", "samples", "ticks", "continued", "lifted", "lift_tick"});
        const files::JsonPlace samples = stroke.entry("samples");
        const bool continued = stroke.boolean_or("continued", false);
        const auto named = stroke.optional_entry("surface");
        if (named && continued) named->fail("a stroke that goes on stays on its surface.");
        const document::Surface surface = named ? read_surface(*named) : document::Surface::Canvas;
        if (samples.size() == 0 && !continued) samples.fail("a stroke needs at least one sample.");
        const auto ticks = stroke.optional_entry("ticks");
        if (ticks && ticks->size() != samples.size()) {
            ticks->fail("there are " + std::to_string(ticks->size()) + " ticks for " +
                        std::to_string(samples.size()) + " samples.");
        }
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const files::JsonPlace place = samples.element(i);
            const brush::PenSample sample = read_sample(place);
            const bool down = i == 0 && !continued;
            if (!down) place.guard([&] { document::check_time_order(last_sample_, sample); });
            const std::int64_t tick = ticks ? read_tick(ticks->element(i)) : implied_tick(place, sample);
            if (down)
                events.push_back({tick, document::PenDown{sample, surface}});
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

    std::int64_t implied_tick(const files::JsonPlace& place, const brush::PenSample& sample) {
        if (sample.time_s > static_cast<double>(kMaxTick) * document::kTick_s) {
            place.fail("the time lies more than a day after the start.");
        }
        last_tick_ = tick_of_time(sample.time_s, last_tick_);
        return last_tick_;
    }

    Names names_;
    std::int64_t last_tick_ = 0;
    double picture_pixels_ = 0.0;
    brush::PenSample last_sample_;
};

constexpr files::FileFormat kFormat{"pastoso-strokes", "a stroke recording", "stroke format",
                                    kStrokeFormatVersion};

}  // namespace

document::Recording recording_from_json(std::string_view text, const std::string& name, Names names) {
    const files::Json json = files::parse_json(text, name);
    const files::JsonPlace root(json, name);
    files::check_format(root, kFormat);
    root.allow_only({"format", "version", "canvas", "end_tick", "events"});
    document::Recording recording;
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
