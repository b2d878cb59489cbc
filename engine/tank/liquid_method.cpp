#include "tank/liquid_method.hpp"

#include "core/error.hpp"

namespace pastoso::tank {
namespace {

constexpr int kMaxIterations = 60;

}  // namespace

Nozzle nozzle_of(const Jet& jet, const Domain& domain) {
    Nozzle nozzle = {ShapeDistance(jet.shape), {}, 0};
    nozzle.cells = CellSet(domain.shape(), nozzle.form_m);
    nozzle.cells.order_along(jet.velocity_m_s);
    nozzle.full_count = full_count(nozzle.cells, domain, nozzle.form_m);
    return nozzle;
}

liquid::SolveLimits pressure_limits(const TankScene& scene) {
    return {static_cast<float>(scene.tolerance), kMaxIterations};
}

void check_shapes(std::span<const grid::BoxField* const> fields, const grid::BoxShape& shape) {
    for (const grid::BoxField* field : fields)
        if (field->shape() != shape) throw core::InputError("This is the state of another tank.");
}

}  // namespace pastoso::tank
