// Compiled once per instruction set; see pastoso_add_kernels.
#include "liquid/sample_lanes.hpp"
#include "tank/particle_kernels.hpp"

namespace pastoso::tank::PASTOSO_ISA {
namespace {

using liquid::all;
using liquid::Four;
using liquid::FourInts;
using liquid::greatest;
using liquid::least;
using liquid::load;

#define PASTOSO_TANK_INLINE [[maybe_unused, gnu::always_inline]] static inline

/// A particle as tank/particle.hpp lays it out: place, milk, velocity.
constexpr std::size_t kParticleFloats = 7;
constexpr std::size_t kMilk = 3, kVelocity = 4;

PASTOSO_TANK_INLINE void store(float* to, Four values) {
    __builtin_memcpy(to, &values, sizeof(values));
}

/// Where a point lies among the faces across each axis: along the axis itself between faces, along the
/// others between cells' middles. At the walls nothing rubs: between the outermost middles and the wall
/// nothing changes.
struct FacePlaces {
    FourInts face, middle;
    Four face_share, middle_share;
};
PASTOSO_TANK_INLINE FacePlaces face_places(Four at_cells, Four size_cells) {
    const Four middle = least(greatest(at_cells - all(0.5F), all(0.0F)), size_cells - all(1.0F));
    const FourInts whole = __builtin_convertvector(at_cells, FourInts),
                   whole_middle = __builtin_convertvector(middle, FourInts);
    return {whole, whole_middle, at_cells - __builtin_convertvector(whole, Four),
            middle - __builtin_convertvector(whole_middle, Four)};
}

/// The eight faces across each axis around a point: two neighbours along x in each of four rows.
struct Stencils {
    float* first[3];      ///< the pair of the lowest face
    Four weight[4];       ///< of the rows, with a lane for each axis
    Four x;               ///< share of the second neighbour along x, likewise
    std::ptrdiff_t y, z;  ///< to the next row and slice
};
PASTOSO_TANK_INLINE Stencils stencils(const FacePairs& pairs, const FacePlaces& at) {
    const std::ptrdiff_t to_y = 2 * pairs.stride_y, to_z = 2 * pairs.stride_z;
    const std::ptrdiff_t face_y = at.face[1] * to_y, middle_y = at.middle[1] * to_y,
                         face_z = at.face[2] * to_z, middle_z = at.middle[2] * to_z;
    const Four f = at.face_share, m = at.middle_share;
    const Four x = {f[0], m[0], m[0], 0.0F}, y = {m[1], f[1], m[1], 0.0F}, z = {m[2], m[2], f[2], 0.0F};
    const Four low_y = all(1.0F) - y, low_z = all(1.0F) - z;
    return {{pairs.first[0] + 2 * at.face[0] + middle_y + middle_z,
             pairs.first[1] + 2 * at.middle[0] + face_y + middle_z,
             pairs.first[2] + 2 * at.middle[0] + middle_y + face_z},
            {low_y * low_z, y * low_z, low_y * z, y * z},
            x,
            to_y,
            to_z};
}

template <int kAxis>
PASTOSO_TANK_INLINE void scatter_axis(const Stencils& to, float value) {
    const float high = to.x[kAxis], low = 1.0F - high;
    const Four pair = {low * value, low, high * value, high};
    for (int row = 0; row < 4; ++row) {
        float* at = to.first[kAxis] + (row & 1) * to.y + (row >> 1) * to.z;
        store(at, load(at) + pair * all(to.weight[row][kAxis]));
    }
}

/// Sums of the rows: both numbers of the first neighbour along x, then both of the second.
template <int kAxis>
PASTOSO_TANK_INLINE Four gather_rows(const Stencils& from) {
    const float* first = from.first[kAxis];
    return (load(first) * all(from.weight[0][kAxis]) +
            load(first + from.y) * all(from.weight[1][kAxis])) +
           (load(first + from.z) * all(from.weight[2][kAxis]) +
            load(first + from.y + from.z) * all(from.weight[3][kAxis]));
}

struct Velocities {
    Four now, before;
};
PASTOSO_TANK_INLINE Velocities gather(const FacePairs& pairs, Four at_cells, Four size_cells) {
    const Stencils from = stencils(pairs, face_places(at_cells, size_cells));
    const Four x = gather_rows<0>(from), y = gather_rows<1>(from), z = gather_rows<2>(from);
    // Both numbers of x and y, and of z, of either neighbour.
    const Four low = __builtin_shuffle(x, y, FourInts{0, 1, 4, 5}),
               high = __builtin_shuffle(x, y, FourInts{2, 3, 6, 7}),
               high_z = __builtin_shuffle(z, FourInts{2, 3, 2, 3}),
               share = __builtin_shuffle(from.x, FourInts{0, 0, 1, 1}),
               share_z = __builtin_shuffle(from.x, FourInts{2, 2, 2, 2});
    const Four xy = low * (all(1.0F) - share) + high * share,
               zz = z * (all(1.0F) - share_z) + high_z * share_z;
    return {__builtin_shuffle(xy, zz, FourInts{0, 2, 4, 4}),
            __builtin_shuffle(xy, zz, FourInts{1, 3, 5, 5})};
}

PASTOSO_TANK_INLINE Four size_of(const FacePairs& pairs) {
    return Four{pairs.size_cells[0], pairs.size_cells[1], pairs.size_cells[2], 1.0F};
}

// Wide vectors are passed between inlined functions alone, so that it does not matter how they would be.
#pragma GCC diagnostic ignored "-Wpsabi"
using Eight [[gnu::vector_size(32)]] = float;
using EightInts [[gnu::vector_size(32)]] = int;

PASTOSO_TANK_INLINE Eight load_eight(const float* values) {
    Eight eight;
    __builtin_memcpy(&eight, values, sizeof(eight));
    return eight;
}
PASTOSO_TANK_INLINE Eight eight_of(float value) {
    return Eight{value, value, value, value, value, value, value, value};
}
PASTOSO_TANK_INLINE float sum_of(Eight v) {
    return ((v[0] + v[4]) + (v[1] + v[5])) + ((v[2] + v[6]) + (v[3] + v[7]));
}

}  // namespace

void scatter(const FacePairs& pairs, const void* particles, std::size_t count) {
    const Four per_cell = all(1.0F / pairs.cell_m), size = size_of(pairs);
    const float* particle = static_cast<const float*>(particles);
    for (std::size_t p = 0; p < count; ++p, particle += kParticleFloats) {
        const Stencils to = stencils(pairs, face_places(load(particle) * per_cell, size));
        scatter_axis<0>(to, particle[kVelocity]);
        scatter_axis<1>(to, particle[kVelocity + 1]);
        scatter_axis<2>(to, particle[kVelocity + 2]);
    }
}

float follow(const FacePairs& pairs, const Following& how, void* particles, std::size_t count) {
    const Four per_cell = all(1.0F / pairs.cell_m), cell = all(pairs.cell_m), size = size_of(pairs),
               way = all(how.dt_s / pairs.cell_m), half_way = all(0.5F) * way, share = all(how.share),
               low = all(how.gap_cells), high = size - low;
    Four fastest = all(0.0F);
    float* particle = static_cast<float*>(particles);
    for (std::size_t p = 0; p < count; ++p, particle += kParticleFloats) {
        const Four milk_first = load(particle + kMilk);
        const Four own = __builtin_shuffle(milk_first, FourInts{1, 2, 3, 3});
        const Four from = least(load(particle) * per_cell, size);
        const Velocities here = gather(pairs, from, size);
        const Four velocity = here.now + share * (own - here.before);
        const Four middle = least(greatest(from + here.now * half_way, low), high);
        const Four to = least(greatest(from + gather(pairs, middle, size).now * way, low), high) * cell;
        fastest = greatest(fastest, greatest(velocity, -velocity));
        store(particle, __builtin_shuffle(to, milk_first, FourInts{0, 1, 2, 4}));
        store(particle + kMilk, __builtin_shuffle(velocity, milk_first, FourInts{4, 0, 1, 2}));
    }
    const float x_or_y = fastest[0] > fastest[1] ? fastest[0] : fastest[1];
    return x_or_y > fastest[2] ? x_or_y : fastest[2];
}

NearSums sum_near(const PositionRun* runs, int count, float reach2) {
    const EightInts lanes = {0, 1, 2, 3, 4, 5, 6, 7};
    const Eight per_reach2 = eight_of(1.0F / reach2), one = eight_of(1.0F), none = eight_of(0.0F),
                far2 = eight_of(reach2);
    Eight sum_x = none, sum_y = none, sum_z = none, weights = none, nearest2 = far2;
    for (const PositionRun* run = runs; run < runs + count; ++run) {
        const Eight sign_x = eight_of(run->sign[0]), sign_y = eight_of(run->sign[1]),
                    sign_z = eight_of(run->sign[2]), offset_x = eight_of(run->offset[0]),
                    offset_y = eight_of(run->offset[1]), offset_z = eight_of(run->offset[2]);
        for (int p = 0; p < run->count; p += 8) {
            const int left = run->count - p;
            const EightInts is_one = lanes < EightInts{left, left, left, left, left, left, left, left};
            const Eight x = load_eight(run->x + p) * sign_x + offset_x,
                        y = load_eight(run->y + p) * sign_y + offset_y,
                        z = load_eight(run->z + p) * sign_z + offset_z;
            const Eight way2 = is_one ? (x * x + y * y) + z * z : far2;
            const Eight room = one - way2 * per_reach2, share = room > none ? room : none,
                        weight = share * share * share;
            sum_x += weight * x;
            sum_y += weight * y;
            sum_z += weight * z;
            weights += weight;
            nearest2 = way2 < nearest2 ? way2 : nearest2;
        }
    }
    float least2 = reach2;
    for (int lane = 0; lane < 8; ++lane)
        least2 = nearest2[lane] < least2 ? nearest2[lane] : least2;
    return {{sum_of(sum_x), sum_of(sum_y), sum_of(sum_z)}, sum_of(weights), least2};
}

}  // namespace pastoso::tank::PASTOSO_ISA
