#include "liquid/tea/milk_depth.hpp"

#include "core/check.hpp"
#include "liquid/tea/between.hpp"

#include <glm/geometric.hpp>

namespace pastoso::liquid {
namespace {

/// A layer at a place between the middles of cells: 0 beyond the box.
struct InLayer {
    Between x, y;

    float of(const grid::BoxField& field, int k) const {
        return row(field, y.lower, k) * (1.0F - y.part) + row(field, y.lower + 1, k) * y.part;
    }

  private:
    float row(const grid::BoxField& field, int j, int k) const {
        return at(field, x.lower, j, k) * (1.0F - x.part) + at(field, x.lower + 1, j, k) * x.part;
    }
    static float at(const grid::BoxField& field, int i, int j, int k) {
        const grid::BoxShape& shape = field.shape();
        return i >= 0 && j >= 0 && i < shape.nx && j < shape.ny && k < shape.nz ? field.at(i, j, k)
                                                                                : 0.0F;
    }
};

}  // namespace

grid::BoxField halved(const grid::BoxField& field) {
    const grid::BoxShape& fine = field.shape();
    PASTOSO_CHECK(fine.nx % 2 == 0 && fine.ny % 2 == 0 && fine.nz % 2 == 0);
    grid::BoxField coarse({fine.nx / 2, fine.ny / 2, fine.nz / 2, 2.0F * fine.cell_m});
    for (int k = 0; k < fine.nz; ++k)
        for (int j = 0; j < fine.ny; ++j)
            for (int i = 0; i < fine.nx; ++i)
                coarse.at(i / 2, j / 2, k / 2) += 0.125F * field.at(i, j, k);
    return coarse;
}

grid::BoxField milk_depth_m(const grid::BoxField& share, const glm::vec3& way) {
    PASTOSO_CHECK_OP(way.z, >, 0.0F);
    const grid::BoxShape& shape = share.shape();
    const glm::vec3 step = way / way.z;
    const float half_step_m = 0.5F * shape.cell_m * glm::length(step);
    grid::BoxField depth_m(shape);
    for (int k = shape.nz - 1; k >= 0; --k)
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i) {
                const InLayer above = {between(static_cast<float>(i) + step.x),
                                       between(static_cast<float>(j) + step.y)};
                depth_m.at(i, j, k) = above.of(depth_m, k + 1) +
                                      half_step_m * (share.at(i, j, k) + above.of(share, k + 1));
            }
    return depth_m;
}

}  // namespace pastoso::liquid
