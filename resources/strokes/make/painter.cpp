#include "painter.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pastoso::examples {
namespace {

constexpr double kSamples_per_s = 80.0;

/// From lifting the brush to touching down again, and for a dip: a very quick hand, for short replays.
constexpr double kMove_s = 0.01;
constexpr double kDip_s = 0.01;

constexpr double kShareVariation = 0.45;

/// Few digits keep the file small and the same on every machine.
double rounded(double value, double steps_per_unit) {
    return std::round(value * steps_per_unit) / steps_per_unit + 0.0;
}

brush::PenSample sample_at(double time_s, const Touch& touch) {
    return {rounded(time_s, 1000),          rounded(touch.x_mm, 100),
            rounded(touch.y_mm, 100),       rounded(std::clamp(touch.pressure, 0.0, 1.0), 1000),
            rounded(touch.tilt_x_deg, 10),  rounded(touch.tilt_y_deg, 10),
            rounded(touch.rotation_deg, 10)};
}

}  // namespace

Painter::Painter(const document::CanvasSettings& canvas) {
    recording_.canvas = canvas;
}

std::int64_t Painter::tick() const {
    return static_cast<std::int64_t>(std::floor(now_s_ / document::kTick_s));
}

template <class Kind>
void Painter::note(const Kind& action) {
    recording_.events.push_back({tick(), action});
}

void Painter::use_medium(const std::string& name, double paint_share) {
    note(document::UseMedium{.name = name, .paint_share = paint_share});
}

void Painter::tilt_canvas(double tilt_deg) {
    note(document::TiltCanvas{tilt_deg, 90.0});
}

void Painter::dry_now() {
    note(document::DryNow{});
}

void Painter::set_symmetry(const brush::Symmetry& symmetry) {
    note(document::SetSymmetry{symmetry});
}

void Painter::wait(double seconds) {
    now_s_ += seconds;
}

void Painter::wait_until(double moment_s) {
    if (now_s_ > moment_s)
        throw core::InputError("The strokes before the moment of %1 s last until %2 s.", moment_s, now_s_);
    now_s_ = moment_s;
}

void Painter::take(const std::string& preset, double size_mm) {
    note(document::TakeBrush{preset, size_mm, ++brushes_taken_});
}

void Painter::take_own(const brush::Preset& preset) {
    note(document::TakeBrush{
        .preset = preset.name, .seed = ++brushes_taken_, .definition = brush::preset_to_json(preset)});
}

void Painter::dip(const document::LoadPaint& paint) {
    note(paint);
    now_s_ += kDip_s;
}

void Painter::wipe() {
    note(document::CleanBrush{});
}

void Painter::squeeze(const document::PaintRecipe& paint, double x_mm, double y_mm, double volume_mm3) {
    note(document::SqueezePaint{paint, volume_mm3, x_mm, y_mm});
    now_s_ += kDip_s;
}

void Painter::stroke(double duration_s, const std::function<Touch(double)>& path, int least_samples) {
    const int count =
        std::max(least_samples - 1, static_cast<int>(std::lround(duration_s * kSamples_per_s)));
    const double start_s = now_s_;
    for (int i = 0; i <= count; ++i) {
        const double u = static_cast<double>(i) / count;
        const brush::PenSample sample = sample_at(start_s + u * duration_s, path(u));
        now_s_ = sample.time_s;
        if (i == 0)
            note(document::PenDown{sample, surface_});
        else
            note(document::PenMove{sample});
    }
    note(document::PenUp{});
    now_s_ += kMove_s;
}

document::Recording Painter::finish(double seconds_after) {
    now_s_ += seconds_after;
    recording_.end_tick = tick();
    return recording_;
}

document::PaintRecipe mixture(const std::string& parts, double strength) {
    document::PaintRecipe paint;
    paint.strength = strength;
    std::istringstream words(parts);
    for (std::string word; words >> word;) {
        const std::size_t equals = word.find('=');
        document::Ingredient& ingredient = paint.ingredients.emplace_back();
        ingredient.pigment = word.substr(0, equals);
        if (equals != std::string::npos) ingredient.parts = std::stod(word.substr(equals + 1));
    }
    return paint;
}

document::LoadPaint load(const document::PaintRecipe& paint, double fill) {
    document::LoadPaint action;
    action.paint = paint;
    action.fill = fill;
    return action;
}

document::LoadPaint load(const document::PaintRecipe& paint, const document::PaintRecipe& second,
                         double share, double fill) {
    document::LoadPaint action = load(paint, fill);
    action.second = second;
    action.second_share = share;
    action.share_variation = kShareVariation;
    return action;
}

}  // namespace pastoso::examples
