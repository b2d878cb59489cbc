// How the tool is held at each step of a stroke: the part of Stroke that tells a pose from the path.

#include "brush/stroke.hpp"
#include "core/random.hpp"

namespace pastoso::brush {
namespace {

/// Of where a roller stands when it comes down.
constexpr std::uint32_t kRollStream = 0x5011;

/// Of what the tool can hold.
double mean_fill(const Brush& brush) {
    const double capacity_mm3 = brush.tip.capacity_mm3 * static_cast<double>(brush.held.size());
    return capacity_mm3 > 0.0 ? brush.contents().volume_mm3 / capacity_mm3 : 0.0;
}

}  // namespace

HandPose Stroke::pose(const PathStep& step) const {
    return placed(placement_, hand_pose(brush_.preset.dynamics, step, state()));
}

StrokeState Stroke::state() const {
    return {.begun_s = begun_s_,
            .width_mm = 2.0 * brush_.tip.half_width_mm,
            .seed = jitter_seed_,
            .fill = reads_load_ ? mean_fill(brush_) : 1.0};
}

/// A roller turns by its way across its own axis, from wherever it happened to stand.
void Stroke::roll(HandPose& hand) {
    if (brush_.preset.tip.girth_mm <= 0.0) return;
    if (rolled_) {
        const double dx_mm = hand.x_mm - rolled_->x_mm, dy_mm = hand.y_mm - rolled_->y_mm;
        hand.rolled_mm = rolled_->rolled_mm + dy_mm * hand.cos_rotation - dx_mm * hand.sin_rotation;
    } else {
        hand.rolled_mm = brush_.preset.tip.girth_mm * core::uniform_noise(jitter_seed_, kRollStream);
    }
    rolled_ = hand;
}

}  // namespace pastoso::brush
