// What the drag law leaves of a velocity in a large step, and how that changes with it: shared by the
// kernels of one instruction set.
#pragma once

#include "film/face/face_drag.hpp"
#include "film/face/lane_groups.hpp"
#include "film/large/large_tile.hpp"

#include <algorithm>
#include <array>

namespace pastoso::film::PASTOSO_ISA {
namespace {

/// The flow u = F w that drag leaves of a velocity w along the axis, and du/dw. With s = 1 - 1/x^3 for
/// the wall shear x of Bingham's law (bingham_drag), the whole velocity's du/dw is s / (s + drag); of a
/// velocity that has a part across the axis, the part along it changes by that much only as far as it
/// lengthens the whole.
struct DragAnswer {
    Lanes flow, slope;
};
/// `drag` is lambda dt and `resistance` the wall stress, in yield stresses, of a unit of velocity.
template <bool kYield>
[[gnu::always_inline]] inline DragAnswer drag_answer(Lanes along, Lanes across, Lanes drag,
                                                     Lanes resistance) {
    if constexpr (kYield) {
        const Lanes along2 = along * along, size2 = along2 + across * across + Lanes(1e-30F);
        const Lanes stress = lanes::sqrt(size2) * resistance;
        // What the law comes to where all is arrested, which is most of a stiff paint.
        if (lanes::all(stress <= drag)) return {Lanes(Lanes(0.0F) * along), Lanes(0.0F)};
        const BinghamDrag<Lanes> law = drag_law<true>(drag, stress);
        const Lanes whole = law.tangent_share / (law.tangent_share + drag + Lanes(1e-12F));
        return {Lanes(law.factor * along), Lanes(law.factor + (whole - law.factor) * along2 / size2)};
    }
    const Lanes factor = drag_law<false>(drag, Lanes(0.0F)).factor;
    return {Lanes(factor * along), factor};
}

/// The answer where drag was found with the viscosity at the velocity `last`: the drag of shear-thinning
/// paint grows as the velocity's power `index`, whose tangent there leaves
///     u = last + (F w - last) (1 + drag) / (1 + index drag).
/// A velocity that falls to less than a quarter of F w by that is beyond the tangent's reach.
[[gnu::always_inline]] inline DragAnswer thinned_answer(const DragAnswer& answer, Lanes last, Lanes drag,
                                                        Lanes index) {
    const Lanes one(1.0F);
    const Lanes gain = (one + drag) / (one + index * drag);
    const Lanes flow = last + (answer.flow - last) * gain;
    const auto within = flow * answer.flow > Lanes(0.25F) * answer.flow * answer.flow;
    return {lanes::select(within, flow, answer.flow), answer.slope * lanes::select(within, gain, one)};
}

/// The share of its last answer's slope that a face keeps at least. Newton's method may swing between an
/// arrested and a flowing film, whose slopes are 0 and 1: a slope that rises at once and falls in steps
/// keeps it from overshooting, and the flow found stays the law's.
constexpr float kKeptSlope = 0.25F;

/// The pressure at a row's cell 0 and what that cell holds, and how far from there the next cells are
/// along the faces' axis and across it.
struct PressureRow {
    const float* pressure;
    const std::int32_t* quanta;
    std::ptrdiff_t along, across;

    /// What the pressure within the film leaves of a velocity along the faces that is driven by all
    /// else, mm/s.
    [[gnu::always_inline]] Lanes drive_across(const StepConstants& step, Lanes driven, int x) const {
        const lanes::As<std::int32_t, Lanes> wet(
            static_cast<std::int32_t>(step.wet_mm * static_cast<float>(1.0 / kThicknessQuantum_mm)));
        const Lanes rise = difference_across<Lanes>(
            [&](std::ptrdiff_t n) { return load(pressure + x + n); },
            [&](std::ptrdiff_t n) {
                return lanes::load<lanes::As<std::int32_t, Lanes>>(quanta + x + n) > wet;
            },
            along, across);
        return driven - Lanes(step.dt_s * step.inverse_cell) * rise;
    }
};

/// u = u* - D dt grad p for the faces of a row that are not explicit: the tangent of the drag law at the
/// velocity w that the pressure leaves of the driving one, u* = F - F' (w - driven) and D = F'. The
/// mobility is dt^2 D h / dx^2. With `kCompare`, returns by what part a flux of the row's last answer to
/// that pressure differs from what drag leaves; fluxes of less than 1/50 cell a step count as that much,
/// and a thousandth as nothing. With `kThinning`, drag is that of the faces' velocities.
template <bool kYield, bool kCompare, bool kThinning = false>
float answer_row(const StepConstants& step, const PressureRow& row, int first_x, int y,
                 LargeFaces& faces) {
    constexpr float kNegligibleFlux = 0.02F, kNoError = 0.001F;
    const Lanes zero(0.0F), courant(step.dt_s * step.inverse_cell);
    const Lanes cells(step.dt_s * step.inverse_cell * step.inverse_cell);
    Lanes worst(0.0F);
    // The last group overlaps the one before it, where the row's mobility has been replaced.
    alignas(64) std::array<float, kFaceStride> last_mobility;
    if constexpr (kCompare)
        std::copy_n(&faces.mobility[face_index(-1, y)], kFaceStride, last_mobility.data());
    for_each_lane_group(first_x, grid::kTileSize, [&](int x) {
        const int f = face_index(x, y);
        const Lanes drag = load(&faces.drag[f]);
        const auto implicit = drag >= zero;
        if (!lanes::any(implicit)) return;
        const Lanes push = courant * (load(row.pressure + x + row.along) - load(row.pressure + x));
        const Lanes driven = load(&faces.driven[f]);
        const Lanes depth = load(&faces.depth[f]);
        const Lanes star = load(&faces.star[f]), mobility = load(&faces.mobility[f]);
        const Lanes velocity = driven - push;
        Lanes across(0.0F);
        if constexpr (kYield) across = row.drive_across(step, load(&faces.across[f]), x);
        DragAnswer answer = drag_answer<kYield>(velocity, across, drag, load(&faces.resistance[f]));
        if constexpr (kCompare) {
            const Lanes flux = star * depth * cells - mobility * push * Lanes(1.0F / step.dt_s);
            const Lanes wrong = lanes::abs(Lanes(answer.flow * depth * cells - flux));
            const Lanes passing = lanes::abs(flux) + Lanes(kNegligibleFlux);
            if (lanes::any(implicit && wrong > Lanes(kNoError) * passing))
                worst = lanes::max(worst, lanes::select(implicit, Lanes(wrong / passing), zero));
            // The depth may be another one than the last answer's.
            const Lanes full = courant * courant * depth + Lanes(1e-30F);
            const Lanes last = load(&last_mobility[x + 1]);
            if (lanes::any(last > answer.slope * full)) {
                const Lanes last_slope = lanes::min(Lanes(1.0F), Lanes(last / full));
                answer.slope = lanes::max(answer.slope, Lanes(Lanes(kKeptSlope) * last_slope));
            }
        }
        if constexpr (kThinning)
            answer = thinned_answer(answer, load(&faces.velocity[f]), drag, load(&faces.index[f]));
        if constexpr (!kCompare && !kYield)
            store(&faces.first[f], lanes::select(implicit, answer.flow, load(&faces.first[f])));
        const Lanes tangent = answer.flow - answer.slope * (velocity - driven);
        store(&faces.star[f], lanes::select(implicit, tangent, star));
        store(&faces.mobility[f],
              lanes::select(implicit, Lanes(courant * courant * answer.slope * depth), mobility));
    });
    return lanes::largest(worst);
}

}  // namespace
}  // namespace pastoso::film::PASTOSO_ISA
