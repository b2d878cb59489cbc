// From the pressure of the new surface to whole quanta of flux. Compiled once per instruction set; see
// pastoso_add_kernels.
#include "film/face/lane_groups.hpp"
#include "film/large/large_kernels.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>

namespace pastoso::film::PASTOSO_ISA {
namespace {

using grid::kTileSize;
using Ints = lanes::As<std::int32_t, Lanes>;

/// What moves the paint. Where drag rules that is between what the new pressure makes and what the last
/// one would, which is second order in time where both are alike: the weight of the last one's is half
/// their ratio, since the new one's lags the more the faster the flow fades. With a yield stress, and at
/// faces that do not wait for the new pressure, a third of the old velocity counts where they differ by
/// less than a factor of two: a mean of pressures would make paint creep that is held.
template <bool kYield>
[[gnu::always_inline]] inline Lanes carrying_velocity(const StepConstants& step, const LargeFaces& faces,
                                                      int f, Lanes now) {
    const Lanes full(0.5F * step.dt_s * step.dt_s * step.inverse_cell * step.inverse_cell);
    const Lanes first = load(&faces.first[f]), zero(0.0F);
    const Lanes size = lanes::abs(now), first_size = lanes::abs(first);
    const Lanes ratio = lanes::min(size, first_size) / (lanes::max(size, first_size) + Lanes(1e-30F));
    const Lanes steady = lanes::select(ratio > Lanes(0.5F), Lanes(1.0F / 3.0F), zero);
    Lanes weight = steady;
    if constexpr (!kYield)
        weight = lanes::select(load(&faces.drag[f]) < zero, steady, Lanes(Lanes(0.5F) * ratio));
    const auto dragged = load(&faces.mobility[f]) < full * load(&faces.depth[f]);
    const auto blends = dragged && first * now > zero;
    return now + lanes::select(blends, Lanes(weight * (first - now)), zero);
}

/// u = u* - (dt/dx) D (p_right - p_left), with dt D h_f / dx = m dx / dt. Paint that a yield stress
/// holds does not flow against what drives it, as the linear answer may. Returns the largest mobility.
template <bool kYield>
Lanes velocity_row(const StepConstants& step, const float* pressure, bool carrying, int along,
                   int first_x, int y, LargeFaces& faces) {
    const Lanes cell_per_step(step.cell_mm / step.dt_s), zero(0.0F);
    const Lanes dt_per_cell(step.dt_s * step.inverse_cell);
    Lanes largest_mobility(0.0F);
    for_each_lane_group(first_x, kTileSize, [&](int x) {
        const int f = face_index(x, y), i = window_index(x, y);
        const Lanes passing = load(&faces.depth[f]), mobility = load(&faces.mobility[f]);
        const Lanes rise = load(pressure + i + along) - load(pressure + i);
        const Lanes pushed = mobility * cell_per_step * rise / passing;
        largest_mobility = lanes::max(largest_mobility, mobility);
        Lanes now = load(&faces.star[f]) - lanes::select(passing > zero, pushed, zero);
        if constexpr (kYield) {
            const Lanes drive = load(&faces.driven[f]) - dt_per_cell * rise;
            const auto held = load(&faces.resistance[f]) > zero && load(&faces.drag[f]) >= zero;
            now = lanes::select(held && now * drive < zero, zero, now);
        }
        store(&faces.velocity[f], carrying ? carrying_velocity<kYield>(step, faces, f, now) : now);
    });
    return largest_mobility;
}

struct Outflow {
    const StepConstants& step;
    const LargeTile& tile;

    Lanes x(int f) const { return flow(tile.x, f); }
    Lanes y(int f) const { return flow(tile.y, f); }
    /// Thickness that crosses a face in the step, mm.
    [[gnu::always_inline]] Lanes flow(const LargeFaces& faces, int f) const {
        return Lanes(step.dt_s * step.inverse_cell) * load(&faces.velocity[f]) * load(&faces.depth[f]);
    }
};

[[gnu::always_inline]] inline Lanes rise(Lanes value) {
    return lanes::max(value, Lanes(0.0F));
}
[[gnu::always_inline]] inline Lanes fall(Lanes value) {
    return lanes::max(Lanes(-value), Lanes(0.0F));
}

}  // namespace

void compute_large_velocities(const StepConstants& step, bool carrying, const LargeScratch& scratch,
                              LargeTile& tile) {
    const float* pressure = scratch.pressure.data();
    const auto compute_row = step.has_yield() || step.varied ? velocity_row<true> : velocity_row<false>;
    Lanes largest(0.0F);
    for (int y = -1; y < kTileSize; ++y) {
        largest =
            lanes::max(largest, compute_row(step, pressure, carrying, kWindowStride, 0, y, tile.y));
        if (y >= 0)
            largest = lanes::max(largest, compute_row(step, pressure, carrying, 1, -1, y, tile.x));
    }
    tile.largest_mobility = lanes::largest(largest);
}

namespace {

/// A quarter of what cells can still take, mm: a hair less, so that rounding cannot overfill them.
Lanes quarter_capacity(Ints quanta) {
    const Ints capacity_left = lanes::max(Ints(Ints(kMaxThickness_quanta - 4) - quanta), Ints(0));
    return lanes::convert<float>(capacity_left) * Lanes(0.2499F * static_cast<float>(kThicknessQuantum_mm));
}

/// What is cut already is left alone, whatever rounding says, so that a face comes out the same however
/// often it is visited.
int cut_row(const StepConstants& step, const LargeScratch& scratch, int along, int first_x, int y,
            LargeFaces& faces) {
    int count = 0;
    for_each_lane_group(first_x, kTileSize, [&](int x) {
        const int f = face_index(x, y), i = window_index(x, y);
        const Ints left = lanes::load<Ints>(&scratch.thickness[i]);
        const Ints right = lanes::load<Ints>(&scratch.thickness[i + along]);
        const Lanes velocity = load(&faces.velocity[f]);
        const Lanes per_velocity = Lanes(step.dt_s * step.inverse_cell) * load(&faces.depth[f]);
        const Lanes crossing = velocity * per_velocity;
        const Lanes fitting = lanes::clamp(crossing, Lanes(-quarter_capacity(left)), quarter_capacity(right));
        const auto crowded =
            lanes::convert<float>(lanes::max(left, right)) > Lanes(static_cast<float>(kCrowded_quanta));
        const auto cut = crowded && lanes::abs(crossing) > Lanes(1.00001F) * lanes::abs(fitting);
        store(&faces.velocity[f], lanes::select(cut, Lanes(fitting / per_velocity), velocity));
        count += lanes::count(cut);
    });
    return count;
}

}  // namespace

int cut_to_capacity(const StepConstants& step, const LargeScratch& scratch, LargeTile& tile) {
    int count = 0;
    for (int y = -1; y < kTileSize; ++y) {
        count += cut_row(step, scratch, kWindowStride, 0, y, tile.y);
        if (y >= 0) count += cut_row(step, scratch, 1, -1, y, tile.x);
    }
    return count;
}

Shortage share_outflow(const StepConstants& step, int columns, int rows, const std::int32_t* thickness,
                       const LargeScratch& scratch, LargeTile& tile, CellArray& share) {
    // A hair less than a cell holds and receives, so that the rounding at its four faces cannot overdraw
    // it.
    constexpr float kQuantum = static_cast<float>(kThicknessQuantum_mm);
    const Lanes usable(0.999F * kQuantum), rounding(8.0F * kQuantum), one(1.0F), tiny(1e-30F);
    const Outflow flow{step, tile};
    const auto lane_number = lanes::counting<Lanes>();
    const Lanes last_column(static_cast<float>(columns));
    Shortage shortage;
    int limited = 0;
    const Lanes thick(0.05F * step.cell_mm);
    for (int y = 0; y < kTileSize; ++y)
        for (int x = 0; x < kTileSize; x += kLanes) {
            const int f = face_index(x, y), i = window_index(x, y), cell = y * kTileSize + x;
            const Lanes right = flow.x(f), left = flow.x(f - 1);
            const Lanes below = flow.y(f), above = flow.y(f - kFaceStride);
            const float* granted = &scratch.share[i];
            const Lanes in = (fall(right) * load(granted + 1) + rise(left) * load(granted - 1)) +
                             (fall(below) * load(granted + kWindowStride) +
                              rise(above) * load(granted - kWindowStride));
            const Lanes out = (rise(right) + fall(left)) + (rise(below) + fall(above));
            const Ints quanta = lanes::load<Ints>(thickness + cell);
            const Lanes held = lanes::convert<float>(quanta) * usable;
            const Lanes supply = rise(held + Lanes(0.999F) * in - rounding);
            const Lanes part = lanes::min(one, Lanes((supply + tiny) / (out + tiny)));
            store(&share[cell], part);
            store(&tile.supply[cell], Lanes((rise(held - rounding) + tiny) / (out * part + tiny)));
            const auto cut =
                part < Lanes(0.9F) && lane_number + Lanes(static_cast<float>(x)) < last_column;
            limited += lanes::count(part < one);
            if (y >= rows) continue;
            shortage.short_cells += lanes::count(cut);
            shortage.thick_short_cells += lanes::count(cut && held > thick);
        }
    shortage.is_any = limited > 0;
    return shortage;
}

namespace {

void slow_row(const LargeScratch& large, int along, int first_x, int y, LargeFaces& faces) {
    for (int x = first_x; x < kTileSize; ++x) {
        const int f = face_index(x, y), i = window_index(x, y);
        const float share = faces.velocity[f] > 0.0F ? large.share[i] : large.share[i + along];
        faces.first[f] *= share;
        faces.star[f] *= share;
        faces.mobility[f] *= share;
    }
}

}  // namespace

void slow_limited_faces(const StepConstants& step, const LargeScratch& large, LargeTile& tile) {
    for (int y = -1; y < kTileSize; ++y) {
        slow_row(large, kWindowStride, 0, y, tile.y);
        if (y >= 0) slow_row(large, 1, -1, y, tile.x);
    }
    compute_source(step, tile);
}

namespace {

/// How many faces have which speed, in steps of half an octave.
class SpeedCounts {
  public:
    void add(std::span<const float> speeds) {
        for (const float speed : speeds)
            ++counts_[std::bit_cast<std::uint32_t>(speed) >> kDropped];
    }
    /// A bound for all but `faces` of the speeds.
    float bound_for_all_but(int faces) const {
        int step = kSteps - 1;
        for (int faster = counts_[step]; step > 0 && faster <= faces; faster += counts_[step])
            --step;
        return std::bit_cast<float>(static_cast<std::uint32_t>(step + 1) << kDropped);
    }

  private:
    /// Of a float's bits: all but the exponent and one of the fraction.
    static constexpr int kDropped = 22, kSteps = 512;
    std::array<int, kSteps> counts_{};
};

void flux_row(const StepConstants& step, const LargeScratch& large, int along, int first_x, int y,
              const LargeFaces& faces, FaceArray<float>& velocity, FaceArray<std::int32_t>& flux,
              FlowExtremes& extremes, SpeedCounts& counts) {
    const Lanes scale(step.dt_s * step.inverse_cell * static_cast<float>(1.0 / kThicknessQuantum_mm));
    const Lanes zero(0.0F);
    Lanes speed(0.0F), thickness(0.0F);
    std::array<float, kTileSize + 1> speeds;
    // Of a wedge of the advancing angle that fills a cell: next to nothing moves in one that the film
    // has just entered.
    const Lanes wedges(step.has_contact_angle() ? 2.0F * step.inverse_cell / step.tan_advancing : 1e30F);
    for_each_lane_group(first_x, kTileSize, [&](int x) {
        const int f = face_index(x, y), i = window_index(x, y);
        const Lanes here = load(&faces.velocity[f]);
        const Lanes share =
            lanes::select(here > zero, load(&large.share[i]), load(&large.share[i + along]));
        // Nothing flows where no number came out.
        const Lanes granted = lanes::select(lanes::abs(here) < Lanes(1e30F), Lanes(here * share), zero);
        const Lanes size = lanes::abs(granted), depth = load(&faces.depth[f]);
        const Lanes exact = granted * depth * scale;
        const Lanes nearest = exact + lanes::copysign(Lanes(0.5F), exact);
        lanes::store(&flux[f], lanes::convert<std::int32_t>(nearest));
        store(&velocity[f], granted);
        const auto at_end = load(&faces.drag[f]) < zero;
        const Lanes filling = lanes::min(Lanes(1.0F), Lanes(depth * wedges));
        const Lanes carrying = lanes::select(at_end, Lanes(size * filling), size);
        speed = lanes::max(speed, carrying);
        store(&speeds[x - first_x], carrying);
        thickness = lanes::max(thickness, lanes::select(granted == zero, zero, depth));
    });
    counts.add(std::span(speeds).first(kTileSize - first_x));
    extremes.speed_mm_s = lanes::max(extremes.speed_mm_s, lanes::largest(speed));
    extremes.thickness_mm = lanes::max(extremes.thickness_mm, lanes::largest(thickness));
}

}  // namespace

FlowExtremes compute_large_fluxes(const StepConstants& step, const LargeScratch& large,
                                  const LargeTile& tile, TileScratch& scratch) {
    FlowExtremes extremes;
    SpeedCounts counts;
    extremes.mobility = tile.largest_mobility * step.cell_mm * step.cell_mm / step.dt_s;
    for (int y = -1; y < kTileSize; ++y) {
        flux_row(step, large, kWindowStride, 0, y, tile.y, scratch.velocity_y, scratch.flux_y, extremes,
                 counts);
        if (y >= 0)
            flux_row(step, large, 1, -1, y, tile.x, scratch.velocity_x, scratch.flux_x, extremes,
                     counts);
    }
    const auto unseen_faces =
        static_cast<int>(2.0 * kUnseenArea_mm2 * step.inverse_cell * step.inverse_cell);
    extremes.seen_speed_mm_s = std::min(extremes.speed_mm_s, counts.bound_for_all_but(unseen_faces));
    return extremes;
}

}  // namespace pastoso::film::PASTOSO_ISA
