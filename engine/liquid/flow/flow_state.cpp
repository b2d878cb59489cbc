// The part of VesselFlow that gives its state away and takes it back.

#include "core/error.hpp"
#include "liquid/flow/flow.hpp"

#include <algorithm>
#include <utility>

namespace pastoso::liquid {
namespace {

/// An advection writes these samples before anybody reads them.
void blank(const RowRanges& rows, grid::BoxField& field) {
    const grid::BoxShape& shape = field.shape();
    for (int k = 0; k <= shape.nz; ++k)
        for (int j = 0; j <= shape.ny; ++j) {
            const RowRange range = rows.at(j, k);
            if (!range.empty())
                std::fill(field.row(j, k) + range.begin, field.row(j, k) + range.end, 0.0F);
        }
}

}  // namespace

FlowState VesselFlow::state() const {
    FlowState state{velocity_, pressure(), advected_, {}};
    for (const int axis : kAxes)
        blank(walls_.rows(face_across(axis)), state.spare_velocity.along(axis));
    for (const grid::BoxField& cells : cells_)
        if (!cells.values().empty()) {
            state.spare_cells.push_back(cells);
            blank(walls_.rows(Location::Cell), state.spare_cells.back());
        }
    return state;
}

void VesselFlow::set_state(FlowState state) {
    const auto fits = [&](const grid::BoxField& field) { return field.shape() == shape(); };
    const auto all_fit = [&](const VelocityField& field) {
        return fits(field.x) && fits(field.y) && fits(field.z);
    };
    if (!all_fit(state.velocity) || !all_fit(state.spare_velocity) || !fits(state.pressure) ||
        !std::ranges::all_of(state.spare_cells, fits) || state.spare_cells.size() > cells_.size())
        throw core::InputError("The state is that of another box of cells.");
    velocity() = std::move(state.velocity);
    advected_ = std::move(state.spare_velocity);
    projection_.set_pressure(std::move(state.pressure));
    cells_ = {};
    std::ranges::move(state.spare_cells, cells_.begin());
}

}  // namespace pastoso::liquid
