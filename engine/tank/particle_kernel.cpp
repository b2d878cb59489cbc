// Compiled once per instruction set; see pastoso_add_kernels.
#include "liquid/flow/sample_lanes.hpp"
#include "tank/particle_kernels.hpp"

namespace pastoso::tank::PASTOSO_ISA {
namespace {

namespace lanes = core::lanes;
using liquid::Four;
using FourInts = lanes::As<std::int32_t, Four>;
using Eight = lanes::Lanes<float, 8>;
using EightInts = lanes::As<std::int32_t, Eight>;

/// A particle as tank/particle.hpp lays it out: place, milk, velocity.
constexpr std::size_t kParticleFloats = 7;
constexpr std::size_t kMilk = 3, kVelocity = 4;

/// Where a point lies among the faces across each axis: along the axis itself between faces, along the
/// others between cells' middles. At the walls nothing rubs: between the outermost middles and the wall
/// nothing changes.
struct FacePlaces {
    FourInts face, middle;
    Four face_share, middle_share;
};
PASTOSO_LANE_FUNCTION FacePlaces face_places(Four at_cells, Four size_cells) {
    const Four middle =
        lanes::min(lanes::max(at_cells - Four(0.5F), Four(0.0F)), size_cells - Four(1.0F));
    const FourInts whole = lanes::convert<std::int32_t>(at_cells),
                   whole_middle = lanes::convert<std::int32_t>(middle);
    return {whole, whole_middle, at_cells - lanes::convert<float>(whole),
            middle - lanes::convert<float>(whole_middle)};
}

/// The eight faces across each axis around a point: two neighbours along x in each of four rows.
struct Stencils {
    float* first[3];      ///< the pair of the lowest face
    Four weight[4];       ///< of the rows, with a lane for each axis
    Four x;               ///< share of the second neighbour along x, likewise
    std::ptrdiff_t y, z;  ///< to the next row and slice
};
PASTOSO_LANE_FUNCTION Stencils stencils(const FacePairs& pairs, const FacePlaces& at) {
    const std::ptrdiff_t to_y = 2 * pairs.stride_y, to_z = 2 * pairs.stride_z;
    const std::ptrdiff_t face_y = at.face[1] * to_y, middle_y = at.middle[1] * to_y,
                         face_z = at.face[2] * to_z, middle_z = at.middle[2] * to_z;
    const Four f = at.face_share, m = at.middle_share;
    const Four x = {f[0], m[0], m[0], 0.0F}, y = {m[1], f[1], m[1], 0.0F}, z = {m[2], m[2], f[2], 0.0F};
    const Four low_y = Four(1.0F) - y, low_z = Four(1.0F) - z;
    return {{pairs.first[0] + 2 * at.face[0] + middle_y + middle_z,
             pairs.first[1] + 2 * at.middle[0] + face_y + middle_z,
             pairs.first[2] + 2 * at.middle[0] + middle_y + face_z},
            {low_y * low_z, y * low_z, low_y * z, y * z},
            x,
            to_y,
            to_z};
}

template <int kAxis>
PASTOSO_LANE_FUNCTION void scatter_axis(const Stencils& to, float value) {
    const float high = to.x[kAxis], low = 1.0F - high;
    const Four pair = {low * value, low, high * value, high};
    for (int row = 0; row < 4; ++row) {
        float* at = to.first[kAxis] + (row & 1) * to.y + (row >> 1) * to.z;
        lanes::store(at, lanes::load<Four>(at) + pair * Four(to.weight[row][kAxis]));
    }
}

PASTOSO_LANE_FUNCTION Four size_of(const FacePairs& pairs) {
    return Four{pairs.size_cells[0], pairs.size_cells[1], pairs.size_cells[2], 1.0F};
}

PASTOSO_LANE_FUNCTION float sum_of(Eight v) {
    return ((v[0] + v[4]) + (v[1] + v[5])) + ((v[2] + v[6]) + (v[3] + v[7]));
}

/// Two particles, four lanes each.
PASTOSO_LANE_FUNCTION Eight two_of(Four a, Four b) {
    return lanes::permuted<0, 1, 2, 3, 4, 5, 6, 7>(a, b);
}
/// What Stencils are, of two particles.
struct TwoStencils {
    const float* first[2][3];
    Eight weight[4];
    Eight x;
};
PASTOSO_LANE_FUNCTION TwoStencils stencils(const FacePairs& pairs, Eight at_cells, Eight size_cells) {
    const Eight middle_at =
        lanes::min(lanes::max(at_cells - Eight(0.5F), Eight(0.0F)), size_cells - Eight(1.0F));
    const EightInts face = lanes::convert<std::int32_t>(at_cells),
                    middle = lanes::convert<std::int32_t>(middle_at);
    const Eight f = at_cells - lanes::convert<float>(face),
                m = middle_at - lanes::convert<float>(middle);
    // Of x, y and z each the lanes of the three axes.
    const Eight x = lanes::permuted<0, 8, 8, 8, 4, 12, 12, 12>(f, m),
                y = lanes::permuted<9, 1, 9, 9, 13, 5, 13, 13>(f, m),
                z = lanes::permuted<10, 10, 2, 10, 14, 14, 6, 14>(f, m);
    const Eight low_y = Eight(1.0F) - y, low_z = Eight(1.0F) - z;
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
PASTOSO_LANE_FUNCTION Eight gather_rows(const TwoStencils& from, std::ptrdiff_t y, std::ptrdiff_t z) {
    const float *a = from.first[0][kAxis], *b = from.first[1][kAxis];
    const auto row = [&](std::ptrdiff_t step, Eight weights) {
        const Eight weight =
            lanes::permuted<kAxis, kAxis, kAxis, kAxis, 4 + kAxis, 4 + kAxis, 4 + kAxis, 4 + kAxis>(
                weights);
        return two_of(lanes::load<Four>(a + step), lanes::load<Four>(b + step)) * weight;
    };
    return (row(0, from.weight[0]) + row(y, from.weight[1])) +
           (row(z, from.weight[2]) + row(y + z, from.weight[3]));
}

struct TwoVelocities {
    Eight now, before;
};
PASTOSO_LANE_FUNCTION TwoVelocities gather(const FacePairs& pairs, Eight at_cells, Eight size_cells) {
    const TwoStencils from = stencils(pairs, at_cells, size_cells);
    const std::ptrdiff_t to_y = 2 * pairs.stride_y, to_z = 2 * pairs.stride_z;
    const Eight x = gather_rows<0>(from, to_y, to_z), y = gather_rows<1>(from, to_y, to_z),
                z = gather_rows<2>(from, to_y, to_z);
    // Both numbers of x and y, and of z, of either neighbour.
    const Eight low = lanes::permuted<0, 1, 8, 9, 4, 5, 12, 13>(x, y),
                high = lanes::permuted<2, 3, 10, 11, 6, 7, 14, 15>(x, y),
                high_z = lanes::permuted<2, 3, 2, 3, 6, 7, 6, 7>(z),
                share = lanes::permuted<0, 0, 1, 1, 4, 4, 5, 5>(from.x),
                share_z = lanes::permuted<2, 2, 2, 2, 6, 6, 6, 6>(from.x);
    const Eight xy = low * (Eight(1.0F) - share) + high * share,
                zz = z * (Eight(1.0F) - share_z) + high_z * share_z;
    return {lanes::permuted<0, 2, 8, 8, 4, 6, 12, 12>(xy, zz),
            lanes::permuted<1, 3, 9, 9, 5, 7, 13, 13>(xy, zz)};
}

PASTOSO_LANE_FUNCTION void store_two(float* a, float* b, Eight values) {
    lanes::store(b, lanes::permuted<4, 5, 6, 7>(values));
    lanes::store(a, lanes::permuted<0, 1, 2, 3>(values));
}

}  // namespace

void scatter(const FacePairs& pairs, const void* particles, std::size_t count) {
    const Four per_cell = Four(1.0F / pairs.cell_m), size = size_of(pairs);
    const float* particle = static_cast<const float*>(particles);
    for (std::size_t p = 0; p < count; ++p, particle += kParticleFloats) {
        const Stencils to = stencils(pairs, face_places(lanes::load<Four>(particle) * per_cell, size));
        scatter_axis<0>(to, particle[kVelocity]);
        scatter_axis<1>(to, particle[kVelocity + 1]);
        scatter_axis<2>(to, particle[kVelocity + 2]);
    }
}

float follow(const FacePairs& pairs, const Following& how, void* particles, std::size_t count) {
    const Eight per_cell = Eight(1.0F / pairs.cell_m), cell = Eight(pairs.cell_m),
                size = two_of(size_of(pairs), size_of(pairs)), way = Eight(how.dt_s / pairs.cell_m),
                half_way = Eight(0.5F) * way, share = Eight(how.share), low = Eight(how.gap_cells),
                high = size - low;
    Eight fastest = Eight(0.0F);
    float* const first = static_cast<float*>(particles);
    for (std::size_t p = 0; p < count; p += 2) {
        // A last one alone is its own neighbour: both lanes do the same.
        float *a = first + p * kParticleFloats, *b = p + 1 < count ? a + kParticleFloats : a;
        const Eight milk_first = two_of(lanes::load<Four>(a + kMilk), lanes::load<Four>(b + kMilk));
        const Eight own = lanes::permuted<1, 2, 3, 3, 5, 6, 7, 7>(milk_first);
        const Eight from =
            lanes::min(two_of(lanes::load<Four>(a), lanes::load<Four>(b)) * per_cell, size);
        const TwoVelocities here = gather(pairs, from, size);
        const Eight velocity = here.now + share * (own - here.before);
        const Eight middle = lanes::min(lanes::max(from + here.now * half_way, low), high);
        const Eight to =
            lanes::min(lanes::max(from + gather(pairs, middle, size).now * way, low), high) * cell;
        fastest = lanes::max(fastest, lanes::max(velocity, -velocity));
        store_two(a, b, lanes::permuted<0, 1, 2, 8, 4, 5, 6, 12>(to, milk_first));
        store_two(a + kMilk, b + kMilk, lanes::permuted<8, 0, 1, 2, 12, 4, 5, 6>(velocity, milk_first));
    }
    float most = 0.0F;
    for (int lane = 0; lane < 8; ++lane)
        if (lane % 4 != 3 && fastest[lane] > most) most = fastest[lane];
    return most;
}

NearSums sum_near(const PositionRun* runs, int count, float reach2) {
    const auto number = lanes::counting<EightInts>();
    const Eight per_reach2 = Eight(1.0F / reach2), one = Eight(1.0F), none = Eight(0.0F),
                far2 = Eight(reach2);
    Eight sum_x = none, sum_y = none, sum_z = none, weights = none, nearest2 = far2;
    for (const PositionRun* run = runs; run < runs + count; ++run) {
        const Eight sign_x = Eight(run->sign[0]), sign_y = Eight(run->sign[1]),
                    sign_z = Eight(run->sign[2]), offset_x = Eight(run->offset[0]),
                    offset_y = Eight(run->offset[1]), offset_z = Eight(run->offset[2]);
        for (int p = 0; p < run->count; p += 8) {
            const int left = run->count - p;
            const auto is_one = number < EightInts(left);
            const Eight x = lanes::load<Eight>(run->x + p) * sign_x + offset_x,
                        y = lanes::load<Eight>(run->y + p) * sign_y + offset_y,
                        z = lanes::load<Eight>(run->z + p) * sign_z + offset_z;
            const Eight way2 = lanes::select(is_one, (x * x + y * y) + z * z, far2);
            const Eight rest = one - way2 * per_reach2, share = lanes::max(rest, none),
                        weight = share * share * share;
            sum_x += weight * x;
            sum_y += weight * y;
            sum_z += weight * z;
            weights += weight;
            nearest2 = lanes::min(way2, nearest2);
        }
    }
    float least2 = reach2;
    for (int lane = 0; lane < 8; ++lane)
        least2 = nearest2[lane] < least2 ? nearest2[lane] : least2;
    return {{sum_of(sum_x), sum_of(sum_y), sum_of(sum_z)}, sum_of(weights), least2};
}

}  // namespace pastoso::tank::PASTOSO_ISA

PASTOSO_REGISTER_KERNELS(pastoso::tank, ParticleKernels, scatter, follow, sum_near)
