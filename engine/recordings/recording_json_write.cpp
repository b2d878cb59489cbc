#include "core/text_file.hpp"
#include "files/json_place.hpp"
#include "recordings/hand_aids_json.hpp"
#include "recordings/layers_json.hpp"
#include "recordings/paint_json.hpp"
#include "recordings/picture_json.hpp"
#include "recordings/recording_json.hpp"
#include "recordings/selection_json.hpp"
#include "recordings/stroke_ticks.hpp"

#include <algorithm>
#include <utility>

namespace pastoso::recordings {
namespace {

using document::Action;
using document::Event;

std::string one_line(const files::Json& value) {
    return value.dump(-1, ' ', false, files::Json::error_handler_t::replace);
}

files::Json load_json(const document::LoadPaint& load) {
    files::Json json{{"paint", paint_json(load.paint)}};
    if (load.second != document::PaintRecipe{}) json["second"] = paint_json(load.second);
    if (load.second_share != 0.0) json["second_share"] = load.second_share;
    if (load.share_variation != 0.0) json["share_variation"] = load.share_variation;
    if (load.side_by_side) json["side_by_side"] = true;
    if (load.tip_only) json["tip_only"] = true;
    if (load.fill != 1.0) json["fill"] = load.fill;
    return json;
}

files::Json squeeze_json(const document::SqueezePaint& squeeze) {
    return {{"paint", paint_json(squeeze.paint)},
            {"volume_mm3", squeeze.volume_mm3},
            {"x_mm", squeeze.x_mm},
            {"y_mm", squeeze.y_mm}};
}

files::Json brush_json(const document::TakeBrush& take) {
    files::Json json{{"preset", take.preset}};
    if (!take.definition.empty()) json["preset"] = files::Json::parse(take.definition);
    if (take.size_mm != 0.0) json["size_mm"] = take.size_mm;
    if (take.seed != 1) json["seed"] = take.seed;
    return json;
}

files::Json drying_json(const film::DryingAir& air) {
    files::Json json{{"speed", air.speed}};
    if (air.fan != 1.0) json["fan"] = air.fan;
    if (air.fan_x_mm != 0.0) json["fan_x_mm"] = air.fan_x_mm;
    if (air.fan_y_mm != 0.0) json["fan_y_mm"] = air.fan_y_mm;
    if (air.fan_radius_mm != 0.0) json["fan_radius_mm"] = air.fan_radius_mm;
    return json;
}

/// Time, x, y and pressure; the angles only as far as they are not 0.
files::Json sample_json(const brush::PenSample& sample) {
    files::Json json = files::Json::array({sample.time_s, sample.x_mm, sample.y_mm, sample.pressure});
    if (sample.tilt_x_deg == 0.0 && sample.tilt_y_deg == 0.0 && sample.rotation_deg == 0.0) return json;
    json.push_back(sample.tilt_x_deg);
    json.push_back(sample.tilt_y_deg);
    if (sample.rotation_deg != 0.0) json.push_back(sample.rotation_deg);
    return json;
}

files::Json canvas_json(const document::CanvasSettings& canvas) {
    files::Json json{{"width_mm", canvas.width_mm},
                     {"height_mm", canvas.height_mm},
                     {"px_per_mm", canvas.px_per_mm},
                     {"support", canvas.support}};
    if (!canvas.support_image.empty()) json["support_image"] = canvas.support_image;
    if (canvas.support_relief_mm != 0.0) json["support_relief_mm"] = canvas.support_relief_mm;
    if (canvas.support_x_mm != 0.0) json["support_x_mm"] = canvas.support_x_mm;
    if (canvas.support_y_mm != 0.0) json["support_y_mm"] = canvas.support_y_mm;
    return json;
}

/// Gathers the pen events between two others into one "stroke" entry.
class StrokeWriter {
  public:
    bool open() const { return open_; }

    void begin(std::int64_t tick, bool continued, document::Surface surface) {
        open_ = true;
        surface_ = surface;
        continued_ = continued;
        first_tick_ = last_tick_ = tick;
        samples_ = ticks_ = files::Json::array();
        ticks_follow_ = true;
    }

    void add(std::int64_t tick, const brush::PenSample& sample) {
        ticks_follow_ = ticks_follow_ && tick == tick_of_time(sample.time_s, last_tick_);
        samples_.push_back(sample_json(sample));
        ticks_.push_back(tick);
        last_tick_ = tick;
    }

    /// `lift_tick`: of the pen's lift, none when the stroke is interrupted by another event.
    files::Json end(const std::int64_t* lift_tick) {
        open_ = false;
        files::Json stroke{{"samples", std::move(samples_)}};
        if (surface_ == document::Surface::Well) stroke["surface"] = "well";
        if (!ticks_follow_) stroke["ticks"] = std::move(ticks_);
        if (continued_) stroke["continued"] = true;
        if (lift_tick == nullptr) stroke["lifted"] = false;
        if (lift_tick != nullptr && *lift_tick != last_tick_) stroke["lift_tick"] = *lift_tick;
        return {{"tick", first_tick_}, {"stroke", std::move(stroke)}};
    }

  private:
    bool open_ = false, continued_ = false, ticks_follow_ = true;
    document::Surface surface_ = document::Surface::Canvas;  ///< told where the pen comes down
    std::int64_t first_tick_ = 0, last_tick_ = 0;
    files::Json samples_, ticks_;
};

/// Turns events into entries, in order.
class EntryWriter {
  public:
    std::vector<files::Json> entries;

    void add(const Event& event) {
        tick_ = event.tick;
        std::visit(*this, event.action);
    }
    void finish() {
        if (stroke_.open()) entries.push_back(stroke_.end(nullptr));
    }

    void operator()(const document::PenDown& pen) {
        finish();
        stroke_.begin(tick_, false, pen.surface);
        stroke_.add(tick_, pen.sample);
    }
    void operator()(const document::PenMove& pen) {
        if (!stroke_.open()) stroke_.begin(tick_, true, document::Surface::Canvas);
        stroke_.add(tick_, pen.sample);
    }
    void operator()(const document::PenUp&) {
        if (!stroke_.open()) stroke_.begin(tick_, true, document::Surface::Canvas);
        entries.push_back(stroke_.end(&tick_));
    }
    void operator()(const document::TakeBrush& take) { put("take_brush", brush_json(take)); }
    void operator()(const document::LoadPaint& load) { put("load_paint", load_json(load)); }
    void operator()(const document::CleanBrush& clean) {
        put("clean_brush",
            clean.share == 1.0 ? files::Json::object() : files::Json{{"share", clean.share}});
    }
    void operator()(const document::UseMedium& medium) {
        files::Json entry{{"name", medium.name}};
        if (medium.own) entry["numbers"] = files::Json::parse(film::numbers_to_json(*medium.own));
        put("use_medium", std::move(entry));
    }
    void operator()(const document::TiltCanvas& tilt) {
        put("tilt_canvas",
            files::Json{{"tilt_deg", tilt.tilt_deg}, {"direction_deg", tilt.direction_deg}});
    }
    void operator()(const document::SetDrying& drying) { put("set_drying", drying_json(drying.air)); }
    void operator()(const document::DryNow&) { put("dry_now", files::Json::object()); }
    void operator()(const document::Undo&) { put("undo", files::Json::object()); }
    void operator()(const document::Redo&) { put("redo", files::Json::object()); }
    void operator()(const document::SetStabiliser& set) {
        put("set_stabiliser", stabiliser_json(set.stabiliser));
    }
    void operator()(const document::SetGuide& set) { put("set_guide", guide_json(set.guide)); }
    void operator()(const document::SetSymmetry& set) {
        put("set_symmetry", symmetry_json(set.symmetry));
    }
    void operator()(const document::SqueezePaint& squeeze) {
        put("squeeze_paint", squeeze_json(squeeze));
    }
    void operator()(const document::CleanWell&) { put("clean_well", files::Json::object()); }
    void operator()(const document::AddLayer& add) { put("add_layer", files::Json{{"name", add.name}}); }
    void operator()(const document::SelectLayer& select) { put_layer("select_layer", select.layer); }
    void operator()(const document::SetLayer& set) { put("set_layer", set_layer_json(set)); }
    void operator()(const document::DuplicateLayer& copy) { put_layer("duplicate_layer", copy.layer); }
    void operator()(const document::RemoveLayer& remove) { put_layer("remove_layer", remove.layer); }
    void operator()(const document::ClearLayer& clear) { put_layer("clear_layer", clear.layer); }
    void operator()(const document::TransformLayer& move) {
        put("transform_layer", transform_layer_json(move));
    }
    void operator()(const document::MoveLayer& move) { put("move_layer", move_layer_json(move)); }
    void operator()(const document::MergeDown& merge) { put_layer("merge_down", merge.layer); }
    void operator()(const document::FlattenLayers&) { put("flatten_layers", files::Json::object()); }
    void operator()(const document::GroupLayers& group) {
        put("group_layers", group_layers_json(group));
    }
    void operator()(const document::SetGroup& set) { put("set_group", set_group_json(set)); }
    void operator()(const document::MoveGroup& move) { put("move_group", move_group_json(move)); }
    void operator()(const document::UngroupLayers& ungroup) {
        put("ungroup_layers", files::Json{{"group", ungroup.group}});
    }
    void operator()(const document::SelectArea& select) { put("select_area", select_area_json(select)); }
    void operator()(const document::SelectByHeight& select) {
        put("select_by_height", select_by_height_json(select));
    }
    void operator()(const document::SelectByWetness& select) {
        put("select_by_wetness", select_by_wetness_json(select));
    }
    void operator()(const document::ResizeCanvas& resize) {
        put("resize_canvas", files::Json{{"x_mm", resize.x_mm},
                                         {"y_mm", resize.y_mm},
                                         {"width_mm", resize.width_mm},
                                         {"height_mm", resize.height_mm}});
    }
    void operator()(const document::PaintPicture& paint) {
        put("paint_picture", paint_picture_json(paint));
    }
    void operator()(const document::LayTracing& lay) { put("lay_tracing", lay_tracing_json(lay)); }
    void operator()(const document::SetTracing& set) { put("set_tracing", set_tracing_json(set)); }
    void operator()(const document::InvertSelection&) { put("invert_selection", files::Json::object()); }
    void operator()(const document::SelectAll&) { put("select_all", files::Json::object()); }

  private:
    void put(const char* kind, files::Json content) {
        finish();
        entries.push_back(files::Json{{"tick", tick_}, {kind, std::move(content)}});
    }

    void put_layer(const char* kind, document::LayerId layer) {
        put(kind, files::Json{{"layer", layer}});
    }

    StrokeWriter stroke_;
    std::int64_t tick_ = 0;
};

template <class... Kinds>
bool is_one_of(const document::Action& action) {
    return (std::holds_alternative<Kinds>(action) || ...);
}

bool uses_well(const Event& event) {
    const auto* pen = std::get_if<document::PenDown>(&event.action);
    return (pen != nullptr && pen->surface == document::Surface::Well) ||
           is_one_of<document::SqueezePaint, document::CleanWell>(event.action);
}

bool uses_layers(const Event& event) {
    using namespace document;
    return is_one_of<AddLayer, SelectLayer, SetLayer, DuplicateLayer, RemoveLayer, ClearLayer, MoveLayer,
                     MergeDown, FlattenLayers, GroupLayers, SetGroup, MoveGroup, UngroupLayers>(
        event.action);
}

bool uses_regions_or_pictures(const Event& event) {
    using namespace document;
    return is_one_of<SelectArea, SelectByHeight, SelectByWetness, InvertSelection, SelectAll,
                     TransformLayer, ResizeCanvas, PaintPicture>(event.action);
}

bool uses_tracing(const Event& event) {
    return is_one_of<document::LayTracing, document::SetTracing>(event.action);
}

bool uses_own_medium(const Event& event) {
    const auto* use = std::get_if<document::UseMedium>(&event.action);
    return use != nullptr && use->own;
}

int version_needed(const document::Recording& recording) {
    const auto any = [&](bool (*uses)(const Event&)) {
        return std::any_of(recording.events.begin(), recording.events.end(), uses);
    };
    const bool on_cloth = recording.canvas.support_x_mm != 0.0 || recording.canvas.support_y_mm != 0.0;
    if (any(uses_own_medium)) return 8;
    if (any(uses_tracing)) return 7;
    if (on_cloth || any(uses_regions_or_pictures)) return 6;
    if (any(uses_layers)) return 5;
    return any(uses_well) ? 4 : 3;
}

}  // namespace

std::string recording_to_json(const document::Recording& recording) {
    EntryWriter writer;
    for (const Event& event : recording.events)
        writer.add(event);
    writer.finish();

    std::string text =
        "{\n\"format\": \"pastoso-strokes\",\n\"version\": " + std::to_string(version_needed(recording));
    text += ",\n\"canvas\": " + one_line(canvas_json(recording.canvas));
    text += ",\n\"end_tick\": " + std::to_string(recording.end_tick);
    text += ",\n\"events\": [";
    const char* separator = "\n";
    for (const files::Json& entry : writer.entries) {
        text += separator + one_line(entry);
        separator = ",\n";
    }
    return text + "\n]\n}\n";
}

void write_recording_json(const std::filesystem::path& path, const document::Recording& recording) {
    core::write_text_file(path, recording_to_json(recording));
}

}  // namespace pastoso::recordings
