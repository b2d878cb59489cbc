#include "recordings/recording_text.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/text_file.hpp"
#include "files/text_lines.hpp"
#include "recordings/stroke_ticks.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace pastoso::recordings {
namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{512} << 20;
constexpr std::size_t kColumns = 4;
constexpr std::array<core::Pattern<0>, kColumns> kColumnNames = {
    core::Pattern<0>("time"), core::Pattern<0>("x"), core::Pattern<0>("y"),
    core::Pattern<0>("pressure")};
constexpr std::string_view kBlanks = " \t\r\v\f";

/// Far beyond any screen or tablet, in whatever unit.
constexpr double kLargestNumber = 1e7;

/// A day: the longest session that is read.
constexpr double kLongestTime_s = 24.0 * 3600.0;

/// Cuts off and returns what stands before `end`, the whole rest when `end` does not occur.
std::string_view take_until(std::string_view& rest, std::string_view ends) {
    const std::size_t length = std::min(rest.find_first_of(ends), rest.size());
    const std::string_view head = rest.substr(0, length);
    rest.remove_prefix(std::min(length + 1, rest.size()));
    return head;
}

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    while (!line.empty()) {
        const std::string_view word = take_until(line, kBlanks);
        if (!word.empty()) words.push_back(word);
    }
    return words;
}

class TraceReader {
  public:
    explicit TraceReader(const std::string& name) : name_(name) {}

    void read_line(std::string_view line) {
        ++line_number_;
        const std::vector<std::string_view> words = words_of(take_until(line, "#"));
        if (words.empty()) return;
        if (words.size() != kColumns)
            fail("expected 4 numbers, seconds x y pressure, found %1.", words.size());
        std::array<double, kColumns> row;
        for (std::size_t i = 0; i < kColumns; ++i)
            row[i] = number(words[i], kColumnNames[i]);
        add({row[0], row[1], row[2], row[3]});
    }

    PenTrace finish() && {
        if (trace_.strokes.empty()) {
            throw core::InputError(
                "%1: holds no stroke; expected lines \"seconds x y pressure\", some with a pressure "
                "above 0.",
                name_);
        }
        return std::move(trace_);
    }

  private:
    template <class... Arguments>
    [[noreturn]] void fail(core::Pattern<sizeof...(Arguments)> pattern,
                           const Arguments&... arguments) const {
        throw core::located_error(name_, line_number_, core::message(pattern, arguments...));
    }

    double number(std::string_view word, core::Pattern<0> column) const {
        double value = 0.0;
        const char* digits = word.data() + (word.size() > 1 && word.front() == '+' ? 1 : 0);
        const auto result = std::from_chars(digits, word.data() + word.size(), value);
        if (result.ec != std::errc() || result.ptr != word.data() + word.size())
            fail("the %1 %2 is not a number.", core::message(column), files::quoted(word));
        if (!(std::abs(value) <= kLargestNumber))
            fail("the %1 %2 is not between -1e7 and 1e7.", core::message(column), files::quoted(word));
        return value;
    }

    void add(const brush::PenSample& sample) {
        if (sample.time_s < 0.0 || sample.time_s > kLongestTime_s)
            fail("the time %1 s is not between 0 and 86400 s.", sample.time_s);
        if (sample.time_s < last_time_s_)
            fail("the time %1 s is earlier than %2 s before it.", sample.time_s, last_time_s_);
        if (sample.pressure < 0.0 || sample.pressure > 1.0)
            fail("the pressure %1 is not between 0 and 1.", sample.pressure);
        last_time_s_ = sample.time_s;
        const bool down = sample.pressure > 0.0;
        if (down && !pen_is_down_) trace_.strokes.emplace_back();
        if (down) trace_.strokes.back().push_back(sample);
        pen_is_down_ = down;
    }

    const std::string& name_;
    long line_number_ = 0;
    double last_time_s_ = 0.0;
    bool pen_is_down_ = false;
    PenTrace trace_;
};

struct Box {
    double x0 = std::numeric_limits<double>::infinity(), y0 = x0, x1 = -x0, y1 = -x0;

    void add(const brush::PenSample& sample) {
        x0 = std::min(x0, sample.x_mm);
        y0 = std::min(y0, sample.y_mm);
        x1 = std::max(x1, sample.x_mm);
        y1 = std::max(y1, sample.y_mm);
    }
};

Box bounding_box(const PenTrace& trace) {
    Box box;
    for (const auto& stroke : trace.strokes) {
        for (const brush::PenSample& sample : stroke)
            box.add(sample);
    }
    return box;
}

/// The factor that brings `extent` to `free_mm`; a point or a straight line may be scaled at will.
double scale_along(double extent, double free_mm) {
    return extent > 0.0 ? free_mm / extent : std::numeric_limits<double>::infinity();
}

}  // namespace

PenTrace parse_pen_trace(std::string_view text, const std::string& name) {
    TraceReader reader(name);
    while (!text.empty())
        reader.read_line(take_until(text, "\n"));
    return std::move(reader).finish();
}

PenTrace read_pen_trace(const std::filesystem::path& path) {
    return parse_pen_trace(core::read_text_file(path, kMaxFileBytes), path.string());
}

PenTrace fitted(const PenTrace& trace, double width_mm, double height_mm, double margin_mm) {
    const Box box = bounding_box(trace);
    const double margin = std::min(margin_mm, 0.45 * std::min(width_mm, height_mm));
    double scale = std::min(scale_along(box.x1 - box.x0, width_mm - 2.0 * margin),
                            scale_along(box.y1 - box.y0, height_mm - 2.0 * margin));
    if (!std::isfinite(scale)) scale = 1.0;
    PenTrace result = trace;
    for (auto& stroke : result.strokes) {
        for (brush::PenSample& sample : stroke) {
            sample.x_mm = 0.5 * width_mm + scale * (sample.x_mm - 0.5 * (box.x0 + box.x1));
            sample.y_mm = 0.5 * height_mm + scale * (sample.y_mm - 0.5 * (box.y0 + box.y1));
        }
    }
    return result;
}

bool touches_canvas(const PenTrace& trace, double width_mm, double height_mm) {
    const auto on_canvas = [&](const brush::PenSample& sample) {
        return sample.x_mm >= 0.0 && sample.x_mm <= width_mm && sample.y_mm >= 0.0 &&
               sample.y_mm <= height_mm;
    };
    return std::any_of(trace.strokes.begin(), trace.strokes.end(), [&](const auto& stroke) {
        return std::any_of(stroke.begin(), stroke.end(), on_canvas);
    });
}

document::Recording recording_from_trace(const PenTrace& trace, const TraceSetup& setup) {
    PASTOSO_CHECK(!setup.paints.empty());
    document::Recording recording;
    recording.canvas = setup.canvas;
    std::vector<document::Event>& events = recording.events;
    events.push_back({0, document::UseMedium{setup.medium}});
    events.push_back({0, setup.tilt});
    events.push_back({0, setup.brush});
    std::int64_t tick = 0;
    for (std::size_t i = 0; i < trace.strokes.size(); ++i) {
        const auto& stroke = trace.strokes[i];
        tick = tick_of_time(stroke.front().time_s, tick);
        document::LoadPaint load;
        load.paint = setup.paints[i % setup.paints.size()];
        events.push_back({tick, document::CleanBrush{}});
        events.push_back({tick, load});
        events.push_back({tick, document::PenDown{stroke.front()}});
        for (std::size_t k = 1; k < stroke.size(); ++k) {
            tick = tick_of_time(stroke[k].time_s, tick);
            events.push_back({tick, document::PenMove{stroke[k]}});
        }
        events.push_back({tick, document::PenUp{}});
    }
    recording.end_tick = tick + std::llround(setup.seconds_after / document::kTick_s);
    return recording;
}

}  // namespace pastoso::recordings
