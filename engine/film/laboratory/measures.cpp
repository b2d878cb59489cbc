#include "film/laboratory/measures.hpp"

#include "core/units.hpp"
#include "film/face/film_end.hpp"
#include "film/step_setup.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pastoso::film {
namespace {

/// From millimetres, seconds and kg/m3 to joules: mm5/s2 to m5/s2.
constexpr double kJoule = 1e-15;

double area_of(double slope2, bool full_curvature) {
    return full_curvature ? std::sqrt(1.0 + slope2) : 1.0 + 0.5 * slope2;
}

/// Of the film in a cell, over the cell's own area.
struct FilmSurface {
    double area;     ///< of its surface
    double covered;  ///< of the ground under it
};

/// A film with its neighbours across periodic edges.
class Cells {
  public:
    Cells(const FilmState& film, const SolverOptions& options)
        : film_(film),
          periodic_x_(options.edge_x == Edge::Periodic),
          periodic_y_(options.edge_y == Edge::Periodic) {}

    /// Exact, unlike thickness_mm().
    double h(int x, int y) const { return film_.thickness.at(x, y) * kThicknessQuantum_mm; }
    double c(int x, int y) const { return film_.support_mm.at(x, y); }
    double eta(int x, int y) const { return h(x, y) + c(x, y); }

    /// The column before or behind x; x itself beyond an edge that is not periodic.
    int column(int x) const { return neighbour(x, film_.shape.width, periodic_x_); }
    int row(int y) const { return neighbour(y, film_.shape.height, periodic_y_); }

    /// Means of a cell's two faces; a face on the upper or left edge, which no cell stores, rests unless
    /// the edge is periodic.
    double u(int x, int y) const {
        const bool stored = x > 0 || periodic_x_;
        return 0.5 *
               ((stored ? film_.velocity_x.at(column(x - 1), y) : 0.0F) + film_.velocity_x.at(x, y));
    }
    double v(int x, int y) const {
        const bool stored = y > 0 || periodic_y_;
        return 0.5 * ((stored ? film_.velocity_y.at(x, row(y - 1)) : 0.0F) + film_.velocity_y.at(x, y));
    }

    /// |grad c|^2, with each component's square averaged over two faces.
    double support_slope2(int x, int y) const {
        const double here = c(x, y);
        const double left = here - c(column(x - 1), y), right = c(column(x + 1), y) - here;
        const double above = here - c(x, row(y - 1)), below = c(x, row(y + 1)) - here;
        return 0.5 * (left * left + right * right + above * above + below * below) /
               (film_.cell_mm * film_.cell_mm);
    }

    /// Slope of the film's surface at the face to the cell (dx, dy) further; where the film ends there,
    /// that with which it enters.
    double surface_slope(int x, int y, int dx, int dy, const StepConstants& step) const {
        const int to_x = dx == 0 ? x : column(x + dx), to_y = dy == 0 ? y : row(y + dy);
        const double rise = (eta(to_x, to_y) - eta(x, y)) / film_.cell_mm;
        if (!step.has_contact_angle() || h(to_x, to_y) >= h(x, y)) return rise;
        const FilmEnd<float> end = this->end(to_x, to_y, step);
        if (end.slope == 0.0F) return rise;
        const double ground = (c(to_x, to_y) - c(x, y)) / film_.cell_mm;
        return ground - end.slope * (dx != 0 ? end.normal_x : end.normal_y);
    }
    /// Area of the surface over that of the cell, within the film: the mean of its four quarters.
    double surface_area(int x, int y, const StepConstants& step) const {
        double sum = 0.0;
        for (const int dx : {-1, 1})
            for (const int dy : {-1, 1}) {
                const double slope_x = surface_slope(x, y, dx, 0, step);
                const double slope_y = surface_slope(x, y, 0, dy, step);
                sum += area_of(slope_x * slope_x + slope_y * slope_y, step.full_curvature);
            }
        return 0.25 * sum;
    }

    /// Of paint that does not move, mm.
    double negligible_mm() const { return 1e-4 * film_.cell_mm; }

    /// Of a wet cell.
    FilmSurface surface(int x, int y, const StepConstants& step) const {
        if (!step.has_contact_angle()) return {surface_area(x, y, step), 1.0};
        const FilmEnd<float> end = this->end(x, y, step);
        if (end.contact_slope == 0.0F) return {surface_area(x, y, step), 1.0};
        const double slope2 = end.mean_slope * end.mean_slope;
        return {end.covered * area_of(slope2, step.full_curvature), end.covered};
    }

    /// How the film ends in a cell.
    FilmEnd<float> end(int x, int y, const StepConstants& step) const {
        return film_end<float>(
            [&](int right, int below) {
                return static_cast<float>(h(neighbour(x + right, film_.shape.width, periodic_x_),
                                            neighbour(y + below, film_.shape.height, periodic_y_)));
            },
            step.tan_advancing, step);
    }

  private:
    static int neighbour(int index, int count, bool periodic) {
        if (periodic) return (index + count) % count;
        return std::clamp(index, 0, count - 1);
    }

    const FilmState& film_;
    bool periodic_x_, periodic_y_;
};

struct Sums {
    double moment_x = 0.0, moment_y = 0.0, max_h = 0.0;
    double kinetic = 0.0, gravity = 0.0, surface = 0.0;
    grid::Rect wet;
};

/// Calls visit(x, y) for the cells of all tiles that hold paint.
template <class Visit>
void for_each_painted_cell(const FilmState& film, const Visit& visit) {
    for (int tile = 0; tile < film.shape.tile_count(); ++tile) {
        if (film.thickness.is_background(tile)) continue;
        const grid::Rect cells = film.shape.tile_cells(tile);
        for (int y = cells.y0; y < cells.y1; ++y)
            for (int x = cells.x0; x < cells.x1; ++x)
                visit(x, y);
    }
}

}  // namespace

Measures measure(const FilmState& film, const Medium& medium, const Gravity& gravity,
                 const SolverOptions& options) {
    const Cells cells(film, options);
    const double cos_angle = std::cos(core::radians(medium.advancing_angle_deg));
    const StepConstants step = make_constants(medium, gravity, options, film.cell_mm);
    Sums sums;
    for_each_painted_cell(film, [&](int x, int y) {
        const double h = cells.h(x, y);
        if (h == 0.0) return;
        sums.moment_x += h * (x + 0.5);
        sums.moment_y += h * (y + 0.5);
        sums.max_h = std::max(sums.max_h, h);
        sums.gravity += h * (cells.c(x, y) + 0.5 * h);
        if (h <= cells.negligible_mm()) return;
        const double u = cells.u(x, y), v = cells.v(x, y);
        sums.kinetic += h * (u * u + v * v);
        const double ground = area_of(cells.support_slope2(x, y), options.full_curvature);
        const FilmSurface surface = cells.surface(x, y, step);
        sums.surface += surface.area - cos_angle * ground * surface.covered;
        sums.wet = grid::bounding_box(sums.wet, {x, y, x + 1, y + 1});
    });

    // Whole quanta, so that equal volumes are equal numbers whatever the order of the cells.
    const double volume = static_cast<double>(totals(film).thickness) * kThicknessQuantum_mm;
    const double cell_mm = film.cell_mm, cell_area_mm2 = cell_mm * cell_mm;
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    Measures measures;
    measures.volume_mm3 = volume * cell_area_mm2;
    measures.max_h_mm = sums.max_h;
    measures.centroid = {kNone, kNone};
    if (volume > 0.0)
        measures.centroid = {cell_mm * sums.moment_x / volume, cell_mm * sums.moment_y / volume};
    measures.wet_box = {kNone, kNone, kNone, kNone};
    if (!sums.wet.empty())
        measures.wet_box = {cell_mm * sums.wet.x0, cell_mm * sums.wet.y0, cell_mm * sums.wet.x1,
                            cell_mm * sums.wet.y1};
    const double mass_unit = medium.density_kg_m3 * cell_area_mm2 * kJoule;
    measures.kinetic_energy_J = 0.5 * mass_unit * sums.kinetic;
    measures.gravity_energy_J = mass_unit * gravity.normal_mm_s2 * sums.gravity;
    measures.surface_energy_J = medium.surface_tension_N_m * cell_area_mm2 * 1e-6 * sums.surface;
    return measures;
}

std::vector<ProfilePoint> profile_along(Axis axis, double at_mm, const FilmState& film,
                                        const SolverOptions& options) {
    const Cells cells(film, options);
    const bool along_x = axis == Axis::X;
    const int count = along_x ? film.shape.width : film.shape.height;
    const int lines = along_x ? film.shape.height : film.shape.width;
    const double line = std::clamp(at_mm / film.cell_mm - 0.5, 0.0, lines - 1.0);
    const int before = std::min(static_cast<int>(line), std::max(lines - 2, 0));
    const int behind = std::min(before + 1, lines - 1);
    const double share = line - before;
    std::vector<ProfilePoint> points;
    for (int i = 0; i < count; ++i) {
        const auto blend = [&](double (Cells::*value)(int, int) const) {
            const auto on = [&](int j) { return along_x ? (cells.*value)(i, j) : (cells.*value)(j, i); };
            return (1.0 - share) * on(before) + share * on(behind);
        };
        points.push_back({(i + 0.5) * film.cell_mm, blend(&Cells::c), blend(&Cells::h), blend(&Cells::u),
                          blend(&Cells::v)});
    }
    return points;
}

}  // namespace pastoso::film
