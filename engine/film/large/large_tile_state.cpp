#include "film/large/large_tile_state.hpp"

#include "core/check.hpp"

#include <limits>

namespace pastoso::film {
namespace {

/// A tile whose error a sweep does not bring below this share is slow.
constexpr float kSlowShare = 0.25F;

constexpr float kNoError = std::numeric_limits<float>::max();

}  // namespace

void LargeTileState::begin_step() {
    cycles_ = Cycles::One;
    drag_ = Drag::Unsteady;
    part_ = Part::Rests;
    change_equations();
}

void LargeTileState::change_equations() {
    PASTOSO_CHECK(part_ != Part::Counts);
    change_ = Change::New;
    equations_ = Equations::Changed;
    flow_ = Flow::Stale;
    corrected_error_ = kNoError;
}

void LargeTileState::steady_drag() {
    PASTOSO_CHECK(drag_ == Drag::Unsteady);
    drag_ = Drag::Steady;
}

void LargeTileState::note_flow() {
    PASTOSO_CHECK(flow_is_stale());
    flow_ = Flow::Known;
}

void LargeTileState::answer_pressure() {
    PASTOSO_CHECK(change_is_stale());
    change_ = Change::New;
}

void LargeTileState::enter_sweep(bool counts) {
    PASTOSO_CHECK(!change_is_stale() && part_ != Part::Counts);
    part_ = counts ? Part::Counts : Part::Rests;
}

void LargeTileState::note_error(float error) {
    PASTOSO_CHECK(part_ != Part::Corrected);
    if (part_ == Part::Counts) error_ = error;
}

bool LargeTileState::choose_correction(bool always, float tolerance) {
    PASTOSO_CHECK(part_ != Part::Corrected);
    if (part_ == Part::Rests) return false;
    const bool corrects = always || !(error_ <= tolerance);
    if (corrects && error_ > kSlowShare * corrected_error_) cycles_ = Cycles::Several;
    corrected_error_ = corrects ? error_ : kNoError;
    part_ = corrects ? Part::Corrected : Part::Rests;
    return corrects;
}

void LargeTileState::blend(bool moved, bool rough) {
    PASTOSO_CHECK(!change_is_stale() && part_ != Part::Counts);
    change_ = moved ? Change::Moved : Change::Known;
    if (moved) flow_ = Flow::Stale;
    equations_ = rough ? Equations::Changed : Equations::Same;
}

void LargeTileState::join_moved() {
    PASTOSO_CHECK(change_ == Change::Known);
    change_ = Change::Beside;
    flow_ = Flow::Stale;
}

}  // namespace pastoso::film
