#include "brush/bristle_motion.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::brush {
namespace {

/// Decay of the thick start of a stroke, per mm.
constexpr double kFreshnessDecay_per_mm = 0.5;
/// Where a bent hair would rest: this share of its reach along the lean, and outward from the middle.
constexpr double kLeanRest = 0.6, kOutwardRest = 0.25;
/// Length of the way back to rest, in hair lengths times lag.
constexpr double kRestoring = 0.6;
/// The hairs of a bristle lie on the highest threads within this many footprint radii.
constexpr double kTuft_radii = 0.5;
/// Slope down into the weave: descend (a + b p^2).
constexpr float kLightDescent = 0.06F, kPressedDescent = 1.6F;

struct Vector {
    double x = 0.0, y = 0.0;
};

/// What the whole tip has in common during one step.
struct StepFlex {
    double length_mm, full_depth_mm, per_full_depth, bend, splay, tilt_gain;
    double restore;        ///< share of the way back to rest in this step
    float freshness_left;  ///< factor of this step
    double tuft_mm, cells_per_mm;
    float descend, step_mm;
};

StepFlex step_flex(const Brush& brush, double step_mm, double cell_mm) {
    const FlexPreset& flex = brush.preset.flex;
    const double length_mm = brush.preset.tip.length_mm;
    return {.length_mm = length_mm,
            .full_depth_mm = flex.press_depth * length_mm,
            .per_full_depth = 1.0 / (brush.preset.flex.press_depth * length_mm),
            .bend = brush.tip.rigid ? 0.0 : flex.bend,
            .splay = flex.splay,
            .tilt_gain = brush.tip.rigid ? 0.0 : flex.tilt_gain,
            .restore = 1.0 - std::exp(-step_mm / (kRestoring * length_mm * flex.lag)),
            .freshness_left = static_cast<float>(std::exp(-kFreshnessDecay_per_mm * step_mm)),
            .tuft_mm = kTuft_radii * brush.tip.radius_mm,
            .cells_per_mm = 1.0 / cell_mm,
            .descend = static_cast<float>(flex.descend),
            .step_mm = static_cast<float>(step_mm)};
}

Vector turned(const Bristle& bristle, const HandPose& hand) {
    return {bristle.root_x_mm * hand.cos_rotation - bristle.root_y_mm * hand.sin_rotation,
            bristle.root_x_mm * hand.sin_rotation + bristle.root_y_mm * hand.cos_rotation};
}

/// The cell that a place lies in, the nearest one beyond the edges.
int cell_at(double place_cells, int count) {
    return static_cast<int>(std::clamp(place_cells, 0.0, count - 1.0));
}

float support_at(const film::FilmState& film, int x, int y) {
    return film.support_mm.read(film.shape.tile_at(x, y))[grid::Shape::cell_in_tile(x, y)];
}

/// The highest support of five cells: in the middle, and `left`, `right`, `above`, `below`.
float highest_support(const film::FilmState& film, int x, int y, int left, int right, int above,
                      int below) {
    const int tile = film.shape.tile_at(left, above);
    if (tile == film.shape.tile_at(right, below)) {
        const float* support = film.support_mm.read(tile);
        const auto at = [support](int column, int row) {
            return support[grid::Shape::cell_in_tile(column, row)];
        };
        return std::max({at(x, y), at(left, y), at(right, y), at(x, above), at(x, below)});
    }
    return std::max({support_at(film, x, y), support_at(film, left, y), support_at(film, right, y),
                     support_at(film, x, above), support_at(film, x, below)});
}

float support_below(const film::FilmState& film, const BristlePose& pose, double tuft_mm,
                    double cells_per_mm) {
    const double x = pose.x_mm * cells_per_mm, y = pose.y_mm * cells_per_mm, d = tuft_mm * cells_per_mm;
    const int width = film.shape.width, height = film.shape.height;
    return highest_support(film, cell_at(x, width), cell_at(y, height), cell_at(x - d, width),
                           cell_at(x + d, width), cell_at(y - d, height), cell_at(y + d, height));
}

/// The trailing offset after the root has moved to `root`.
Vector trail(const BristlePose& pose, Vector root, Vector rest_direction, double reach_mm,
             double restore) {
    Vector offset = pose.down ? Vector{pose.x_mm - root.x, pose.y_mm - root.y} : Vector{};
    offset.x += (rest_direction.x * reach_mm - offset.x) * restore;
    offset.y += (rest_direction.y * reach_mm - offset.y) * restore;
    const double length2 = offset.x * offset.x + offset.y * offset.y;
    if (length2 <= reach_mm * reach_mm) return offset;
    const double share = reach_mm / std::sqrt(length2);
    return {offset.x * share, offset.y * share};
}

void follow_support(const film::FilmState& film, const StepFlex& flex, bool touches_down,
                    BristlePose& pose) {
    const float support = support_below(film, pose, flex.tuft_mm, flex.cells_per_mm);
    const float slope = flex.descend * (kLightDescent + kPressedDescent * pose.press * pose.press);
    pose.support_mm = touches_down ? support : std::max(support, pose.support_mm - slope * flex.step_mm);
}

void move_bristle(const Bristle& bristle, const HandPose& hand, const StepFlex& flex,
                  const film::FilmState& film, BristlePose& pose) {
    const Vector place = turned(bristle, hand);
    const double lean_mm = place.x * hand.lean_x + place.y * hand.lean_y;
    const double depth_mm =
        hand.press * flex.full_depth_mm - bristle.deficit_mm + flex.tilt_gain * lean_mm;
    if (depth_mm <= 0.0) {
        pose = {};
        return;
    }
    const double press = std::min(depth_mm * flex.per_full_depth, 1.0) * bristle.stiffness;
    const double spread = 1.0 + flex.splay * press;
    const Vector root = {hand.x_mm + place.x * spread, hand.y_mm + place.y * spread};
    const double outward = kOutwardRest * bristle.per_distance;
    const Vector rest = {kLeanRest * hand.lean_x + outward * place.x,
                         kLeanRest * hand.lean_y + outward * place.y};
    const double reach_mm =
        flex.bend * std::sqrt(std::max(0.0, depth_mm * (2.0 * flex.length_mm - depth_mm)));
    const Vector offset = trail(pose, root, rest, reach_mm, flex.restore);
    const bool touches_down = !pose.down;
    pose.down = true;
    pose.x_mm = root.x + offset.x;
    pose.y_mm = root.y + offset.y;
    pose.press = static_cast<float>(std::min(press, 1.0));
    pose.freshness = touches_down ? 1.0F : pose.freshness * flex.freshness_left;
    follow_support(film, flex, touches_down, pose);
}

/// Sixth-power mean of the supports, which is near the highest ones: what a stiff edge lies on.
float edge_support_mm(const std::vector<BristlePose>& poses) {
    double weighted = 0.0, weights = 0.0;
    for (const BristlePose& pose : poses) {
        if (!pose.down) continue;
        const double height = std::max(pose.support_mm, 1e-4F);
        const double weight = height * height * height * height * height * height;
        weighted += weight * height;
        weights += weight;
    }
    return weights > 0.0 ? static_cast<float>(weighted / weights) : 0.0F;
}

}  // namespace

Swath move_bristles(const Brush& brush, const HandPose& hand, double step_mm,
                    const film::FilmState& film, std::vector<BristlePose>& poses) {
    const StepFlex flex = step_flex(brush, step_mm, film.cell_mm);
    Swath swath{1e9, -1e9, 0.0F};
    for (std::size_t i = 0; i < poses.size(); ++i) {
        move_bristle(brush.tip.bristles[i], hand, flex, film, poses[i]);
        if (!poses[i].down) continue;
        const double side = side_mm(poses[i], hand);
        swath.low_mm = std::min(swath.low_mm, side);
        swath.high_mm = std::max(swath.high_mm, side);
    }
    if (brush.preset.flex.rigidity > 0.0) swath.edge_support_mm = edge_support_mm(poses);
    return swath;
}

}  // namespace pastoso::brush
