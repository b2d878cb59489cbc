#include "brush/plough.hpp"

#include "brush/cell_mean.hpp"
#include "brush/nearest_cell.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pastoso::brush {
namespace {

/// Speed at which a tip with momentum 1 pushes 1 - 1/e of the paint in its way.
constexpr double kPushingSpeed_mm_s = 100.0;
/// Width of a lane, in footprint radii of a bristle.
constexpr double kLane_radii = 1.5;
/// How far ahead of the leader paint is pushed, and how far it gets: clear of the leader's own marks.
constexpr double kAhead_radii = 2.0;
/// Length over which paint gets out to the side, in half widths of the tip, when all of it is pushed.
constexpr double kAside_half_widths = 0.25;
/// Paint gives way to the hairs unless it stands higher above them than this.
constexpr float kGivesWay_mm = 0.1F;
/// Lanes on either side whose leaders' marks reach into a lane.
constexpr int kReachedLanes = 2;

/// Least length of a lane's footprint, in cells.
constexpr double kLeastReach_cells = 0.75;

struct Place {
    double x_mm, y_mm;
};

/// Height of the wet surface, or that of the nearest place on the canvas; below everything where it is
/// dry.
float surface_at(const film::FilmState& film, double x_mm, double y_mm) {
    constexpr float kNone_mm = -1e6F;
    const auto [x, y] = nearest_cell(film, x_mm, y_mm);
    const int tile = film.shape.tile_at(x, y), cell = grid::Shape::cell_in_tile(x, y);
    const std::int32_t thickness = film.thickness.read(tile)[cell];
    return thickness > 0 ? film.support_mm.read(tile)[cell] + film::thickness_mm(thickness) : kNone_mm;
}

Place place_at(const HandPose& hand, double along_mm, double across_mm) {
    return {hand.x_mm + along_mm * hand.travel_x - across_mm * hand.travel_y,
            hand.y_mm + along_mm * hand.travel_y + across_mm * hand.travel_x};
}

/// Half length of the footprint that clears a lane.
double half_length_mm(const PloughStep& step) {
    return std::max(step.brush.tip.radius_mm, kLeastReach_cells * step.film.cell_mm);
}

/// An element's rule turned into one that only clears the way.
ExchangeRule clearing_rule(ExchangeRule rule, const HandPose& hand, const StepRates& rates,
                           const LaneOnCells& lane, double radius_mm, double pushed) {
    rule.lane = rule.side_by_side = true;
    rule.lane_core = lane.core;
    rule.rate = static_cast<float>(pushed) * rates.rate;
    rule.across_x = static_cast<float>(-hand.travel_y / lane.reach_mm);
    rule.across_y = static_cast<float>(hand.travel_x / lane.reach_mm);
    rule.along_x = static_cast<float>(hand.travel_x / radius_mm);
    rule.along_y = static_cast<float>(hand.travel_y / radius_mm);
    rule.crown = 1.0F;
    rule.profile_mm = rule.coat = rule.mix = 0.0F;
    rule.lowest_mm = rule.underside_mm;
    rule.fade_per_mm = 1.0F / kGivesWay_mm;
    rule.pickup = 1.0F;
    return rule;
}

/// How much of what is pushed at a place in the swath gets out at each of its edges.
struct EdgeShares {
    double low, high;
};
EdgeShares edge_shares(const Swath& swath, double side_mm, double aside_mm) {
    const double low = std::exp(-std::max(0.0, side_mm - swath.low_mm) / aside_mm);
    const double high = std::exp(-std::max(0.0, swath.high_mm - side_mm) / aside_mm);
    const double most = std::max(1.0, low + high);
    return {low / most, high / most};
}

/// Whether paint stands above the underside in the middle of a lane's footprint or half way to its ends.
bool stands_in_way(const film::FilmState& film, const Place& place, const ExchangeRule& rule,
                   double lane_reach_mm, double radius_mm) {
    const double along_x = 0.5 * radius_mm * radius_mm * rule.along_x;
    const double along_y = 0.5 * radius_mm * radius_mm * rule.along_y;
    const double across_x = 0.5 * lane_reach_mm * lane_reach_mm * rule.across_x;
    const double across_y = 0.5 * lane_reach_mm * lane_reach_mm * rule.across_y;
    const auto above = [&](double x_mm, double y_mm) {
        return surface_at(film, place.x_mm + x_mm, place.y_mm + y_mm) > rule.underside_mm;
    };
    return above(0.0, 0.0) || above(along_x, along_y) || above(-along_x, -along_y) ||
           above(across_x, across_y) || above(-across_x, -across_y);
}

Contents part_of(const Contents& whole, double share) {
    Contents part = whole;
    part.volume_mm3 *= share;
    for (double& amount : part.paint)
        amount *= share;
    return part;
}

}  // namespace

double pushed_share(double momentum, double speed_mm_s) {
    return 1.0 - std::exp(-momentum * speed_mm_s / kPushingSpeed_mm_s);
}

grid::Rect Plough::push(const PloughStep& step) {
    pushed_ = pushed_share(step.brush.preset.exchange.momentum, step.hand.speed_mm_s);
    changed_ = {};
    pile_ = {};
    pile_media_ = {};
    const bool touches = step.swath.low_mm <= step.swath.high_mm;
    if (pushed_ <= 0.0 || !touches) return {};
    divide(step);
    const double aside_mm = kAside_half_widths * pushed_ * step.brush.tip.half_width_mm;
    Contents low, high;
    for (const Lane& lane : lanes_) {
        Contents moved = clear(step, lane);
        if (moved.volume_mm3 <= 0.0) continue;
        const EdgeShares aside = edge_shares(step.swath, lane.middle_mm, aside_mm);
        low += part_of(moved, aside.low);
        high += part_of(moved, aside.high);
        heap_ahead(step, lane, part_of(moved, std::max(0.0, 1.0 - aside.low - aside.high)));
    }
    // A brush in the mirror works from the other side.
    const bool high_first = step.brush.tip.mirrored;
    heap_beside(step, high_first ? 1.0 : -1.0, high_first ? high : low);
    heap_beside(step, high_first ? -1.0 : 1.0, high_first ? low : high);
    if (step.media != nullptr)
        for (std::size_t k = 0; k < pile_.gained.size(); ++k)
            step.media->gained[k] += pile_.gained[k];
    return changed_;
}

void Plough::divide(const PloughStep& step) {
    const Tip& tip = step.brush.tip;
    const double wanted_mm = tip.rigid ? tip.lane_mm : kLane_radii * half_length_mm(step);
    const double low_mm = step.swath.low_mm - 0.5 * wanted_mm;
    const double width_mm = step.swath.high_mm + 0.5 * wanted_mm - low_mm;
    // Odd, so that what stands in the middle is nearer to no lane than in the mirror.
    const int count = 2 * static_cast<int>(0.5 * width_mm / wanted_mm) + 1;
    lane_width_mm_ = width_mm / count;
    lanes_.assign(static_cast<std::size_t>(count), Lane{});
    for (int i = 0; i < static_cast<int>(step.poses.size()); ++i) {
        const BristlePose& pose = step.poses[i];
        if (!pose.down) continue;
        const double place = (side_mm(pose, step.hand) - low_mm) / lane_width_mm_;
        const int index = std::clamp(static_cast<int>(place), 0, count - 1);
        const double front_mm = (pose.x_mm - step.hand.x_mm) * step.hand.travel_x +
                                (pose.y_mm - step.hand.y_mm) * step.hand.travel_y;
        Lane& lane = lanes_[static_cast<std::size_t>(index)];
        if (lane.leader >= 0 && front_mm <= lane.front_mm) continue;
        lane = {i, front_mm, low_mm + (index + 0.5) * lane_width_mm_};
    }
    align_fronts();
    std::erase_if(lanes_, [](const Lane& lane) { return lane.leader < 0; });
    if (tip.mirrored) std::reverse(lanes_.begin(), lanes_.end());
}

void Plough::align_fronts() {
    std::vector<double>& fronts = fronts_mm_;
    fronts.clear();
    const int count = static_cast<int>(lanes_.size());
    for (int i = 0; i < count; ++i) {
        const int first = std::max(0, i - kReachedLanes), last = std::min(count - 1, i + kReachedLanes);
        double front_mm = lanes_[i].front_mm;
        for (int j = first; j <= last; ++j) {
            if (lanes_[j].leader >= 0) front_mm = std::max(front_mm, lanes_[j].front_mm);
        }
        fronts.push_back(front_mm);
    }
    for (int i = 0; i < count; ++i)
        lanes_[i].front_mm = fronts[i];
}

Contents Plough::clear(const PloughStep& step, const Lane& lane) {
    const double radius_mm = half_length_mm(step);
    const Place place = place_at(step.hand, lane.front_mm + kAhead_radii * radius_mm, lane.middle_mm);
    Contact contact;
    contact.support_mm = step.poses[lane.leader].bearing_mm;
    contact.press = step.poses[lane.leader].press;
    contact.ride = step.poses[lane.leader].ride;
    const double pushed = pushed_ * (step.brush.tip.rigid ? 1.0F : firmness(contact.press));
    const LaneOnCells on_cells = lane_on_cells(lane_width_mm_, step.film.cell_mm);
    const ExchangeRule rule = clearing_rule(exchange_rule(step.brush, lane.leader, contact, step.rates),
                                            step.hand, step.rates, on_cells, radius_mm, pushed);
    if (!stands_in_way(step.film, place, rule, on_cells.reach_mm, radius_mm)) return {};
    step.scratch.gather(step.film, place.x_mm, place.y_mm, std::hypot(on_cells.reach_mm, radius_mm));
    Contents moved;
    if (step.scratch.count() == 0) return moved;
    const WantedSums wanted = plan_exchange(rule, step.scratch);
    const MediaExchange before = pile_;
    changed_ = grid::bounding_box(changed_, apply_batch(step.scratch, wanted, {}, step.dither_seed,
                                                        step.film, moved, pile_of(step)));
    pile_up_media(before);
    return moved;
}

void Plough::pile_up_media(const MediaExchange& before) {
    for (std::size_t k = 0; k < pile_media_.size(); ++k)
        pile_media_[k] += static_cast<double>(before.gained[k] - pile_.gained[k]);
    pile_.give_shares_of(pile_media_);
}

void Plough::heap_ahead(const PloughStep& step, const Lane& lane, Contents moved) {
    const double along_mm = lane.front_mm + 2.0 * kAhead_radii * half_length_mm(step);
    const Place place = place_at(step.hand, along_mm, lane.middle_mm);
    heap(step, lane.leader, {place.x_mm, place.y_mm, lane_width_mm_}, moved);
}

void Plough::heap_beside(const PloughStep& step, double sign, Contents moved) {
    if (moved.volume_mm3 <= 0.0) return;
    const auto outer = std::max_element(
        lanes_.begin(), lanes_.end(),
        [sign](const Lane& a, const Lane& b) { return sign * a.middle_mm < sign * b.middle_mm; });
    const double radius_mm = half_length_mm(step);
    const double edge_mm = sign > 0.0 ? step.swath.high_mm : step.swath.low_mm;
    const Place place = place_at(step.hand, outer->front_mm + kAhead_radii * radius_mm, edge_mm);
    heap(step, outer->leader,
         place_beside(step.film, place.x_mm, place.y_mm, -step.hand.travel_y * sign,
                      step.hand.travel_x * sign, radius_mm, radius_mm),
         moved);
}

void Plough::heap(const PloughStep& step, int leader, const HeapPlace& place, Contents& moved) {
    if (thickness_at(step.film, place.x_mm, place.y_mm) > 0.0)
        changed_ = grid::bounding_box(
            changed_, put_down(moved, moved.volume_mm3, place.x_mm, place.y_mm, place.spread_mm,
                               step.dither_seed, step.film, step.scratch, pile_of(step)));
    Brush& brush = step.brush;
    (brush.preset.exchange.absorbs ? brush.thrown_away : brush.held[leader]) += moved;
}

}  // namespace pastoso::brush
