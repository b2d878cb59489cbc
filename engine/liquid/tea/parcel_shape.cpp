#include "liquid/tea/parcel_shape.hpp"

#include "core/elementary.hpp"
#include "liquid/tea/milk_jug.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace pastoso::liquid {
namespace {

/// In distances of parcels as they are poured.
constexpr float kEvenReach = 1.75F;
/// Of what a cell does not resolve. Smagorinsky's 0.1 to 0.2 stand for momentum in a turbulence that
/// goes on below the cell; the tea's flow is smooth there.
constexpr float kMixing = 0.03F;
/// How long a parcel becomes, of its length as poured.
constexpr float kMostLength = 4.0F;
/// In a step; more is taken as this, for steps are of first order.
constexpr float kMostStrain = 1.0F;
/// What one step makes longer than so many limits becomes round again.
constexpr float kTorn = 2.0F;
/// What is thinner than rounding lets it be likewise.
constexpr float kLeastDeterminant = 1e-4F;

float determinant(const ParcelShape& s) {
    return s.xx * (s.yy * s.zz - s.yz * s.yz) - s.xy * (s.xy * s.zz - s.yz * s.xz) +
           s.xz * (s.xy * s.yz - s.yy * s.xz);
}

ParcelShape round(float width) {
    return {width, width, width};
}

ParcelShape scaled(const ParcelShape& s, float by) {
    return {s.xx * by, s.yy * by, s.zz * by, s.xy * by, s.xz * by, s.yz * by};
}

/// What a step does to the parcels of a cell: S becomes A S A^T + widening.
struct Stretching {
    glm::mat3 rows;  ///< of A = 1 + the strain, as columns
    float widening;
};

Stretching stretching_of(const glm::mat3& strain, const ShapeLimits& limits) {
    const glm::mat3 twice = strain + glm::transpose(strain);
    const float squares =
        glm::dot(twice[0], twice[0]) + glm::dot(twice[1], twice[1]) + glm::dot(twice[2], twice[2]);
    const float size = std::sqrt(0.5F * squares), part = size > kMostStrain ? kMostStrain / size : 1.0F;
    return {glm::mat3(1.0F) + part * glm::transpose(strain), limits.widening_per_strain * (size * part)};
}

ParcelShape stretched(const ParcelShape& s, const Stretching& by) {
    const auto times = [&s](const glm::vec3& row) {
        return glm::vec3(s.xx * row.x + s.xy * row.y + s.xz * row.z,
                         s.xy * row.x + s.yy * row.y + s.yz * row.z,
                         s.xz * row.x + s.yz * row.y + s.zz * row.z);
    };
    const glm::vec3 x = times(by.rows[0]), y = times(by.rows[1]), z = times(by.rows[2]);
    return {glm::dot(x, by.rows[0]) + by.widening,
            glm::dot(y, by.rows[1]) + by.widening,
            glm::dot(z, by.rows[2]) + by.widening,
            glm::dot(x, by.rows[1]),
            glm::dot(x, by.rows[2]),
            glm::dot(y, by.rows[2])};
}

/// Cuts long axes off: S - e S^2, e such that one axis alone would be cut to `most`.
ParcelShape cut_to(float most, const ParcelShape& s) {
    const float xy2 = s.xy * s.xy, xz2 = s.xz * s.xz, yz2 = s.yz * s.yz;
    const float xx = s.xx * s.xx + xy2 + xz2, yy = xy2 + s.yy * s.yy + yz2, zz = xz2 + yz2 + s.zz * s.zz;
    const float longest = (xx + yy + zz) / (s.xx + s.yy + s.zz);
    if (longest <= most) return s;
    const float e = std::min((longest - most) / (longest * longest), 0.5F / longest);
    return {s.xx - e * xx,
            s.yy - e * yy,
            s.zz - e * zz,
            s.xy - e * (s.xy * (s.xx + s.yy) + s.xz * s.yz),
            s.xz - e * (s.xz * (s.xx + s.zz) + s.xy * s.yz),
            s.yz - e * (s.yz * (s.yy + s.zz) + s.xy * s.xz)};
}

ParcelShape deformed_by(const Stretching& stretching, const ParcelShape& shape,
                        const ShapeLimits& limits) {
    const float wide = std::min(width(shape) + stretching.widening, limits.most);
    const ParcelShape cut = cut_to(limits.most, stretched(shape, stretching));
    const float volume2 = determinant(cut);
    if (!(volume2 > kLeastDeterminant)) return round(wide);
    const ParcelShape kept = scaled(cut, wide * core::inverse_cube_root(volume2));
    return std::max({kept.xx, kept.yy, kept.zz}) > kTorn * limits.most ? round(wide) : kept;
}

/// Of the velocity in the middle of a cell: column n is its change along axis n.
glm::mat3 gradient_per_s(const VelocityField& velocity, const glm::ivec3& cell) {
    const grid::BoxShape& shape = velocity.shape();
    const std::ptrdiff_t at = shape.index(cell.x, cell.y, cell.z);
    glm::mat3 gradient;
    for (const int across : kAxes) {
        const float* u = velocity.along(across).values().data() + at;
        const std::ptrdiff_t next = stride(shape, across);
        for (const int along : kAxes) {
            const std::ptrdiff_t step = stride(shape, along);
            gradient[along][across] =
                (along == across ? u[next] - u[0]
                                 : 0.25F * (u[step] + u[step + next] - u[-step] - u[next - step])) /
                shape.cell_m;
        }
    }
    return gradient;
}

glm::ivec3 cell_of(const Parcel& parcel, const grid::BoxShape& shape) {
    return glm::clamp(glm::ivec3(parcel.position_m / shape.cell_m), glm::ivec3(0),
                      glm::ivec3(shape.nx, shape.ny, shape.nz) - 1);
}

}  // namespace

float poured_reach_m(const TeaSettings& settings) {
    return kEvenReach * core::cube_root(milk_per_parcel_m3(settings));
}

ShapeLimits shape_limits(const TeaSettings& settings) {
    const float poured_m = poured_reach_m(settings) / 3.0F,
                cell_m = static_cast<float>(settings.box_m / settings.cells);
    const float cells = cell_m / poured_m;
    return {std::min(1.0F + cells * cells / 3.0F, kMostLength * kMostLength),
            2.0F * kMixing * kMixing * cells * cells};
}

ParcelShape deformed(const ParcelShape& shape, const glm::mat3& strain, const ShapeLimits& limits) {
    return deformed_by(stretching_of(strain, limits), shape, limits);
}

void deform(std::span<Parcel> parcels, const VelocityField& velocity, float dt_s,
            const ShapeLimits& limits) {
    const grid::BoxShape& shape = velocity.shape();
    glm::ivec3 cell(-1);
    Stretching stretching{};
    for (Parcel& parcel : parcels) {
        const glm::ivec3 now = cell_of(parcel, shape);
        if (now != cell) stretching = stretching_of(dt_s * gradient_per_s(velocity, now), limits);
        cell = now;
        parcel.shape = deformed_by(stretching, parcel.shape, limits);
    }
}

float width(const ParcelShape& shape) {
    return core::cube_root(determinant(shape));
}

bool is_shape(const ParcelShape& s) {
    constexpr float kMost = 1e4F;
    const bool is_bounded = s.xx < kMost && s.yy < kMost && s.zz < kMost;
    return is_bounded && s.xx > 0.0F && s.xx * s.yy - s.xy * s.xy > 0.0F &&
           determinant(s) > kLeastDeterminant;
}

}  // namespace pastoso::liquid
