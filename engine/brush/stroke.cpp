#include "brush/stroke.hpp"

#include "brush/bearing.hpp"
#include "brush/footprint.hpp"
#include "brush/gusts.hpp"
#include "brush/spill.hpp"
#include "brush/wick.hpp"
#include "core/check.hpp"
#include "core/random.hpp"
#include "core/units.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pastoso::brush {
namespace {

/// Length of travel after which neighbouring bristles exchange paint.
constexpr double kWickInterval_mm = 1.0;
/// A bristle exchanges paint at every second step, for the length of two; its footprint is five steps
/// long. Even and odd ones take turns, which keeps their marks out of line. Thin tips, whose turns would
/// be about as long as a cell and leave a ripple, can afford one at every step.
constexpr std::uint32_t kTurns = 2;
constexpr std::size_t kFewBristles = 100;
/// Paint is ploughed at every second step; at every fourth the ridges got steeper than 45 degrees.
constexpr std::uint32_t kPloughTurns = 2;
/// The roundings of ploughed paint, apart from those of the bristles.
constexpr int kPloughSeed = 4095;
/// Length of a pass over a cell, in depths of the tip and radii of a footprint.
constexpr double kPassDepths = 2.0, kPassRadii = 4.0;
/// Width of what is left by a lifted knife, in half thicknesses of its edge, and by a lifted hair, which
/// stays where it has painted.
constexpr double kKnifeHeap_radii = 2.2, kHairHeap_radii = 1.1;
/// A jet of air is never narrower than this share of the tip.
constexpr double kLeastSpread = 0.05;
/// How far a jet of air wavers, in its radii.
constexpr double kWaver_radii = 0.6;

/// The elements of a knife, side by side, act at every step.
std::uint32_t turns_of(const Brush& brush) {
    return brush.tip.rigid || brush.tip.bristles.size() <= kFewBristles ? 1 : kTurns;
}

/// The elements of a knife wait for each other from one end to the other, and what is thrown away is
/// summed in their order.
int most_strips(const Brush& brush, const core::ThreadPool* pool) {
    const bool alone = pool == nullptr || brush.tip.rigid || brush.preset.exchange.absorbs;
    return alone ? 1 : pool->thread_count();
}

/// A tip has passed over a cell when it has travelled by its own depth, with what its hairs trail
/// behind.
double pass_length_mm(const Brush& brush) {
    const TipPreset& tip = brush.preset.tip;
    const double depth_mm =
        std::max(tip.thickness_mm, tip.shape == TipShape::Round ? tip.width_mm : 0.0);
    return kPassDepths * depth_mm + kPassRadii * brush.tip.radius_mm;
}

/// A rectangle around all cells that the footprints may reach.
grid::Rect cells_below(const std::vector<StripPlace>& places, double radius_mm, double cell_mm) {
    const auto cell = [cell_mm](double place_mm) {
        return static_cast<int>(std::clamp(std::floor(place_mm / cell_mm), -1e6, 1e6));
    };
    grid::Rect cells;
    for (const StripPlace& place : places) {
        cells = grid::bounding_box(cells,
                                   {cell(place.x_mm - radius_mm), cell(place.y_mm - radius_mm),
                                    cell(place.x_mm + radius_mm) + 1, cell(place.y_mm + radius_mm) + 1});
    }
    return cells;
}

/// Paint may come from the brush onto the film, and from there into the brush.
std::optional<MediaExchange> meet(Brush& brush, film::FilmState& film) {
    if (brush.holds_paint()) film.consistencies.add(brush.consistencies);
    brush.consistencies = film.consistencies;
    return meet_media(brush, film);
}

}  // namespace

Stroke::Stroke(Brush& brush, film::FilmState& film, const HandAids& aids, const Placement& placement,
               const grid::Mask* limit, core::ThreadPool* pool)
    : brush_(brush),
      film_(film),
      limit_(limit),
      resolved_(resolve(brush.tip, brush.preset.paint, film.cell_mm)),
      turns_(turns_of(brush)),
      placement_(placement),
      path_(brush.preset, brush.tip, aids),
      poses_(brush.tip.bristles.size()),
      cells_(limit),
      pass_(film.shape, pass_length_mm(brush)),
      pool_(pool),
      droplets_(brush, film, limit),
      reads_load_(reads(brush.preset.dynamics, DynamicsInput::Load)) {}

void Stroke::begin(const PenSample& sample) {
    media_ = meet(brush_, film_);
    const bool anew = brush_.preset.stroke.jitter_seed == JitterSeed::Stroke;
    jitter_seed_ = core::scramble(brush_.tip.seed + (anew ? brush_.strokes_begun : 0));
    ++brush_.strokes_begun;
    poses_.assign(poses_.size(), BristlePose{});
    step_count_ = 0;
    since_wick_mm_ = 0.0;
    time_s_ = 0.0;
    rolled_.reset();
    const PenSample start = path_.begin(sample);
    begun_s_ = start.time_s;
    if (brush_.preset.kind == ToolKind::Droplets)
        droplets_.begin(pose({.pen = start}), jitter_seed_, media());
    paint_steps();
}

void Stroke::add(const PenSample& sample) {
    path_.add(sample);
    paint_steps();
}

void Stroke::end() {
    path_.end();
    paint_steps();
    leave_paint();
    if (media_) settle_exchange(*media_, film_, brush_);
    meet(brush_, film_);
    weigh_media(film_, brush_);
    blowing_.reset();
}

void Stroke::pass_time(double seconds) {
    time_s_ += seconds;
    if (brush_.preset.kind == ToolKind::Droplets) droplets_.pass_time(seconds);
}

std::optional<film::AirJet> Stroke::air_jet() const {
    if (!blowing_) return std::nullopt;
    const double radius_mm = brush_.tip.half_width_mm * std::max(blowing_->spread, kLeastSpread);
    const Gust gust = gust_at(jitter_seed_, time_s_);
    HandPose wavering = *blowing_;
    wavering.x_mm += kWaver_radii * radius_mm * gust.x;
    wavering.y_mm += kWaver_radii * radius_mm * gust.y;
    const HandPose hand = placed(placement_, wavering);
    const double share = free_share(hand.x_mm, hand.y_mm);
    if (share <= 0.0) return std::nullopt;
    const double lean = std::max(1.0, std::hypot(hand.lean_x, hand.lean_y));
    return film::AirJet{.x_mm = hand.x_mm,
                        .y_mm = hand.y_mm,
                        .radius_mm = radius_mm,
                        .pressure_Pa = brush_.preset.air.pressure_Pa * hand.flow * hand.press * share,
                        .lean_x = hand.lean_x / lean,
                        .lean_y = hand.lean_y / lean};
}

grid::Rect Stroke::take_changed_cells() {
    return grid::bounding_box(std::exchange(changed_, {}), droplets_.take_changed_cells());
}

double Stroke::free_share(double x_mm, double y_mm) const {
    if (limit_ == nullptr) return 1.0;
    const double x = std::floor(x_mm / film_.cell_mm), y = std::floor(y_mm / film_.cell_mm);
    if (x < 0.0 || y < 0.0 || x >= film_.shape.width || y >= film_.shape.height) return 0.0;
    return grid::fraction_of(limit_->at(static_cast<int>(x), static_cast<int>(y)));
}

void Stroke::paint_steps() {
    if (film_.media.numbers != brush_.media.numbers) media_ = meet_media(brush_, film_);
    for (const PathStep& step : path_.take_steps())
        take_step(step);
}

void Stroke::take_step(const PathStep& step) {
    switch (brush_.preset.kind) {
        case ToolKind::Contact:
            return paint_step(step);
        case ToolKind::Droplets:
            return droplets_.follow(pose(step), step.speed_mm_s);
        case ToolKind::Air:
            blowing_ = hand_pose(brush_.preset.dynamics, step, state());
            return;
    }
}

void Stroke::paint_step(const PathStep& step) {
    HandPose hand = pose(step);
    roll(hand);
    const double turn_mm = turns_ * path_.step_mm();
    const StepRates rates = step_rates(brush_, resolved_, hand, turn_mm);
    const DragRates drag = drag_rates(brush_, resolved_, hand, turn_mm, film_.consistencies);
    const Swath swath = move_bristles(brush_, hand, path_.step_mm(), film_, poses_);
    if (!brush_.tip.rigid) clumps_.find(poses_, hand, brush_.tip.radius_mm);
    ++step_count_;
    pass_.set_travel(step_count_ * path_.step_mm());
    bear(bearing(hand, swath), film_, pass_, poses_);
    if (step_count_ % kPloughTurns == 0) plough(hand, swath);
    touching_.clear();
    for (auto i = static_cast<int>(step_count_ % turns_); i < static_cast<int>(poses_.size());
         i += static_cast<int>(turns_)) {
        const BristlePose& pose = poses_[i];
        if (pose.down) touching_.push_back({i, pose.x_mm, pose.y_mm, side_mm(pose, hand)});
    }
    touch_all({hand, swath, rates, drag});
    for (const StripPlace& place : touching_) {
        note_changed(spill_overflow(brush_, place.element, poses_[place.element], hand, swath,
                                    {brush_.tip.radius_mm, turn_mm, jitter_seed_},
                                    dither_seed(place.element), film_, cells_, media()));
    }
    if (media_) settle_exchange(*media_, film_, brush_);
    since_wick_mm_ += path_.step_mm();
    if (since_wick_mm_ < kWickInterval_mm) return;
    wick_paint(brush_, since_wick_mm_);
    since_wick_mm_ = 0.0;
}

void Stroke::plough(const HandPose& hand, const Swath& swath) {
    const StepRates rates = step_rates(brush_, resolved_, hand, kPloughTurns * path_.step_mm());
    note_changed(plough_.push(
        {brush_, poses_, hand, swath, rates, dither_seed(kPloughSeed), film_, cells_, media()}));
}

void Stroke::touch_all(const Touch& touch) {
    strips_.divide(touching_, resolved_.radius_mm, most_strips(brush_, pool_));
    while (static_cast<int>(tools_.size()) < strips_.count())
        tools_.emplace_back(limit_);
    const auto act = [&](int bristle, int strip) { return touch_one(bristle, touch, tools_[strip]); };
    if (media_) share_media();
    if (strips_.count() > 1) pass_.prepare(cells_below(touching_, resolved_.radius_mm, film_.cell_mm));
    while (!strips_.run(pool_, act)) {
        for (const int strip : strips_.hindered())
            own_planned_tiles(tools_[strip].cells, film_);
    }
    for (StripTools& tools : tools_)
        note_changed(std::exchange(tools.changed, {}));
    if (media_) collect_media();
}

void Stroke::share_media() {
    const double reach_mm = std::max(resolved_.reach_mm, resolved_.radius_mm) + film_.cell_mm;
    prepare_media(*media_, cells_below(touching_, reach_mm, film_.cell_mm), film_);
    for (StripTools& tools : tools_) {
        tools.media = *media_;
        tools.media.gained = {};
    }
}

void Stroke::collect_media() {
    for (const StripTools& tools : tools_)
        for (std::size_t k = 0; k < media_->gained.size(); ++k)
            media_->gained[k] += tools.media.gained[k];
}

bool Stroke::touch_one(int bristle, const Touch& touch, StripTools& tools) {
    const Contact below = contact(bristle, touch);
    tools.cells.gather(film_, below.x_mm, below.y_mm, resolved_.reach_mm, &pass_);
    const ExchangeRule rule = exchange_rule(brush_, bristle, below, touch.rates);
    const WantedSums wanted = plan_exchange(rule, tools.cells);
    Contents& held = brush_.held[bristle];
    const ApplyRule applied =
        apply_rule(touch_limits(brush_, below), wanted, dither_seed(bristle), film_, held, tools.cells);
    if (strips_.count() > 1 && !owns_planned_tiles(tools.cells, film_)) return false;
    tools.changed = grid::bounding_box(
        tools.changed, apply(applied, tools.cells, film_, held, media_ ? &tools.media : nullptr));
    if (brush_.preset.exchange.absorbs) brush_.thrown_away += std::exchange(held, Contents{});
    if (tools.drag.find(rule, touch.drag, tools.cells, film_)) {
        const std::lock_guard lock(velocities_);
        tools.changed = grid::bounding_box(tools.changed, tools.drag.apply(touch.drag, film_));
    }
    return true;
}

void Stroke::leave_paint() {
    const double radius_mm =
        brush_.tip.radius_mm * (brush_.tip.rigid ? kKnifeHeap_radii : kHairHeap_radii);
    for (int i = 0; i < static_cast<int>(poses_.size()); ++i) {
        const double share = left_share(i);
        if (share <= 0.0) continue;
        Contents& held = brush_.held[i];
        note_changed(put_down(held, share * held.volume_mm3, poses_[i].x_mm, poses_[i].y_mm, radius_mm,
                              dither_seed(i), film_, cells_, media()));
    }
    poses_.assign(poses_.size(), BristlePose{});
}

void Stroke::note_changed(const grid::Rect& cells) {
    changed_ = grid::bounding_box(changed_, cells);
}

std::uint32_t Stroke::dither_seed(int bristle) const {
    return core::scramble(jitter_seed_ + step_count_ * 4096U + static_cast<std::uint32_t>(bristle));
}

}  // namespace pastoso::brush
