// A field of balls that flow together: the sum f(x) = sum of phi_i(|x - x_i|) over parcels. Where it
// exceeds a threshold lies the inside of one smooth shape.
//
// A parcel of volume V has the size s = (V / V0)^(1/3), V0 = `unit_volume_m3`; lengths of the kernels
// are those of a parcel of size 1 and grow with it. Balls nearer than a micrometre count as a micrometre
// away.
#pragma once

#include "core/isa.hpp"
#include "core/thread_pool.hpp"
#include "liquid/surface/sampled_field.hpp"
#include "liquid/tea/parcel.hpp"

#include <memory>
#include <span>
#include <variant>
#include <vector>

namespace pastoso::liquid {

/// (1 - r^2/R^2)^3 within R = max(radius s, least_radius), 0 beyond.
struct CompactBalls {
    float radius_m = 0.0024F;
    float least_radius_m =
        0.0F;  ///< about a spacing and more, so that no ball slips through the lattice
};

/// 0.003 (a s)^2 / r^2, everywhere: the balls of "Rendering Milk Tea" (2010), whose threshold is 0.5.
struct InverseSquareBalls {
    float a_m = 0.02F;
};
inline constexpr float kInverseSquareThreshold = 0.5F;

using BallKernel = std::variant<CompactBalls, InverseSquareBalls>;

struct Metaballs {
    BallKernel kernel = CompactBalls{};
    float unit_volume_m3 = 26e-6F / 12000.0F;  ///< V0 > 0
};

/// Fills lattices with the sum, and keeps its working memory.
///
/// Compact balls are added one by one where they are; in every point in the order of the parcels. Those
/// that never end cannot be cut: in a cloud the far balls make up most of the sum. Each is the sum of a
/// near part that ends after eight spacings and of a smooth one, which is spread to the lattice by
/// quintic B-splines and summed by a Fourier transform over twice the lattice, so that nothing comes
/// back around (after the particle-mesh Ewald method, U. Essmann et al., J. Chem. Phys. 103, 1995).
/// Relative error below 2e-5.
class MetaballField {
  public:
    explicit MetaballField(core::ThreadPool& pool);
    ~MetaballField();
    MetaballField(const MetaballField&) = delete;
    MetaballField& operator=(const MetaballField&) = delete;

    /// Overwrites the values of `field`, which has the lattice already. Parcels are finite, and may lie
    /// outside it; those without volume count nothing. The same bits for any number of threads and any
    /// instruction set; those of the Fourier transform depend on the machine.
    void fill(std::span<const Parcel> parcels, const Metaballs& balls, SampledField& field,
              core::Isa isa = core::best_isa());

  private:
    struct Buffers;
    core::ThreadPool& pool_;
    std::unique_ptr<Buffers> buffers_;
};

}  // namespace pastoso::liquid
