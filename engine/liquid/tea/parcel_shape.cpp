#include "liquid/tea/parcel_shape.hpp"

#include "liquid/tea/deformation_lanes.hpp"
#include "liquid/tea/milk_jug.hpp"

#include <algorithm>
#include <cstddef>

namespace pastoso::liquid {
namespace {

/// In distances of parcels as they are poured.
constexpr float kEvenReach = 1.75F;
/// Of what a cell does not resolve. Smagorinsky's 0.1 to 0.2 stand for momentum in a turbulence that
/// goes on below the cell; the tea's flow is smooth there.
constexpr float kMixing = 0.03F;
/// How long a parcel becomes, of its length as poured.
constexpr float kMostLength = 4.0F;
Covariance<float> covariance(const ParcelShape& s) {
    return {s.xx, s.yy, s.zz, s.xy, s.xz, s.yz};
}

Strain<float> strain_of(const glm::mat3& strain) {
    const auto row = [&](int along) {
        return Row<float>{strain[along].x, strain[along].y, strain[along].z};
    };
    return {{row(0), row(1), row(2)}};
}

}  // namespace

float poured_reach_m(const TeaSettings& settings) {
    return kEvenReach * lanes::cube_root(milk_per_parcel_m3(settings));
}

ShapeLimits shape_limits(const TeaSettings& settings) {
    const float poured_m = poured_reach_m(settings) / 3.0F,
                cell_m = static_cast<float>(settings.box_m / settings.cells);
    const float cells = cell_m / poured_m;
    return {std::min(1.0F + cells * cells / 3.0F, kMostLength * kMostLength),
            2.0F * kMixing * kMixing * cells * cells};
}

ParcelShape deformed(const ParcelShape& shape, const glm::mat3& strain, const ShapeLimits& limits) {
    const Covariance<float> s =
        deformed_by(stretching_of(strain_of(strain), limits), covariance(shape), limits);
    return {s.xx, s.yy, s.zz, s.xy, s.xz, s.yz};
}

void deform(std::span<Parcel> parcels, const VelocityField& velocity, float dt_s,
            const ShapeLimits& limits, const DeformationKernels& kernels) {
    static_assert(sizeof(Parcel) == kWordsOfParcel * sizeof(float) &&
                  offsetof(Parcel, position_m) == kPositionWord * sizeof(float) &&
                  offsetof(Parcel, shape) == kShapeWord * sizeof(float));
    const grid::BoxShape& shape = velocity.shape();
    const DeformationView view = {{velocity.x.row(0, 0), velocity.y.row(0, 0), velocity.z.row(0, 0)},
                                  shape.stride_y(),
                                  shape.stride_z(),
                                  {shape.nx, shape.ny, shape.nz},
                                  shape.cell_m,
                                  dt_s,
                                  limits};
    kernels.deform(view, {reinterpret_cast<float*>(parcels.data()), static_cast<int>(parcels.size())});
}

float width(const ParcelShape& shape) {
    return lanes::cube_root(determinant(covariance(shape)));
}

bool is_shape(const ParcelShape& s) {
    constexpr float kMost = 1e4F;
    const bool is_bounded = s.xx < kMost && s.yy < kMost && s.zz < kMost;
    return is_bounded && s.xx > 0.0F && s.xx * s.yy - s.xy * s.xy > 0.0F &&
           determinant(covariance(s)) > kLeastDeterminant;
}

}  // namespace pastoso::liquid
