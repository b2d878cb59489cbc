#include "brush/hand_path.hpp"

#include "brush/footprint.hpp"
#include "core/check.hpp"
#include "core/units.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::brush {
namespace {

/// Steps into which the whole pressure is cut for tools that do not touch the canvas.
constexpr double kPressureSteps = 200.0;
/// A footprint's least radius in the step length: thin hairs do not make the steps ever shorter.
constexpr double kLeastStepRadius_mm = 0.15;

/// The same whatever the size of cells: strokes end at the same place on all.
double step_length_mm(const StrokePreset& stroke, const Tip& tip) {
    return std::max(stroke.spacing * std::max(tip.radius_mm, kLeastStepRadius_mm),
                    stroke.min_spacing_mm);
}

PathMeasure path_measure(const Preset& preset, const Tip& tip) {
    const double step_mm = step_length_mm(preset.stroke, tip);
    if (preset.kind != ToolKind::Contact) return {step_mm, kPressureSteps * step_mm};
    const FlexPreset& flex = preset.flex;
    const double full_depth_mm = flex.press_depth * preset.tip.length_mm;
    const double bend = tip.rigid ? 0.0 : flex.bend;
    return {step_mm, kPressSlide * full_depth_mm, 0.5 * tip.half_width_mm,
            bend * std::sqrt(full_depth_mm * (2.0 * preset.tip.length_mm - full_depth_mm)),
            kStiffEnd / flex.press_depth};
}

void check_finite(const PenSample& sample) {
    for (const double value :
         {sample.time_s, sample.x_mm, sample.y_mm, sample.pressure, sample.tilt_x_deg, sample.tilt_y_deg,
          sample.rotation_deg, sample.wheel}) {
        PASTOSO_CHECK(std::isfinite(value));
    }
}

}  // namespace

HandPath::HandPath(const Preset& preset, const Tip& tip, const HandAids& aids)
    : measure_(path_measure(preset, tip)),
      guide_(aids.guide),
      filter_(steadying_filter(preset.stroke, aids.stabiliser)),
      path_(measure_) {}

PenSample HandPath::begin(const PenSample& sample) {
    check_finite(sample);
    down_ = led_ = sample;
    events_.start(sample);
    const PenSample start = led(filter_.start(sample));
    const double rotation = core::radians(start.rotation_deg);
    path_.begin(start, -std::sin(rotation), std::cos(rotation));
    return start;
}

void HandPath::add(const PenSample& sample) {
    check_finite(sample);
    follow(events_.add(sample));
}

void HandPath::end() {
    follow(events_.end());
    path_.add(led(filter_.final_sample()));
    path_.end();
}

void HandPath::follow(const std::vector<PenSample>& samples) {
    for (const PenSample& sample : samples)
        path_.add(led(filter_.follow(sample)));
}

PenSample HandPath::led(const PenSample& sample) {
    return led_ = guided(guide_, down_, led_, sample);
}

}  // namespace pastoso::brush
