#include "liquid/surface/metaballs.hpp"

#include "core/check.hpp"
#include "liquid/classic/far_field.hpp"
#include "liquid/surface/ball_splat.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pastoso::liquid {
namespace {

constexpr double kLeastDistance_m = 1e-6;
constexpr double kInverseSquareFactor = 0.003;

double size_of(const Parcel& parcel, const Metaballs& balls) {
    const double volumes =
        static_cast<double>(parcel.volume_m3) / static_cast<double>(balls.unit_volume_m3);
    return std::cbrt(volumes);
}

/// A kernel in spacings of a lattice.
struct Form {
    float reach, strength;
};

Form form(const CompactBalls& balls, double size, double spacing_m) {
    const double reach_m =
        std::max(static_cast<double>(balls.radius_m) * size, static_cast<double>(balls.least_radius_m));
    return {static_cast<float>(reach_m / spacing_m), 1.0F};
}

Form form(const InverseSquareBalls& balls, double size, double spacing_m) {
    const double a = static_cast<double>(balls.a_m) * size / spacing_m;
    return {kNearReach, static_cast<float>(kInverseSquareFactor * a * a)};
}

AddBalls near_kernel(const BallKernel& kernel, const BallKernels& kernels) {
    return std::holds_alternative<CompactBalls>(kernel) ? kernels.compact : kernels.near_inverse_square;
}

/// Parcels with volume as balls of a lattice.
void take_balls(std::span<const Parcel> parcels, const Metaballs& balls, const Lattice& lattice,
                std::vector<Ball>& out) {
    const auto spacing_m = static_cast<double>(lattice.spacing_m);
    out.clear();
    for (const Parcel& parcel : parcels) {
        if (!(parcel.volume_m3 > 0.0F)) continue;
        const glm::dvec3 place =
            (glm::dvec3(parcel.position_m) - glm::dvec3(lattice.origin_m)) / spacing_m;
        PASTOSO_CHECK(std::isfinite(place.x + place.y + place.z) && std::isfinite(parcel.volume_m3));
        const double size = size_of(parcel, balls);
        const Form form_of =
            std::visit([&](const auto& kernel) { return form(kernel, size, spacing_m); }, balls.kernel);
        out.push_back({static_cast<float>(place.x), static_cast<float>(place.y),
                       static_cast<float>(place.z), form_of.reach, form_of.strength});
    }
}

/// The whole sum of balls beside the lattice, where the transform does not reach.
void add_one_by_one(const std::vector<Ball>& balls, float least_square, SampledField& field,
                    core::ThreadPool& pool) {
    const Lattice& lattice = field.lattice();
    pool.run(static_cast<std::size_t>(lattice.nz), [&](std::size_t layer, int) {
        const int k = static_cast<int>(layer);
        for (const Ball& ball : balls) {
            const float z = static_cast<float>(k) - ball.z;
            for (int j = 0; j < lattice.ny; ++j) {
                const float y = static_cast<float>(j) - ball.y, across = z * z + y * y;
                float* row = field.row(j, k);
                for (int i = 0; i < lattice.nx; ++i) {
                    const float x = static_cast<float>(i) - ball.x;
                    row[i] += ball.strength / std::max(across + x * x, least_square);
                }
            }
        }
    });
}

}  // namespace

struct MetaballField::Buffers {
    BallSplat splat;
    std::unique_ptr<FarField> far;
    std::vector<Ball> balls, beside;
};

MetaballField::MetaballField(core::ThreadPool& pool)
    : pool_(pool), buffers_(std::make_unique<Buffers>()) {}

MetaballField::~MetaballField() = default;

void MetaballField::fill(std::span<const Parcel> parcels, const Metaballs& balls, SampledField& field,
                         core::Isa isa) {
    PASTOSO_CHECK_OP(balls.unit_volume_m3, >, 0.0F);
    const Lattice lattice = field.lattice();
    field.assign(lattice);
    take_balls(parcels, balls, lattice, buffers_->balls);
    const double least = kLeastDistance_m / static_cast<double>(lattice.spacing_m);
    const auto least_square = static_cast<float>(least * least);
    if (std::holds_alternative<InverseSquareBalls>(balls.kernel)) {
        if (!buffers_->far || !buffers_->far->serves(lattice))
            buffers_->far = std::make_unique<FarField>(lattice.nx, lattice.ny, lattice.nz);
        const auto beside =
            std::stable_partition(buffers_->balls.begin(), buffers_->balls.end(),
                                  [&](const Ball& ball) { return FarField::reaches(lattice, ball); });
        buffers_->beside.assign(beside, buffers_->balls.end());
        buffers_->balls.erase(beside, buffers_->balls.end());
        buffers_->far->add(buffers_->balls, field, pool_);
        add_one_by_one(buffers_->beside, least_square, field, pool_);
    }
    buffers_->splat.add(buffers_->balls, near_kernel(balls.kernel, core::kernels<BallKernels>(isa)),
                        least_square, field, pool_);
}

}  // namespace pastoso::liquid
