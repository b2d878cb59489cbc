// Compiled once per instruction set; see pastoso_add_kernels.
#include "liquid/flow/sample_lanes.hpp"
#include "tank/particle_kernels.hpp"

namespace pastoso::tank::PASTOSO_ISA {
namespace {

using liquid::all;
using liquid::Four;
using liquid::FourInts;
using liquid::greatest;
using liquid::least;
using liquid::load;

// Wide vectors are passed between inlined functions alone, so that it does not matter how they would be.
#pragma GCC diagnostic ignored "-Wpsabi"
using Eight [[gnu::vector_size(32)]] = float;
using EightInts [[gnu::vector_size(32)]] = int;

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

PASTOSO_TANK_INLINE Four size_of(const FacePairs& pairs) {
    return Four{pairs.size_cells[0], pairs.size_cells[1], pairs.size_cells[2], 1.0F};
}

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

/// Two particles, four lanes each.
PASTOSO_TANK_INLINE Eight two_of(Four a, Four b) {
    return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
}
PASTOSO_TANK_INLINE Eight least(Eight a, Eight b) {
    return a < b ? a : b;
}
PASTOSO_TANK_INLINE Eight greatest(Eight a, Eight b) {
    return a > b ? a : b;
}

/// What Stencils are, of two particles.
struct TwoStencils {
    const float* first[2][3];
    Eight weight[4];
    Eight x;
};
PASTOSO_TANK_INLINE TwoStencils stencils(const FacePairs& pairs, Eight at_cells, Eight size_cells) {
    const Eight middle_at =
        least(greatest(at_cells - eight_of(0.5F), eight_of(0.0F)), size_cells - eight_of(1.0F));
    const EightInts face = __builtin_convertvector(at_cells, EightInts),
                    middle = __builtin_convertvector(middle_at, EightInts);
    const Eight f = at_cells - __builtin_convertvector(face, Eight),
                m = middle_at - __builtin_convertvector(middle, Eight);
    // Of x, y and z each the lanes of the three axes.
    const Eight x = __builtin_shuffle(f, m, EightInts{0, 8, 8, 8, 4, 12, 12, 12}),
                y = __builtin_shuffle(f, m, EightInts{9, 1, 9, 9, 13, 5, 13, 13}),
                z = __builtin_shuffle(f, m, EightInts{10, 10, 2, 10, 14, 14, 6, 14});
    const Eight low_y = eight_of(1.0F) - y, low_z = eight_of(1.0F) - z;
    TwoStencils out = {{}, {low_y * low_z, y * low_z, low_y * z, y * z}, x};
    const std::ptrdiff_t to_y = 2 * pairs.stride_y, to_z = 2 * pairs.stride_z;
    for (int n = 0; n < 2; ++n) {
        const int lane = 4 * n;
        const std::ptrdiff_t face_y = face[lane + 1] * to_y, middle_y = middle[lane + 1] * to_y,
                             face_z = face[lane + 2] * to_z, middle_z = middle[lane + 2] * to_z;
        out.first[n][0] = pairs.first[0] + 2 * face[lane] + middle_y + middle_z;
        out.first[n][1] = pairs.first[1] + 2 * middle[lane] + face_y + middle_z;
        out.first[n][2] = pairs.first[2] + 2 * middle[lane] + middle_y + face_z;
    }
    return out;
}

/// Sums of the rows across an axis: both numbers of the first neighbour along x, then of the second.
template <int kAxis>
PASTOSO_TANK_INLINE Eight gather_rows(const TwoStencils& from, std::ptrdiff_t y, std::ptrdiff_t z) {
    const float *a = from.first[0][kAxis], *b = from.first[1][kAxis];
    const auto row = [&](std::ptrdiff_t step, Eight weights) {
        const Eight weight = __builtin_shuffle(
            weights, EightInts{kAxis, kAxis, kAxis, kAxis, 4 + kAxis, 4 + kAxis, 4 + kAxis, 4 + kAxis});
        return two_of(load(a + step), load(b + step)) * weight;
    };
    return (row(0, from.weight[0]) + row(y, from.weight[1])) +
           (row(z, from.weight[2]) + row(y + z, from.weight[3]));
}

struct TwoVelocities {
    Eight now, before;
};
PASTOSO_TANK_INLINE TwoVelocities gather(const FacePairs& pairs, Eight at_cells, Eight size_cells) {
    const TwoStencils from = stencils(pairs, at_cells, size_cells);
    const std::ptrdiff_t to_y = 2 * pairs.stride_y, to_z = 2 * pairs.stride_z;
    const Eight x = gather_rows<0>(from, to_y, to_z), y = gather_rows<1>(from, to_y, to_z),
                z = gather_rows<2>(from, to_y, to_z);
    // Both numbers of x and y, and of z, of either neighbour.
    const Eight low = __builtin_shuffle(x, y, EightInts{0, 1, 8, 9, 4, 5, 12, 13}),
                high = __builtin_shuffle(x, y, EightInts{2, 3, 10, 11, 6, 7, 14, 15}),
                high_z = __builtin_shuffle(z, EightInts{2, 3, 2, 3, 6, 7, 6, 7}),
                share = __builtin_shuffle(from.x, EightInts{0, 0, 1, 1, 4, 4, 5, 5}),
                share_z = __builtin_shuffle(from.x, EightInts{2, 2, 2, 2, 6, 6, 6, 6});
    const Eight xy = low * (eight_of(1.0F) - share) + high * share,
                zz = z * (eight_of(1.0F) - share_z) + high_z * share_z;
    return {__builtin_shuffle(xy, zz, EightInts{0, 2, 8, 8, 4, 6, 12, 12}),
            __builtin_shuffle(xy, zz, EightInts{1, 3, 9, 9, 5, 7, 13, 13})};
}

PASTOSO_TANK_INLINE void store_two(float* a, float* b, Eight values) {
    __builtin_memcpy(b, reinterpret_cast<const float*>(&values) + 4, sizeof(Four));
    __builtin_memcpy(a, &values, sizeof(Four));
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
    const Eight per_cell = eight_of(1.0F / pairs.cell_m), cell = eight_of(pairs.cell_m),
                size = two_of(size_of(pairs), size_of(pairs)), way = eight_of(how.dt_s / pairs.cell_m),
                half_way = eight_of(0.5F) * way, share = eight_of(how.share),
                low = eight_of(how.gap_cells), high = size - low;
    Eight fastest = eight_of(0.0F);
    float* const first = static_cast<float*>(particles);
    for (std::size_t p = 0; p < count; p += 2) {
        // A last one alone is its own neighbour: both lanes do the same.
        float *a = first + p * kParticleFloats, *b = p + 1 < count ? a + kParticleFloats : a;
        const Eight milk_first = two_of(load(a + kMilk), load(b + kMilk));
        const Eight own = __builtin_shuffle(milk_first, EightInts{1, 2, 3, 3, 5, 6, 7, 7});
        const Eight from = least(two_of(load(a), load(b)) * per_cell, size);
        const TwoVelocities here = gather(pairs, from, size);
        const Eight velocity = here.now + share * (own - here.before);
        const Eight middle = least(greatest(from + here.now * half_way, low), high);
        const Eight to = least(greatest(from + gather(pairs, middle, size).now * way, low), high) * cell;
        fastest = greatest(fastest, greatest(velocity, -velocity));
        store_two(a, b, __builtin_shuffle(to, milk_first, EightInts{0, 1, 2, 8, 4, 5, 6, 12}));
        store_two(a + kMilk, b + kMilk,
                  __builtin_shuffle(velocity, milk_first, EightInts{8, 0, 1, 2, 12, 4, 5, 6}));
    }
    float most = 0.0F;
    for (int lane = 0; lane < 8; ++lane)
        if (lane % 4 != 3 && fastest[lane] > most) most = fastest[lane];
    return most;
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
            const Eight rest = one - way2 * per_reach2, share = rest > none ? rest : none,
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

PASTOSO_REGISTER_KERNELS(pastoso::tank, ParticleKernels, scatter, follow, sum_near)
