#include "liquid/tea/milk_surface.hpp"

#include "core/check.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace pastoso::liquid {
namespace {

/// How fast the cup cuts the field, in thresholds a spacing: about as steep as balls of the usual size
/// end.
constexpr float kCutSlope = 0.8F;
constexpr double kFirstGuess = 0.7;  // a parcel alone
constexpr double kLowestThreshold = 1e-4, kHighestThreshold = 1e4;

/// One try of a search.
struct Try {
    double place = 0.0;  ///< the threshold's logarithm
    double excess = 0.0;
};

/// Finds where a falling function is zero: steps of growing length until it is between two tries, then
/// false position, whose older end counts half when it stays (Illinois).
class Search {
  public:
    explicit Search(double first) : place_(first) {}

    double place() const { return place_; }
    /// Whether the zero lies beyond the lowest or the highest threshold.
    bool is_out_of_reach() const { return out_of_reach_; }

    void note(double excess) {
        std::optional<Try>& same = excess > 0.0 ? low_ : high_;
        std::optional<Try>& other = excess > 0.0 ? high_ : low_;
        if (same && other && was_above_ == (excess > 0.0)) other->excess *= 0.5;
        was_above_ = excess > 0.0;
        same = Try{place_, excess};
        if (low_ && high_) {
            const double share = low_->excess / (low_->excess - high_->excess);
            place_ = low_->place + std::clamp(share, 0.05, 0.95) * (high_->place - low_->place);
        } else {
            const double next = place_ + (excess > 0.0 ? step_ : -step_), before = place_;
            place_ = std::clamp(next, std::log(kLowestThreshold), std::log(kHighestThreshold));
            step_ *= 2.0;
            out_of_reach_ = place_ == before;
        }
    }

  private:
    double place_, step_ = 0.4;
    std::optional<Try> low_, high_;  ///< too much volume, too little
    bool was_above_ = false, out_of_reach_ = false;
};

Metaballs widened(const Metaballs& balls, float least_m) {
    Metaballs wide = balls;
    if (auto* compact = std::get_if<CompactBalls>(&wide.kernel))
        compact->least_radius_m = std::max(compact->least_radius_m, least_m);
    return wide;
}

double total_volume(std::span<const Parcel> parcels) {
    return std::accumulate(parcels.begin(), parcels.end(), 0.0, [](double sum, const Parcel& parcel) {
        return sum + static_cast<double>(std::max(parcel.volume_m3, 0.0F));
    });
}

}  // namespace

void MilkSurfaces::sample_cup(const Cup& cup, const Lattice& lattice, float gap_m) {
    if (inside_.lattice() == lattice && cup_ == cup && gap_m_ == gap_m) return;
    inside_.assign(lattice);
    cup_ = cup;
    gap_m_ = gap_m;
    const float scale = kCutSlope / lattice.spacing_m;
    pool_.run(static_cast<std::size_t>(lattice.nz), [&](std::size_t layer, int) {
        const int k = static_cast<int>(layer);
        for (int j = 0; j < lattice.ny; ++j) {
            float* row = inside_.row(j, k);
            for (int i = 0; i < lattice.nx; ++i)
                row[i] = -scale * (tea_distance_m(cup, lattice.point_m(i, j, k)) + gap_m);
        }
    });
}

/// Rows at the lattice's border count as empty.
void MilkSurfaces::compute_milk() {
    const Lattice& lattice = field_.lattice();
    has_milk_.assign(static_cast<std::size_t>(lattice.ny) * static_cast<std::size_t>(lattice.nz), 0);
    pool_.run(static_cast<std::size_t>(lattice.nz), [&](std::size_t layer, int) {
        const int k = static_cast<int>(layer);
        if (k == 0 || k == lattice.nz - 1) return;
        for (int j = 1; j + 1 < lattice.ny; ++j) {
            const float* row = field_.row(j, k);
            bool found = false;
            for (int i = 0; i < lattice.nx; ++i)
                found = found | (row[i] > 0.0F);
            has_milk_[layer * static_cast<std::size_t>(lattice.ny) + static_cast<std::size_t>(j)] =
                found;
        }
    });
    cut_.assign(lattice);
}

/// min(f, threshold (1 + inside)): above the threshold where there is milk, within the cup. Linear interpolation
/// between two samples ends at the cup or before it.
void MilkSurfaces::cut(float threshold) {
    const Lattice& lattice = field_.lattice();
    pool_.run(static_cast<std::size_t>(lattice.nz), [&](std::size_t layer, int) {
        const int k = static_cast<int>(layer);
        for (int j = 0; j < lattice.ny; ++j) {
            if (has_milk_[layer * static_cast<std::size_t>(lattice.ny) + static_cast<std::size_t>(j)] ==
                0)
                continue;
            const float *field = field_.row(j, k), *inside = inside_.row(j, k);
            float* out = cut_.row(j, k);
            for (int i = 1; i + 1 < lattice.nx; ++i) {
                const float most = threshold * (1.0F + inside[i]);
                out[i] = field[i] < most ? field[i] : most;
            }
        }
    });
}

double MilkSurfaces::volume_at(float threshold, const MilkSurfaceSettings& settings,
                               TriangleMesh& mesh) {
    cut(threshold);
    cubes_.run(cut_.view(), threshold, {MeshBorder::Open, false, settings.isa}, mesh);
    return volume_m3(mesh);
}

MilkSurface MilkSurfaces::make(std::span<const Parcel> parcels, const Cup& cup,
                               const grid::BoxShape& shape, const MilkSurfaceSettings& settings) {
    PASTOSO_CHECK(settings.parts >= 1 && settings.parts <= 8);
    PASTOSO_CHECK_OP(settings.gap_m, >=, 0.0F);
    MilkSurface milk;
    milk.parcels_m3 = total_volume(parcels);
    if (milk.parcels_m3 == 0.0) return milk;
    const Lattice lattice = cell_centres(shape, settings.parts);
    if (field_.lattice() != lattice) field_.assign(lattice);
    balls_.fill(parcels, widened(settings.balls, settings.least_reach * lattice.spacing_m), field_,
                settings.isa);
    sample_cup(cup, lattice, settings.gap_m);
    compute_milk();
    Search search(std::log(kFirstGuess));
    double best = -1.0;
    while (milk.tries < settings.most_tries && best != 0.0 && !search.is_out_of_reach()) {
        const auto threshold = static_cast<float>(std::exp(search.place()));
        const double excess = volume_at(threshold, settings, milk.mesh) / milk.parcels_m3 - 1.0;
        ++milk.tries;
        if (best < 0.0 || std::abs(excess) < best) {
            best = std::abs(excess) <= settings.volume_tolerance ? 0.0 : std::abs(excess);
            milk.threshold = threshold;
        }
        search.note(excess);
    }
    cut(milk.threshold);
    cubes_.run(cut_.view(), milk.threshold, {MeshBorder::Open, true, settings.isa}, milk.mesh);
    milk.mesh_m3 = volume_m3(milk.mesh);
    return milk;
}

}  // namespace pastoso::liquid
