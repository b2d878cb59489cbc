#include "layers/transform.hpp"

#include "core/check.hpp"
#include "core/units.hpp"
#include "layers/resampling.hpp"

#include <cmath>

namespace pastoso::layers {

Projective in_cells(const Transform& transform, double cell_mm) {
    PASTOSO_CHECK(transform.scale_x != 0.0 && transform.scale_y != 0.0);
    const double angle = core::radians(transform.turn_deg);
    const double cosine = std::cos(angle), sine = std::sin(angle);
    Projective map{cosine * transform.scale_x, -sine * transform.scale_y,  0.0,
                   sine * transform.scale_x,   cosine * transform.scale_y, 0.0};
    const double x = transform.centre_x_mm / cell_mm, y = transform.centre_y_mm / cell_mm;
    const grid::Point turned = map(x, y);
    map.c = x + transform.move_x_mm / cell_mm - turned.x;
    map.f = y + transform.move_y_mm / cell_mm - turned.y;
    return map;
}

Corners corners_in_cells(const Distortion& distortion, double cell_mm) {
    const auto cells = [&](const Place& place) {
        return grid::Point{place.x_mm / cell_mm, place.y_mm / cell_mm};
    };
    return {cells(distortion.upper_left), cells(distortion.upper_right), cells(distortion.lower_right),
            cells(distortion.lower_left)};
}

Projective in_cells(const Distortion& distortion, double cell_mm) {
    return onto_corners({distortion.corner.x_mm / cell_mm, distortion.corner.y_mm / cell_mm},
                        distortion.width_mm / cell_mm, distortion.height_mm / cell_mm,
                        corners_in_cells(distortion, cell_mm));
}

film::FilmState transformed(const film::FilmState& layer, const Projective& map_cells,
                            core::ThreadPool& pool) {
    return resampled(layer, {map_cells, layer.shape, layer.cell_mm}, pool);
}

grid::Mask transformed(const grid::Mask& mask, const Projective& map_cells) {
    return resampled(mask, {map_cells, mask.shape(), 1.0});
}

}  // namespace pastoso::layers
