#include "brush/bristle_motion.hpp"

#include "brush/footprint.hpp"
#include "brush/motion_kernel.hpp"
#include "core/units.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::brush {

namespace {

/// Decay of the thick start of a stroke, per mm.
constexpr double kFreshnessDecay_per_mm = 0.5;
/// Length of the way back to rest, in hair lengths times lag.
constexpr double kRestoring = 0.6;
/// Slope down into the weave: descend (a + b p^2).
constexpr float kLightDescent = 0.06F, kPressedDescent = 1.6F;

StepFlex step_flex(const Preset& preset, const Tip& tip, double step_mm) {
    const FlexPreset& flex = preset.flex;
    const double length_mm = preset.tip.length_mm;
    return {.length_mm = length_mm,
            .full_depth_mm = flex.press_depth * length_mm,
            .per_full_depth = 1.0 / (flex.press_depth * length_mm),
            .bend = tip.rigid ? 0.0 : flex.bend,
            .splay = flex.splay,
            .tilt_gain = tip.rigid ? 0.0 : flex.tilt_gain,
            .stiff_end_mm = kStiffEnd * length_mm,
            .restore = 1.0 - std::exp(-step_mm / (kRestoring * length_mm * flex.lag))};
}

FerrulePose ferrule_pose(const HandPose& hand) {
    return {.x_mm = hand.x_mm,
            .y_mm = hand.y_mm,
            .press = hand.press,
            .lean_x = hand.lean_x,
            .lean_y = hand.lean_y,
            .cos_rotation = hand.cos_rotation,
            .sin_rotation = hand.sin_rotation};
}

/// How bristles follow the support in one step.
struct StepDescent {
    float descend, step_mm;
    float freshness_left;  ///< factor of this step
};
StepDescent step_descent(const Brush& brush, double step_mm) {
    return {.descend = static_cast<float>(brush.preset.flex.descend),
            .step_mm = static_cast<float>(step_mm),
            .freshness_left = static_cast<float>(std::exp(-kFreshnessDecay_per_mm * step_mm))};
}

TuftGrid tuft_grid(const film::FilmState& film, double radius_mm) {
    const double cells_per_mm = 1.0 / film.cell_mm;
    return {cells_per_mm, kTuft_radii * radius_mm * cells_per_mm, film.shape.width - 1.0,
            film.shape.height - 1.0};
}

/// Where on a roller an element is once it has turned so far: along the travel from its lowest line, and
/// how far above that.
struct RolledPlace {
    float y_mm, height_mm;
};
RolledPlace rolled_place(float root_y_mm, double rolled_mm, double girth_mm) {
    constexpr double kAway_mm = 1e6;
    const double turns = (root_y_mm - rolled_mm) / girth_mm;
    const double y_mm = girth_mm * (turns - std::floor(turns + 0.5));
    const double radius_mm = girth_mm / (2.0 * core::kPi);
    const double rest_mm2 = radius_mm * radius_mm - y_mm * y_mm;
    const double height_mm = rest_mm2 > 0.0 ? radius_mm - std::sqrt(rest_mm2) : kAway_mm;
    return {static_cast<float>(y_mm), static_cast<float>(height_mm)};
}

void roll(const Bristle* bristles, int count, double rolled_mm, double girth_mm,
          MotionColumns& columns) {
    for (int i = 0; i < count; ++i) {
        const RolledPlace place = rolled_place(bristles[i].root_y_mm, rolled_mm, girth_mm);
        columns.root_y_mm[i] = place.y_mm;
        columns.deficit_mm[i] = bristles[i].deficit_mm + place.height_mm;
    }
}

/// Columns of up to MotionColumns::kCount bristles.
void fill_columns(const Bristle* bristles, const BristlePose* poses, int count, MotionColumns& columns) {
    for (int i = 0; i < count; ++i) {
        columns.root_x_mm[i] = bristles[i].root_x_mm;
        columns.root_y_mm[i] = bristles[i].root_y_mm;
        columns.per_distance[i] = bristles[i].per_distance;
        columns.deficit_mm[i] = bristles[i].deficit_mm;
        columns.stiffness[i] = bristles[i].stiffness;
        columns.was_down[i] = poses[i].down ? 1.0 : 0.0;
        columns.x_mm[i] = poses[i].x_mm;
        columns.y_mm[i] = poses[i].y_mm;
    }
}

float support_at(const film::FilmState& film, int x, int y) {
    return film.support_mm.read(film.shape.tile_at(x, y))[grid::Shape::cell_in_tile(x, y)];
}

/// The highest support of the five cells of a tuft.
float highest_support(const film::FilmState& film, const TuftCells& tufts, int i) {
    // Unsigned: the cells are none below 0, and dividing them by a tile's size is then a shift.
    const auto x = static_cast<unsigned>(tufts.x[i]), y = static_cast<unsigned>(tufts.y[i]);
    const auto left = static_cast<unsigned>(tufts.left[i]),
               right = static_cast<unsigned>(tufts.right[i]);
    const auto above = static_cast<unsigned>(tufts.above[i]),
               below = static_cast<unsigned>(tufts.below[i]);
    constexpr unsigned kSize = grid::kTileSize;
    if (left / kSize == right / kSize && above / kSize == below / kSize) {
        const film::TileHeights support =
            film.support_mm.read(film.shape.tile_at(tufts.x[i], tufts.y[i]));
        const auto cell = [](unsigned column, unsigned row) {
            return row % kSize * kSize + column % kSize;
        };
        return support.highest(cell(x, y), cell(left, y), cell(right, y), cell(x, above),
                               cell(x, below));
    }
    return std::max(
        {support_at(film, tufts.x[i], tufts.y[i]), support_at(film, tufts.left[i], tufts.y[i]),
         support_at(film, tufts.right[i], tufts.y[i]), support_at(film, tufts.x[i], tufts.above[i]),
         support_at(film, tufts.x[i], tufts.below[i])});
}

/// Puts a bristle where the columns say, on the support below it.
void set_down(const MotionColumns& columns, int i, float support_mm, const StepDescent& descent,
              BristlePose& pose) {
    const bool touches_down = !pose.down;
    pose.down = true;
    pose.x_mm = columns.x_mm[i];
    pose.y_mm = columns.y_mm[i];
    pose.press = static_cast<float>(columns.press[i]);
    pose.freshness = touches_down ? 1.0F : pose.freshness * descent.freshness_left;
    const float slope = descent.descend * (kLightDescent + kPressedDescent * pose.press * pose.press);
    const float lowest_mm = pose.support_mm - slope * descent.step_mm;
    pose.support_mm = touches_down ? support_mm : std::max(support_mm, lowest_mm);
}

void widen(Swath& swath, double side_mm) {
    swath.low_mm = std::min(swath.low_mm, side_mm);
    swath.high_mm = std::max(swath.high_mm, side_mm);
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

std::vector<glm::vec2> tips_set_down(const Preset& preset, const Tip& tip, const HandPose& hand) {
    if (preset.kind != ToolKind::Contact) return {};
    const double slide_mm = kPressSlide * preset.flex.press_depth * preset.tip.length_mm * hand.press;
    const StepFlex flex = step_flex(preset, tip, slide_mm);
    FerrulePose ferrule = ferrule_pose(hand);
    ferrule.x_mm = ferrule.y_mm = 0.0;
    const double girth_mm = preset.tip.girth_mm;
    const std::vector<BristlePose> lifted(tip.bristles.size());
    std::vector<glm::vec2> tips;
    MotionColumns columns{};
    const int all = static_cast<int>(lifted.size());
    for (int first = 0; first < all; first += MotionColumns::kCount) {
        const int count = std::min(MotionColumns::kCount, all - first);
        fill_columns(&tip.bristles[first], &lifted[first], count, columns);
        if (girth_mm > 0.0) roll(&tip.bristles[first], count, 0.0, girth_mm, columns);
        core::kernels<MotionKernels>().move(flex, ferrule, columns);
        for (int i = 0; i < count; ++i)
            if (columns.depth_mm[i] > 0.0) tips.emplace_back(columns.x_mm[i], columns.y_mm[i]);
    }
    return tips;
}

Swath move_bristles(const Brush& brush, const HandPose& hand, double step_mm,
                    const film::FilmState& film, std::vector<BristlePose>& poses) {
    const StepFlex flex = step_flex(brush.preset, brush.tip, step_mm);
    const StepDescent descent = step_descent(brush, step_mm);
    const FerrulePose ferrule = ferrule_pose(hand);
    const TuftGrid grid = tuft_grid(film, brush.tip.radius_mm);
    const double girth_mm = brush.preset.tip.girth_mm;
    Swath swath{1e9, -1e9, 0.0F};
    MotionColumns columns{};
    TuftCells tufts;
    const int all = static_cast<int>(poses.size());
    for (int first = 0; first < all; first += MotionColumns::kCount) {
        const int count = std::min(MotionColumns::kCount, all - first);
        fill_columns(&brush.tip.bristles[first], &poses[first], count, columns);
        if (girth_mm > 0.0) roll(&brush.tip.bristles[first], count, hand.rolled_mm, girth_mm, columns);
        core::kernels<MotionKernels>().move(flex, ferrule, columns);
        core::kernels<MotionKernels>().compute_tufts(grid, columns, tufts);
        for (int i = 0; i < count; ++i) {
            BristlePose& pose = poses[first + i];
            if (columns.depth_mm[i] > 0.0) {
                set_down(columns, i, highest_support(film, tufts, i), descent, pose);
                widen(swath, side_mm(pose, hand));
            } else {
                pose = {.lifted = pose.lifted || pose.down, .x_mm = pose.x_mm, .y_mm = pose.y_mm};
            }
        }
    }
    if (brush.preset.flex.rigidity > 0.0) swath.edge_support_mm = edge_support_mm(poses);
    return swath;
}

}  // namespace pastoso::brush
