#include "film/film_energy.hpp"

#include <numeric>

namespace pastoso::film::test {
namespace {

/// Calls visit(cell, next cell, is_x) for every face inside the canvas, and across periodic edges.
template <class Visit>
void for_each_face(const Scene& scene, const Visit& visit) {
    const int last_x = scene.edge_x == Edge::Periodic ? scene.width : scene.width - 1;
    const int last_y = scene.edge_y == Edge::Periodic ? scene.height : scene.height - 1;
    for (int y = 0; y < scene.height; ++y)
        for (int x = 0; x < scene.width; ++x) {
            const int cell = y * scene.width + x;
            if (x < last_x) visit(cell, y * scene.width + (x + 1) % scene.width, true);
            if (y < last_y) visit(cell, (y + 1) % scene.height * scene.width + x, false);
        }
}

}  // namespace

FilmSnapshot::FilmSnapshot(const Bench& bench) {
    for (int y = 0; y < bench.setup.height; ++y)
        for (int x = 0; x < bench.setup.width; ++x) {
            thickness.push_back(bench.state.thickness.at(x, y) * kThicknessQuantum_mm);
            surface.push_back(thickness.back() + bench.state.support_mm.at(x, y));
            velocity_x.push_back(bench.u(x, y));
            velocity_y.push_back(bench.v(x, y));
        }
    const double mean =
        std::accumulate(surface.begin(), surface.end(), 0.0) / static_cast<double>(surface.size());
    for (double& height : surface)
        height -= mean;
}

double potential_energy(const Bench& bench, const FilmSnapshot& a, const FilmSnapshot& b) {
    const double gravity = bench.setup.gravity / 2;
    const double tension = bench.setup.tension / (2 * bench.setup.cell_mm * bench.setup.cell_mm);
    double energy = 0;
    for (std::size_t i = 0; i < a.surface.size(); ++i)
        energy += gravity * a.surface[i] * b.surface[i];
    for_each_face(bench.setup, [&](int cell, int next, bool) {
        energy += tension * (a.surface[next] - a.surface[cell]) * (b.surface[next] - b.surface[cell]);
    });
    return energy;
}

double kinetic_energy(const Bench& bench, const FilmSnapshot& film) {
    double energy = 0;
    for_each_face(bench.setup, [&](int cell, int next, bool is_x) {
        const double velocity = is_x ? film.velocity_x[cell] : film.velocity_y[cell];
        energy += 0.25 * (film.thickness[cell] + film.thickness[next]) * velocity * velocity;
    });
    return energy;
}

}  // namespace pastoso::film::test
