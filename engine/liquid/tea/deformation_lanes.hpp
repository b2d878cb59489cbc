// How a parcel's shape is deformed (parcel_shape.hpp), of one parcel or of many in lanes, with the same
// bits: shared by the kernels and, compiled for the baseline, by everybody else.
#pragma once

#include "core/lane_power.hpp"
#include "liquid/tea/deformation_kernels.hpp"

namespace pastoso::liquid {
namespace {

namespace lanes = core::lanes;

/// In a step; more is taken as this, for steps are of first order.
constexpr float kMostStrain = 1.0F;
/// What one step makes longer than so many limits becomes round again.
constexpr float kTorn = 2.0F;
/// What is thinner than rounding lets it be likewise.
constexpr float kLeastDeterminant = 1e-4F;

template <class F>
struct Row {
    F x, y, z;
};
template <class F>
PASTOSO_LANE_FUNCTION F dot(const Row<F>& a, const Row<F>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// A parcel's S.
template <class F>
struct Covariance {
    F xx, yy, zz, xy, xz, yz;
};

template <class F>
PASTOSO_LANE_FUNCTION F determinant(const Covariance<F>& s) {
    return s.xx * (s.yy * s.zz - s.yz * s.yz) - s.xy * (s.xy * s.zz - s.yz * s.xz) +
           s.xz * (s.xy * s.yz - s.yy * s.xz);
}

template <class Condition, class F>
PASTOSO_LANE_FUNCTION Covariance<F> select(const Condition& condition, const Covariance<F>& a,
                                           const Covariance<F>& b) {
    return {lanes::select(condition, a.xx, b.xx), lanes::select(condition, a.yy, b.yy),
            lanes::select(condition, a.zz, b.zz), lanes::select(condition, a.xy, b.xy),
            lanes::select(condition, a.xz, b.xz), lanes::select(condition, a.yz, b.yz)};
}

/// The time times the velocity's gradient: along[n] its change along axis n.
template <class F>
struct Strain {
    Row<F> along[3];
};

/// What a step does to the parcels of a cell: S becomes A S A^T + widening.
template <class F>
struct Stretching {
    Row<F> rows[3];  ///< of A = 1 + the strain
    F widening;
};

template <class F>
PASTOSO_LANE_FUNCTION Stretching<F> stretching_of(const Strain<F>& strain, const ShapeLimits& limits) {
    const Row<F>&along_x = strain.along[0], &along_y = strain.along[1], &along_z = strain.along[2];
    const F xy = along_x.y + along_y.x, xz = along_x.z + along_z.x, yz = along_y.z + along_z.y;
    const Row<F> twice[] = {{along_x.x + along_x.x, xy, xz},
                            {xy, along_y.y + along_y.y, yz},
                            {xz, yz, along_z.z + along_z.z}};
    const F squares = dot(twice[0], twice[0]) + dot(twice[1], twice[1]) + dot(twice[2], twice[2]);
    const F size = lanes::sqrt(F(0.5F) * squares);
    const F part = lanes::select(size > F(kMostStrain), F(kMostStrain) / size, F(1.0F));
    const F one = F(1.0F), zero = F(0.0F);
    return {{{one + part * along_x.x, zero + part * along_y.x, zero + part * along_z.x},
             {zero + part * along_x.y, one + part * along_y.y, zero + part * along_z.y},
             {zero + part * along_x.z, zero + part * along_y.z, one + part * along_z.z}},
            F(limits.widening_per_strain) * (size * part)};
}

template <class F>
PASTOSO_LANE_FUNCTION Covariance<F> stretched(const Covariance<F>& s, const Stretching<F>& by) {
    const auto times = [&s](const Row<F>& row) PASTOSO_LANE_MEMBER {
        return Row<F>{s.xx * row.x + s.xy * row.y + s.xz * row.z,
                      s.xy * row.x + s.yy * row.y + s.yz * row.z,
                      s.xz * row.x + s.yz * row.y + s.zz * row.z};
    };
    const Row<F> x = times(by.rows[0]), y = times(by.rows[1]), z = times(by.rows[2]);
    return {dot(x, by.rows[0]) + by.widening,
            dot(y, by.rows[1]) + by.widening,
            dot(z, by.rows[2]) + by.widening,
            dot(x, by.rows[1]),
            dot(x, by.rows[2]),
            dot(y, by.rows[2])};
}

/// Cuts long axes off: S - e S^2, e such that one axis alone would be cut to `most`.
template <class F>
PASTOSO_LANE_FUNCTION Covariance<F> cut_to(float most, const Covariance<F>& s) {
    const F xy2 = s.xy * s.xy, xz2 = s.xz * s.xz, yz2 = s.yz * s.yz;
    const F xx = s.xx * s.xx + xy2 + xz2, yy = xy2 + s.yy * s.yy + yz2, zz = xz2 + yz2 + s.zz * s.zz;
    const F longest = (xx + yy + zz) / (s.xx + s.yy + s.zz);
    const F e = lanes::min(F(0.5F) / longest, (longest - F(most)) / (longest * longest));
    const Covariance<F> cut = {s.xx - e * xx,
                               s.yy - e * yy,
                               s.zz - e * zz,
                               s.xy - e * (s.xy * (s.xx + s.yy) + s.xz * s.yz),
                               s.xz - e * (s.xz * (s.xx + s.zz) + s.xy * s.yz),
                               s.yz - e * (s.yz * (s.yy + s.zz) + s.xy * s.xz)};
    return select(longest <= F(most), s, cut);
}

template <class F>
PASTOSO_LANE_FUNCTION Covariance<F> deformed_by(const Stretching<F>& stretching, const Covariance<F>& s,
                                                const ShapeLimits& limits) {
    const F width = lanes::cube_root(determinant(s));
    const F wide = lanes::min(F(limits.most), width + stretching.widening);
    const Covariance<F> cut = cut_to(limits.most, stretched(s, stretching));
    const F volume2 = determinant(cut);
    const F by = wide * lanes::inverse_cube_root(volume2);
    const Covariance<F> kept = {cut.xx * by, cut.yy * by, cut.zz * by,
                                cut.xy * by, cut.xz * by, cut.yz * by};
    const F longest = lanes::max(lanes::max(kept.xx, kept.yy), kept.zz);
    const Covariance<F> round = {wide, wide, wide, F(0.0F), F(0.0F), F(0.0F)};
    return select(volume2 > F(kLeastDeterminant) && longest <= F(kTorn * limits.most), kept, round);
}

}  // namespace
}  // namespace pastoso::liquid
