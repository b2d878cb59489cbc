#include "core/text_file.hpp"
#include "files/json_place.hpp"
#include "recordings/action_json.hpp"
#include "recordings/recording_json.hpp"
#include "recordings/stroke_ticks.hpp"

#include <algorithm>
#include <utility>

namespace pastoso::recordings {
namespace {

using document::Event;

std::string one_line(const files::Json& value) {
    return value.dump(-1, ' ', false, files::Json::error_handler_t::replace);
}

/// Time, x, y and pressure; the angles and the wheel only as far as they are not 0.
files::Json sample_json(const brush::PenSample& sample) {
    files::Json json = files::Json::array({sample.time_s, sample.x_mm, sample.y_mm, sample.pressure});
    std::size_t numbers = json.size();
    for (const double value :
         {sample.tilt_x_deg, sample.tilt_y_deg, sample.rotation_deg, sample.wheel}) {
        json.push_back(value);
        if (value != 0.0) numbers = json.size();
    }
    json.erase(json.begin() + static_cast<std::ptrdiff_t>(numbers), json.end());
    return json;
}

files::Json canvas_json(const document::CanvasSettings& canvas) {
    files::Json json{{"width_mm", canvas.width_mm},
                     {"height_mm", canvas.height_mm},
                     {"px_per_mm", canvas.px_per_mm},
                     {"support", canvas.support}};
    if (!canvas.support_image.empty()) json["support_image"] = canvas.support_image;
    if (canvas.support_relief_mm != 0.0) json["support_relief_mm"] = canvas.support_relief_mm;
    if (canvas.support_turn.mirrored) json["support_mirrored"] = true;
    if (canvas.support_turn.quarter_turns != 0)
        json["support_quarter_turns"] = canvas.support_turn.quarter_turns;
    const document::ClothMap& map = canvas.support_map;
    if (map != document::ClothMap{}) json["support_map"] = {map.xx, map.xy, map.yx, map.yy};
    if (canvas.support_x_mm != 0.0) json["support_x_mm"] = canvas.support_x_mm;
    if (canvas.support_y_mm != 0.0) json["support_y_mm"] = canvas.support_y_mm;
    return json;
}

/// Gathers the pen events between two others into one "stroke" entry.
class StrokeWriter {
  public:
    bool open() const { return open_; }

    void begin(std::int64_t tick, const document::PenDown& pen) {
        go_on(tick);
        surface_ = pen.surface;
        beside_ = pen.beside;
        continued_ = false;
        add(tick, pen.sample);
    }

    /// With a stroke that another event interrupted.
    void go_on(std::int64_t tick) {
        open_ = continued_ = true;
        surface_ = document::Surface::Canvas;
        beside_ = false;
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
        if (beside_) stroke["beside"] = true;
        if (!ticks_follow_) stroke["ticks"] = std::move(ticks_);
        if (continued_) stroke["continued"] = true;
        if (lift_tick == nullptr) stroke["lifted"] = false;
        if (lift_tick != nullptr && *lift_tick != last_tick_) stroke["lift_tick"] = *lift_tick;
        return {{"tick", first_tick_}, {"stroke", std::move(stroke)}};
    }

  private:
    bool open_ = false, continued_ = false, ticks_follow_ = true;
    document::Surface surface_ = document::Surface::Canvas;  ///< told where the pen comes down
    bool beside_ = false;                                    ///< the same
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
        stroke_.begin(tick_, pen);
    }
    void operator()(const document::PenMove& pen) {
        if (!stroke_.open()) stroke_.go_on(tick_);
        stroke_.add(tick_, pen.sample);
    }
    void operator()(const document::PenUp&) {
        if (!stroke_.open()) stroke_.go_on(tick_);
        entries.push_back(stroke_.end(&tick_));
    }
    template <class Other>
    void operator()(const Other& action) {
        finish();
        entries.push_back(files::Json{{"tick", tick_},
                                      {document::Table<Other>::kTraits.key.value, action_json(action)}});
    }

  private:
    StrokeWriter stroke_;
    std::int64_t tick_ = 0;
};

/// The oldest version that can say it: not less than the first that still is written.
int version_needed(const document::CanvasSettings& canvas) {
    constexpr int kOldestWritten = 3, kCloth = 6, kTurned = 12, kMapped = 15;
    if (canvas.support_map != document::ClothMap{}) return kMapped;
    if (canvas.support_turn != core::Orientation{}) return kTurned;
    return canvas.support_x_mm != 0.0 || canvas.support_y_mm != 0.0 ? kCloth : kOldestWritten;
}

int version_needed(const document::Recording& recording) {
    constexpr int kFirst = 1, kWithArithmetic = 9;
    int version =
        std::max(version_needed(recording.canvas), recording.arithmetic > 1 ? kWithArithmetic : kFirst);
    for (const Event& event : recording.events)
        version = std::max(version, document::version_needed(event.action));
    return version;
}

}  // namespace

std::string recording_to_json(const document::Recording& recording) {
    EntryWriter writer;
    for (const Event& event : recording.events)
        writer.add(event);
    writer.finish();

    std::string text =
        "{\n\"format\": \"pastoso-strokes\",\n\"version\": " + std::to_string(version_needed(recording));
    if (recording.arithmetic > 1) text += ",\n\"arithmetic\": " + std::to_string(recording.arithmetic);
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
