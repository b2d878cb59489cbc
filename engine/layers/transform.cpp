#include "layers/transform.hpp"

#include "core/check.hpp"
#include "core/units.hpp"
#include "layers/resampling.hpp"

#include <cmath>

namespace pastoso::layers {
namespace {

Affine in_cells(const Transform& transform, double cell_mm) {
    const double angle = core::radians(transform.turn_deg);
    const double cosine = std::cos(angle), sine = std::sin(angle);
    Affine map{cosine * transform.scale_x, -sine * transform.scale_y,  0.0,
               sine * transform.scale_x,   cosine * transform.scale_y, 0.0};
    const double x = transform.centre_x_mm / cell_mm, y = transform.centre_y_mm / cell_mm;
    const grid::Point turned = map(x, y);
    map.c = x + transform.move_x_mm / cell_mm - turned.x;
    map.f = y + transform.move_y_mm / cell_mm - turned.y;
    return map;
}

Resampling on_same_canvas(const Transform& transform, grid::Shape shape, double cell_mm) {
    PASTOSO_CHECK(transform.scale_x != 0.0 && transform.scale_y != 0.0);
    return {in_cells(transform, cell_mm), shape, cell_mm};
}

}  // namespace

film::FilmState transformed(const film::FilmState& layer, const Transform& transform,
                            core::ThreadPool& pool) {
    return resampled(layer, on_same_canvas(transform, layer.shape, layer.cell_mm), pool);
}

grid::Mask transformed(const grid::Mask& mask, double cell_mm, const Transform& transform) {
    return resampled(mask, on_same_canvas(transform, mask.shape(), cell_mm));
}

}  // namespace pastoso::layers
