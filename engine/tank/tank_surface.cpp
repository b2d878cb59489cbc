#include "tank/tank_surface.hpp"

#include "core/check.hpp"
#include "liquid/flow/slices.hpp"

#include <algorithm>
#include <vector>

namespace pastoso::tank {

using liquid::Lattice;

/// Flat walls come out exact: the distance is linear across them.
void TankSurfaces::compute_domain(const Lattice& lattice, float reach_m) {
    if (domain_m_.lattice() == lattice && reach_m_ == reach_m) return;
    if (domain_m_.lattice() != lattice) domain_m_.assign(lattice);
    reach_m_ = reach_m;
    const grid::BoxShape& box = domain_->shape();
    const glm::vec3 size_m = glm::vec3(box.nx, box.ny, box.nz) * box.cell_m;
    liquid::for_slices(pool_, 0, lattice.nz, [&](int k) {
        for (int j = 0; j < lattice.ny; ++j)
            for (int i = 0; i < lattice.nx; ++i) {
                const glm::vec3 at_m = lattice.point_m(i, j, k);
                float inside_m = std::min({at_m.x, at_m.y, at_m.z, size_m.x - at_m.x, size_m.y - at_m.y,
                                           size_m.z - reach_m - at_m.z});
                if (domain_->has_solids()) inside_m = std::min(inside_m, domain_->free_m(at_m));
                domain_m_.at(i, j, k) = inside_m + reach_m;
            }
    });
}

void TankSurfaces::make(const TankFrame& frame, float reach_m, liquid::TriangleMesh& mesh) {
    PASTOSO_CHECK(reach_m >= 0.0F && reach_m <= 0.5F * domain_->shape().cell_m);
    const Lattice& lattice = frame.level_m.lattice();
    compute_domain(lattice, reach_m);
    if (cut_m_.lattice() != lattice) cut_m_.assign(lattice);
    liquid::for_slices(pool_, 0, lattice.nz, [&](int k) {
        for (int j = 0; j < lattice.ny; ++j) {
            const float *level = frame.level_m.row(j, k), *domain = domain_m_.row(j, k);
            float* cut = cut_m_.row(j, k);
            for (int i = 0; i < lattice.nx; ++i)
                cut[i] = std::min(-level[i], domain[i]);
        }
    });
    cubes_.run(cut_m_.view(), 0.0F, {}, mesh);
}

double TankSurfaces::front_x_m() const {
    constexpr double kSpray = 1.0 / 2000.0;
    const Lattice& lattice = cut_m_.lattice();
    std::vector<double> slabs(static_cast<std::size_t>(lattice.nx), 0.0);
    double all = 0.0;
    for (int k = 0; k < lattice.nz; ++k)
        for (int j = 0; j < lattice.ny; ++j) {
            const float* cut = cut_m_.row(j, k);
            for (int i = 0; i < lattice.nx; ++i) {
                if (!(cut[i] > 0.0F)) continue;
                slabs[static_cast<std::size_t>(i)] += 1.0;
                all += 1.0;
            }
        }
    double beyond = 0.0;
    for (int i = lattice.nx - 1; i >= 0; --i) {
        const double slab = slabs[static_cast<std::size_t>(i)];
        if (slab > 0.0 && beyond + slab > kSpray * all) {
            const double share = (kSpray * all - beyond) / slab;  // of the slab, from its far side
            return static_cast<double>(lattice.origin_m.x) +
                   (i + 0.5 - share) * static_cast<double>(lattice.spacing_m);
        }
        beyond += slab;
    }
    return 0.0;
}

}  // namespace pastoso::tank
