// The part of MilkTea that gives its state away and takes it back.

#include "core/error.hpp"
#include "core/value_range.hpp"
#include "liquid/tea/milk_tea.hpp"
#include "liquid/tea/parcel_shape.hpp"

#include <utility>

namespace pastoso::liquid {
namespace {

constexpr int kMostSteps = 1 << 30;
constexpr double kLongest_s = 1e9;

/// Parcels are looked up in the cells around them, and balls by their number.
void check_parcels(const TeaState& state, double box_m) {
    core::check_range_of("The number of parcels", static_cast<double>(state.parcels.size()), 0,
                         kMaxParcels);
    for (const Parcel& parcel : state.parcels) {
        for (const int axis : kAxes)
            core::check_range_of("A parcel's place", static_cast<double>(parcel.position_m[axis]), 0.0,
                                 box_m);
        core::check_range_of("A parcel's volume", static_cast<double>(parcel.volume_m3), 0.0, 1.0);
        core::check_range_of("A parcel's coldness", static_cast<double>(parcel.coldness), 0.0, 1.0);
        core::check_range_of("A parcel's ball", parcel.ball, -1, state.balls.count - 1);
        if (!is_shape(parcel.shape)) throw core::InputError("A parcel's shape is none.");
    }
}

void check_stream(const MilkJug::Stream& stream) {
    core::check_range_of("The stream's time", stream.seconds, 0.0, kLongest_s);
    core::check_range_of("The stream's end", stream.until_s, 0.0, kLongest_s);
    core::check_range_of("The stream's parcels", stream.parcels, 0, kMostSteps);
    for (const int axis : {0, 1})
        core::check_range_of("The stream's place", static_cast<double>(stream.at_m[axis]), -1e3, 1e3);
}

void check_numbers(const TeaState& state) {
    core::check_range_of("The step", state.step, 0, kMostSteps);
    // A step makes one at most.
    core::check_range_of("The number of balls", state.balls.count, 0, state.step);
    core::check_range_of("The next ball's time", state.balls.next_s, 0.0, kLongest_s);
    core::check_range_of("The milk that was poured", state.jug.poured_m3, 0.0, 1.0);
    check_stream(state.jug.recipe);
    check_stream(state.jug.hand);
}

}  // namespace

TeaState MilkTea::state() const {
    return {steps_, parcels_, dissolved_, coldness_, flow_->state(), balls_.state(), jug_.state()};
}

void MilkTea::set_state(TeaState state) {
    check_numbers(state);
    check_parcels(state, settings_.box_m);
    if (state.dissolved.shape() != flow_->shape() || state.coldness.shape() != flow_->shape())
        throw core::InputError("The state is that of another box of cells.");
    flow_->set_state(state.flow);  // which throws before anything has changed
    jug_.set_state(state.jug, settings_);
    fill_flow();
    flow_->set_state(std::move(state.flow));
    steps_ = state.step;
    parcels_ = std::move(state.parcels);
    dissolved_ = std::move(state.dissolved);
    coldness_ = std::move(state.coldness);
    balls_.set_state(state.balls);
    core::ThreadPool this_thread(1);
    sorter_.sort(parcels_, this_thread);
    clear_parcel_fields();
    share_out_sorted(
        parcels_, flow_->walls().open_cells(), shared_fields(), this_thread,
        [per_m3 = cells_per_m3()](const Parcel& parcel) { return undissolved(parcel, per_m3); });
}

}  // namespace pastoso::liquid
