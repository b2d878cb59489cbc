// What the tea makes of a parcel's shape: flow draws it out, and whirls smaller than a cell widen it.
//
// A parcel is a puff whose milk has the covariance s0^2 S, s0 that of a parcel as it is poured. In a
// flow of gradient L that mixes with the diffusivity D
//     dS/dt = L S + S L^T + 2 D / s0^2,
// until it is so long that it would be bent and folded: no axis grows beyond a limit, and the others
// stay as wide as the milk needs: det(S)^(1/3) grows by 2 D / s0^2 alone.
#pragma once

#include "liquid/flow/velocity.hpp"
#include "liquid/tea/deformation_kernels.hpp"
#include "liquid/tea/parcel.hpp"
#include "liquid/tea/tea_settings.hpp"

#include <span>

#include <glm/mat3x3.hpp>

namespace pastoso::liquid {

/// How far a parcel's kernel (1 - r^2)^2 reaches as it is poured: parcels side by side make an even
/// body. It is 3 s0.
float poured_reach_m(const TeaSettings& settings);

/// D = (C h)^2 |L|, the eddy diffusivity of what a cell of side h does not resolve (Smagorinsky 1963),
/// |L| = sqrt(2 tr(E^2)) the rate of strain E = (L + L^T) / 2. No axis becomes longer than four of a
/// parcel as it is poured, nor than what fills a cell.
ShapeLimits shape_limits(const TeaSettings& settings);

/// After a time in which the flow has a gradient: `strain` is the time times L, L's column n the change
/// of velocity along axis n.
ParcelShape deformed(const ParcelShape& shape, const glm::mat3& strain, const ShapeLimits& limits);

/// The same during `dt_s`, by the velocity's gradient in the cell that each parcel lies in.
void deform(std::span<Parcel> parcels, const VelocityField& velocity, float dt_s,
            const ShapeLimits& limits,
            const DeformationKernels& kernels = core::kernels<DeformationKernels>());

/// det(S)^(1/3): the variance along an axis of a round parcel of the same volume.
float width(const ParcelShape& shape);

/// Whether it is a shape at all: positive definite, and below 1e4 along each axis.
bool is_shape(const ParcelShape& shape);

}  // namespace pastoso::liquid
