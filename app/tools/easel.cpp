#include "tools/easel.hpp"

#include "brush/preset.hpp"
#include "document/well.hpp"
#include "tools/canvas_resizing.hpp"
#include "tools/paint_share.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pastoso::tools {

using namespace document;

namespace {

/// A stroke shorter than this gives a ruler no direction.
constexpr double kShortestRuler_mm = 5.0;

/// A hand that has sent nothing for so long has rested, and left when its next event is due.
constexpr double kRest_s = 0.1;
constexpr double kEventInterval_s = 0.008;

/// Tilt to the right and towards the painter of a tool that is held aslant: 50 degrees from upright.
constexpr double kAslant_deg = 40.0;

/// The way after which a stroke has a direction.
constexpr double kDecidingWay_mm = 2.0;
/// A tip that started less askew than this is left as it is.
constexpr double kSeenTurn_deg = 4.0;

/// Dollops in a row, along the upper edge of the well and then along the lower one.
constexpr double kDollop_mm3 = 250.0;
constexpr int kPlacesInRow = 5;
constexpr double kPlaceMargin_mm = 13.0;

/// After so many time constants a steadied brush is where the pen is, to a hundredth of its lag.
constexpr double kCatchUp = 5.0;

/// A brush that is no other than the bundled one of its name goes by its name.
void keep_preset(Hand& hand, const brush::Preset& preset) {
    const auto& bundled = brush::bundled_presets();
    const bool is_bundled = std::find(bundled.begin(), bundled.end(), preset) != bundled.end();
    hand.brush = preset.name;
    hand.own_preset = is_bundled ? std::nullopt : std::optional(preset);
}

bool is_some(const brush::PenGuide& guide) {
    return !std::holds_alternative<std::monostate>(guide.form);
}

/// Whether it is one that lies on the canvas until it is taken away.
bool is_laid(const brush::PenGuide& guide) {
    return is_some(guide) && !std::holds_alternative<brush::StraightLine>(guide.form);
}

}  // namespace

Easel::Easel(Hand hand, Post post, std::function<void()> note_hand)
    : hand_(std::move(hand)), post_(std::move(post)), note_hand_(std::move(note_hand)) {}

void Easel::set_up() {
    post_(hand_.medium);
    post_(hand_.tilt);
    post_(SetDrying{hand_.air});
    if (hand_.stabiliser != brush::Stabiliser{}) post_(SetStabiliser{hand_.stabiliser});
    hand_.guide = {};
    squeezed_ = 0;
    take_brush(preset_in_hand(hand_), hand_.brush_width_mm);
    if (!hand_.brush_aside) return;
    post_(LayBrushAside{*hand_.brush_aside});
    aside_ = {.changed = true};
}

void Easel::take_brush(const std::string& preset, double width_mm) {
    take_brush(brush::find_preset(preset), width_mm);
}

void Easel::take_brush(const brush::Preset& preset, double width_mm) {
    end_stroke();
    keep_preset(hand_, preset);
    hand_.brush_width_mm = std::clamp(width_mm, kSmallestBrush_mm, kLargestBrush_mm);
    ++brushes_taken_;
    post_brush();
}

void Easel::post_brush() {
    brush_changed_ = false;
    post_(taken_of(hand_, brushes_taken_));
    reload();
}

void Easel::take_for_now(const brush::Preset& preset, double width_mm) {
    end_stroke();
    Hand other;
    keep_preset(other, preset);
    other.brush_width_mm = std::clamp(width_mm, kSmallestBrush_mm, kLargestBrush_mm);
    aside_ = {};
    ++brushes_taken_;
    do_with_brushes(LayBrushAside{taken_of(other, brushes_taken_)});
    swap_brushes();
    if (preset.dips) post_(load_of(hand_));
}

void Easel::swap_brushes() {
    end_stroke();
    std::swap(aside_.mixed, mixed_);
    std::swap(aside_.changed, brush_changed_);
    do_with_brushes(SwapBrushes{});
}

/// In the hand as in the painting.
void Easel::do_with_brushes(const document::Action& action) {
    hand_ = hand_after(std::move(hand_), {{0, action}});
    post_(action);
}

void Easel::change_brush(const brush::Preset& preset) {
    change_brush(preset, hand_.brush_width_mm);
}

void Easel::change_brush(const brush::Preset& preset, double width_mm) {
    keep_preset(hand_, preset);
    hand_.brush_width_mm = std::clamp(width_mm, kSmallestBrush_mm, kLargestBrush_mm);
    brush_changed_ = true;
}

void Easel::set_brush_width(double width_mm) {
    const double width = std::clamp(width_mm, kSmallestBrush_mm, kLargestBrush_mm);
    if (width != hand_.brush_width_mm) take_brush(preset_in_hand(hand_), width);
}

void Easel::choose_paint(const PaintRecipe& paint) {
    hand_.paint = paint;
    reload();
}

void Easel::reload() {
    clean();
    dip();
}

void Easel::dip() {
    end_stroke();
    if (preset_in_hand(hand_).dips) post_(load_of(hand_));
}

void Easel::blot() {
    constexpr double kTaken = 0.75;
    end_stroke();
    post_(CleanBrush{kTaken});
}

void Easel::clean() {
    end_stroke();
    mixed_ = false;
    post_(CleanBrush{});
}

void Easel::swap_paints() {
    std::swap(hand_.paint, hand_.second_paint);
    reload();
}

void Easel::set_dip(const Dip& dip) {
    hand_.dip = dip;
}

void Easel::use_medium(const std::string& name) {
    share_before_wash_ = 1.0;
    pour({name});
}

void Easel::change_medium(const film::Medium& medium) {
    const bool is_bundled = medium == film::find_medium(medium.name);
    pour({medium.name, is_bundled ? std::nullopt : std::optional(medium), hand_.medium.paint_share});
}

void Easel::set_paint_share(double share) {
    UseMedium medium = hand_.medium;
    medium.paint_share = std::clamp(share, film::kLeastPaintShare, 1.0);
    if (medium == hand_.medium || !can_thin(hand_)) return;
    if (hand_.medium.paint_share > kWashShare) share_before_wash_ = hand_.medium.paint_share;
    pour(medium);
}

void Easel::thin_to_wash(bool wash) {
    set_paint_share(wash ? kWashShare : share_before_wash_);
}

void Easel::pour(const UseMedium& medium) {
    clean();
    hand_.medium = medium;
    post_(hand_.medium);
    reload();
}

void Easel::tilt(double tilt_deg, double direction_deg) {
    hand_.tilt = {tilt_deg, direction_deg};
    post_(hand_.tilt);
}

void Easel::set_drying_speed(double speed) {
    hand_.air.speed = speed;
    post_(SetDrying{hand_.air});
}

void Easel::dry_now() {
    end_stroke();
    post_(DryNow{});
}

void Easel::set_reload_each_stroke(bool reload) {
    hand_.reload_each_stroke = reload;
}

void Easel::set_turn_with_stroke(bool turn) {
    hand_.turn_with_stroke = turn;
}

void Easel::set_tilted(bool tilted) {
    hand_.tilted = tilted;
}

void Easel::set_stabiliser(const brush::Stabiliser& stabiliser) {
    hand_.stabiliser = stabiliser;
    post_(SetStabiliser{stabiliser});
}

void Easel::set_symmetry(const brush::Symmetry& symmetry) {
    hand_.symmetry = symmetry;
    post_(SetSymmetry{symmetry});
}

brush::Ruler Easel::ruler_along_stroke(const brush::Ruler& otherwise) const {
    const double x_mm = latest_.x_mm - pressed_.x_mm, y_mm = latest_.y_mm - pressed_.y_mm;
    const bool has_direction = std::hypot(x_mm, y_mm) >= kShortestRuler_mm;
    return has_direction ? brush::Ruler{pressed_.x_mm, pressed_.y_mm, latest_.x_mm, latest_.y_mm}
                         : otherwise;
}

void Easel::lay_guide(const brush::PenGuide& guide) {
    hand_.laid = guide;
}

void Easel::take_guide_away() {
    hand_.laid.form = {};
    forget_guide();
}

/// Or a painting that is opened again would lay it again. A stroke under way keeps what guides it.
void Easel::forget_guide() {
    if (painting_ || !is_laid(hand_.guide)) return;
    hand_.guide = {};
    post_(SetGuide{hand_.guide});
}

void Easel::select(const Action& selection) {
    end_stroke();
    post_(selection);
}

void Easel::move_along(const CanvasMove& move) {
    hand_ = moved_along(std::move(hand_), move);
    for (Pointer* pointer : {&pressed_, &latest_}) {
        const glm::dvec2 place_mm = move({pointer->x_mm, pointer->y_mm});
        pointer->x_mm = place_mm.x;
        pointer->y_mm = place_mm.y;
    }
    if (hand_.symmetry.mirror || hand_.symmetry.count > 1) post_(SetSymmetry{hand_.symmetry});
    if (is_laid(hand_.guide)) post_(SetGuide{hand_.guide});
    if (hand_.air.fan_radius_mm > 0.0) post_(SetDrying{hand_.air});
}

void Easel::resize(const ResizeCanvas& resize) {
    end_stroke();
    post_(resize);
}

void Easel::turn_canvas(const TurnCanvas& turn) {
    end_stroke();
    post_(turn);
}

void Easel::scale_canvas(const ScaleCanvas& scale) {
    end_stroke();
    post_(scale);
}

void Easel::rotate_canvas(const RotateCanvas& rotate) {
    end_stroke();
    post_(rotate);
}

void Easel::transform(const TransformLayer& transform) {
    end_stroke();
    post_(transform);
}

void Easel::distort(const DistortLayer& distort) {
    end_stroke();
    post_(distort);
}

void Easel::tone_ground(const ToneGround& tone) {
    end_stroke();
    post_(tone);
}

void Easel::lay_texture(const LayTexture& lay) {
    end_stroke();
    post_(lay);
}

void Easel::adjust_dry_paint(const AdjustDryPaint& adjust) {
    end_stroke();
    post_(adjust);
}

void Easel::fill(const FillWithPaint& fill) {
    end_stroke();
    post_(fill);
}

void Easel::undo() {
    end_stroke();
    post_(Undo{});
}

void Easel::redo() {
    end_stroke();
    post_(Redo{});
}

void Easel::squeeze(double x_mm, double y_mm) {
    squeeze(hand_.paint, x_mm, y_mm, false);
}

void Easel::squeeze(const document::PaintRecipe& paint, double x_mm, double y_mm, bool joins) {
    end_stroke();
    squeezed_paints_.note(paint);
    post_(SqueezePaint{paint, kDollop_mm3, std::clamp(x_mm, 0.0, kWellWidth_mm),
                       std::clamp(y_mm, 0.0, kWellHeight_mm), joins});
}

void Easel::squeeze_next(const document::PaintRecipe& paint, bool joins) {
    const int column = squeezed_ % kPlacesInRow, row = squeezed_ / kPlacesInRow % 2;
    const double step_mm = (kWellWidth_mm - 2.0 * kPlaceMargin_mm) / (kPlacesInRow - 1);
    squeeze(paint, kPlaceMargin_mm + column * step_mm,
            row == 0 ? kPlaceMargin_mm : kWellHeight_mm - kPlaceMargin_mm, joins);
    ++squeezed_;
}

void Easel::squeeze_puddle(const document::Puddle& puddle, bool joins) {
    end_stroke();
    post_(SqueezePaint{puddle.paint, std::clamp(puddle.volume_mm3, kLeastSqueeze_mm3, kMostSqueeze_mm3),
                       puddle.x_mm, puddle.y_mm, joins});
}

void Easel::clean_well() {
    end_stroke();
    squeezed_ = 0;
    squeezed_paints_.wipe();
    post_(CleanWell{});
}

void Easel::press(const Pointer& pointer, bool straight) {
    if (lent_) return;
    end_stroke();
    painting_on_ = pointer.surface;
    if (brush_changed_) post_brush();
    if (pointer.surface == Surface::Well) {
        mixed_ = true;
    } else {
        if (hand_.reload_each_stroke && !mixed_) reload();
        choose_guide(pointer, straight);
        pressed_ = latest_ = pointer;
    }
    painting_ = true;
    follow(pointer);
    previous_ = sample(pointer);
    if (turns_with_path(pointer)) start_ = pointer;
    start_rotation_deg_ = rotation_deg_;
    post_(PenDown{previous_, pointer.surface, pointer.beside});
}

void Easel::move(const Pointer& pointer) {
    follow(pointer);
    if (!painting_ || pointer.surface != painting_on_) return;
    if (pointer.surface == Surface::Canvas) latest_ = pointer;
    if (start_) decide_start(pointer);
    const brush::PenSample next = sample(pointer);
    if (next.time_s - previous_.time_s > kRest_s) {
        previous_.time_s = next.time_s - kEventInterval_s;
        post_(PenMove{previous_});
    }
    previous_ = next;
    post_(PenMove{next});
}

void Easel::release() {
    end_stroke();
}

void Easel::wait(double seconds, Surface surface) {
    if (!painting_ || surface != painting_on_ ||
        waited_s_ >= kCatchUp * hand_.stabiliser.smoothing_ms / 1000.0)
        return;
    waited_s_ += seconds;
    previous_time_s_ = previous_.time_s += seconds;
    post_(PenMove{previous_});
}

void Easel::end_stroke() {
    if (!std::exchange(painting_, false)) return;
    start_.reset();
    post_(PenUp{});
}

/// Whether the tip is one that can stand askew, and nothing but its path tells how it is turned.
bool Easel::turns_with_path(const Pointer& pointer) const {
    const bool guided = pointer.surface == Surface::Canvas && hand_.guide.turn_across;
    if (!hand_.turn_with_stroke || pointer.rotation_deg || guided) return false;
    const brush::Preset preset = preset_in_hand(hand_);
    return preset.kind == brush::ToolKind::Contact && preset.tip.shape != brush::TipShape::Round;
}

/// The first way of a stroke decides how it starts.
void Easel::decide_start(const Pointer& pointer) {
    const double dx_mm = pointer.x_mm - start_->x_mm, dy_mm = pointer.y_mm - start_->y_mm;
    if (std::hypot(dx_mm, dy_mm) < kDecidingWay_mm) return;
    start_.reset();
    heading_.stand_across(dx_mm, dy_mm);
    rotation_deg_ = heading_.rotation_deg();
    const auto is_turned = [&](double laid_deg) {
        return std::abs(std::remainder(rotation_deg_ - laid_deg, 180.0)) > kSeenTurn_deg;
    };
    if (is_turned(start_rotation_deg_) || is_turned(previous_.rotation_deg))
        post_(TurnStroke{rotation_deg_});
}

/// A brush that turns with the stroke stands across what guides it, unless the pen tells its rotation.
void Easel::choose_guide(const Pointer& pointer, bool straight) {
    brush::PenGuide guide;
    if (straight)
        guide.form = brush::StraightLine{};
    else if (is_some(hand_.laid))
        guide = hand_.laid;
    const bool guides = is_some(guide) && guide.strength > 0.0;
    guide.turn_across = guides && hand_.turn_with_stroke && !pointer.rotation_deg;
    if (guide == hand_.guide) return;
    hand_.guide = guide;
    post_(SetGuide{guide});
}

std::optional<Pointer> Easel::line_start() const {
    if (!painting_ || painting_on_ != Surface::Canvas ||
        !std::holds_alternative<brush::StraightLine>(hand_.guide.form))
        return {};
    return pressed_;
}

void Easel::follow(const Pointer& pointer) {
    if (note_hand_) note_hand_();
    waited_s_ = 0.0;
    heading_.moved_to(pointer.x_mm, pointer.y_mm);
    const double held_deg = hand_.turn_with_stroke ? heading_.rotation_deg() : pointer.hand_deg;
    rotation_deg_ = pointer.rotation_deg.value_or(held_deg);
    followed_ = pointer;
}

brush::PenSample Easel::held() const {
    const bool aslant = hand_.tilted && !followed_.tells_tilt;
    return {.pressure = std::clamp(followed_.pressure, 0.0, 1.0),
            .tilt_x_deg = aslant ? kAslant_deg : std::clamp(followed_.tilt_x_deg, -90.0, 90.0),
            .tilt_y_deg = aslant ? kAslant_deg : std::clamp(followed_.tilt_y_deg, -90.0, 90.0),
            .rotation_deg = rotation_deg_,
            .wheel = std::clamp(followed_.wheel, -1.0, 1.0)};
}

/// The sample in the engine's terms. Time starts at the first touch and never runs backwards, even where
/// a driver's clock does.
brush::PenSample Easel::sample(const Pointer& pointer) {
    if (!std::exchange(has_clock_zero_, true)) clock_zero_ms_ = pointer.time_ms;
    const std::uint64_t since_ms = pointer.time_ms - std::min(clock_zero_ms_, pointer.time_ms);
    previous_time_s_ = std::max(previous_time_s_, 1e-3 * static_cast<double>(since_ms));
    brush::PenSample sample = held();
    sample.time_s = previous_time_s_;
    sample.x_mm = pointer.x_mm;
    sample.y_mm = pointer.y_mm;
    return sample;
}

}  // namespace pastoso::tools
