#include "recordings/surface_index.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::recordings {

SurfaceIndex surface_index(const document::SurfaceState& surface) {
    const film::FilmState& film = surface.film;
    return {.shape = film.shape,
            .cell_mm = film.cell_mm,
            .consistencies = film.consistencies,
            .media = media_index(film.media),
            .fixed = film.strata.fixed,
            .evaporated = film.strata.evaporated,
            .calls = surface.solver.calls,
            .runoff = surface.solver.runoff,
            .entries = {}};
}

document::SurfaceState empty_surface(const SurfaceIndex& index) {
    document::SurfaceState surface{film::FilmState(index.shape, index.cell_mm), {}};
    surface.film.consistencies = index.consistencies.value_or(film::Consistencies{});
    set_media(index.media, surface.film);
    surface.film.strata.fixed = index.fixed;
    surface.film.strata.evaporated = index.evaporated;
    surface.solver.calls = index.calls;
    surface.solver.runoff = index.runoff;
    return surface;
}

double largest_count(const SurfaceIndex& surface) {
    double largest = static_cast<double>(surface.evaporated);
    const auto note = [&](std::int64_t count) {
        largest = std::max(largest, std::abs(static_cast<double>(count)));
    };
    note(surface.fixed.thickness);
    note(surface.runoff.thickness);
    std::ranges::for_each(surface.fixed.pigment, note);
    std::ranges::for_each(surface.runoff.paint, note);
    return largest;
}

}  // namespace pastoso::recordings
