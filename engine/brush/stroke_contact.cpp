// How a stroke's bristles touch the canvas: the part of Stroke that tells a contact from a pose.

#include "brush/bearing.hpp"
#include "brush/smooth_noise.hpp"
#include "brush/stroke.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::brush {
namespace {

/// Lengths over which the edge of a blade throws paint up evenly, and over which its end tears.
constexpr double kThrowing_mm = 2.5, kTear_mm = 1.2;
/// Share of the load that hangs at the tips of a fresh brush, for a preset that starts with a film twice
/// as thick, and how far a dab moves.
constexpr double kHangingShare = 0.12, kDab_mm = 4.0;
/// Slope at which a blade comes down from wet paint onto what is lower; hairs are down at once.
constexpr double kSinkingSlope = 0.5;
constexpr float kAnyWay_mm = 1e6F;

float smooth_ramp(double from, double to, double x) {
    const auto t = static_cast<float>(std::clamp((x - from) / (to - from), 0.0, 1.0));
    return t * t * (3.0F - 2.0F * t);
}

/// 1 at both edges of the swath, 0 further in than 12% of its half width.
float edge_share(double side_mm, const Swath& swath) {
    constexpr double kWithin = 0.88;
    const double half_mm = 0.5 * (swath.high_mm - swath.low_mm);
    const double off_mm = std::abs(side_mm - 0.5 * (swath.high_mm + swath.low_mm));
    return off_mm <= kWithin * half_mm ? 0.0F : smooth_ramp(kWithin, 1.0, off_mm / half_mm);
}

}  // namespace

Bearing Stroke::bearing(const HandPose& hand, const Swath& swath) const {
    const FlexPreset& flex = brush_.preset.flex;
    const bool is_blade = brush_.tip.rigid && flex.ride > 0.0;
    return {.rigidity = static_cast<float>(flex.rigidity),
            .ride = ride_of(flex, hand),
            .is_edge = brush_.tip.rigid,
            .tuft_mm = kTuft_radii * brush_.tip.radius_mm,
            .edge_support_mm = swath.edge_support_mm,
            .sinking_mm = is_blade ? static_cast<float>(kSinkingSlope * path_.step_mm()) : kAnyWay_mm,
            .travel_mm = step_count_ * path_.step_mm(),
            .noise_seed = jitter_seed_};
}

Contact Stroke::contact(int bristle, const Touch& touch) const {
    const BristlePose& pose = poses_[bristle];
    const HandPose& hand = touch.hand;
    Contact contact;
    contact.x_mm = pose.x_mm;
    contact.y_mm = pose.y_mm;
    contact.support_mm = pose.bearing_mm;
    contact.press = pose.press;
    contact.ride = pose.ride;
    contact.freshness = pose.freshness;
    contact.edge = edge_share(side_mm(pose, hand), touch.swath);
    if (contact.edge > 0.0F)
        contact.edge *= brush_.tip.rigid ? thrown_up(bristle) : firmness(pose.press);
    contact.alone = brush_.tip.rigid ? 0.0F : alone(bristle);
    contact.across_x = brush_.tip.rigid ? hand.cos_rotation : -hand.travel_y;
    contact.across_y = brush_.tip.rigid ? hand.sin_rotation : hand.travel_x;
    return contact;
}

/// A blade throws its paint up along its edges, here more, there less than it leaves between them.
float Stroke::thrown_up(int bristle) const {
    const bool is_first_half = 2 * static_cast<std::size_t>(bristle) < poses_.size();
    const double travel = step_count_ * path_.step_mm() / kThrowing_mm;
    return static_cast<float>(smooth_noise(travel, jitter_seed_ + (is_first_half ? 1 : 2)));
}

/// What an element leaves of its load when it is lifted: the preset's share, and of a dab also what
/// hangs at the hairs' tips, which a stroke has laid by then. The end of what a blade leaves is torn:
/// some of its elements let go more, some nothing.
double Stroke::left_share(int bristle) const {
    const PaintPreset& paint = brush_.preset.paint;
    const BristlePose& pose = poses_[bristle];
    const double left = pose.down ? paint.leave : 0.0;
    if (brush_.tip.rigid) return left * torn_share(bristle);
    if (!pose.down && !pose.lifted) return 0.0;
    const double dab_mm = std::min(kDab_mm, 2.0 * brush_.tip.half_width_mm);
    return left + kHangingShare * paint.start * std::max(0.0, 1.0 - path_.travelled_mm() / dab_mm);
}

double Stroke::torn_share(int bristle) const {
    const double along_edge_mm = 2.0 * brush_.tip.half_width_mm * bristle / poses_.size();
    const double torn = 1.0 + smooth_noise(along_edge_mm / kTear_mm, jitter_seed_);
    return torn * torn;
}

float Stroke::alone(int bristle) const {
    const double beyond_mm = resolved_.radius_mm - brush_.tip.radius_mm;
    const double to_edge_mm = clumps_.to_edge_mm(bristle);
    return to_edge_mm >= 2.0 * beyond_mm
               ? 0.0F
               : static_cast<float>(std::min(2.0 - to_edge_mm / beyond_mm, 1.0));
}

}  // namespace pastoso::brush
