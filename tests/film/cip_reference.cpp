#include "film/cip_reference.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace pastoso::film::test {
namespace {

struct CubicPoint {
    double value, slope_a, slope_b;
};

/// One corner of the upwind cell, derivatives per cell crossed.
struct Corner {
    double f, p, q;
};

/// The cubic in (a, b) with the values at all corners of the unit square and the derivatives p = df/da,
/// q = df/db at all but the far one.
CubicPoint cubic_through(const Corner& here, const Corner& along_a, const Corner& along_b, double f_far,
                         double a, double b) {
    const double rise_a = along_a.f - here.f, rise_b = along_b.f - here.f;
    const double c20 = 3 * rise_a - 2 * here.p - along_a.p, c30 = here.p + along_a.p - 2 * rise_a;
    const double c02 = 3 * rise_b - 2 * here.q - along_b.q, c03 = here.q + along_b.q - 2 * rise_b;
    const double twist = f_far - along_a.f - along_b.f + here.f;
    const double c21 = twist - (along_b.p - here.p), c12 = twist - (along_a.q - here.q);
    const double c11 = twist - c21 - c12;
    return {here.f + a * (here.p + a * (c20 + a * c30)) + b * (here.q + b * (c02 + b * c03)) +
                a * b * (c11 + a * c21 + b * c12),
            here.p + a * (2 * c20 + 3 * a * c30) + b * (c11 + 2 * a * c21 + b * c12),
            here.q + b * (2 * c02 + 3 * b * c03) + a * (c11 + a * c21 + 2 * b * c12)};
}

double difference_x(const CipGrid& grid, const std::vector<double>& f, int x, int y) {
    return (f[grid.index(x + 1, y)] - f[grid.index(x - 1, y)]) / (2 * grid.spacing);
}
double difference_y(const CipGrid& grid, const std::vector<double>& f, int x, int y) {
    return (f[grid.index(x, y + 1)] - f[grid.index(x, y - 1)]) / (2 * grid.spacing);
}

double laplacian(const CipGrid& grid, const std::vector<double>& f, int x, int y) {
    return (f[grid.index(x + 1, y)] + f[grid.index(x - 1, y)] + f[grid.index(x, y + 1)] +
            f[grid.index(x, y - 1)] - 4 * f[grid.index(x, y)]) /
           (grid.spacing * grid.spacing);
}

struct SurfaceShape {
    double slope_x, slope_y;
    double curvature;  ///< -div(grad(s) / sqrt(1 + |grad(s)|^2)), positive on a crest
    double normal_z;   ///< 1 / sqrt(1 + |grad(s)|^2)
};

SurfaceShape shape_of(const CipGrid& grid, const std::vector<double>& s, int x, int y) {
    const double d = grid.spacing;
    const double sx = difference_x(grid, s, x, y), sy = difference_y(grid, s, x, y);
    const double middle = s[grid.index(x, y)];
    const double sxx = (s[grid.index(x + 1, y)] - 2 * middle + s[grid.index(x - 1, y)]) / (d * d);
    const double syy = (s[grid.index(x, y + 1)] - 2 * middle + s[grid.index(x, y - 1)]) / (d * d);
    const double sxy = (s[grid.index(x + 1, y + 1)] - s[grid.index(x - 1, y + 1)] -
                        s[grid.index(x + 1, y - 1)] + s[grid.index(x - 1, y - 1)]) /
                       (4 * d * d);
    const double w = 1 + sx * sx + sy * sy;
    return {sx, sy,
            -((1 + sy * sy) * sxx - 2 * sx * sy * sxy + (1 + sx * sx) * syy) / (w * std::sqrt(w)),
            1 / std::sqrt(w)};
}

}  // namespace

int CipGrid::index(int x, int y) const {
    const int column = x < 0 ? x + width : x >= width ? x - width : x;
    const int row = y < 0 ? y + height : y >= height ? y - height : y;
    return row * width + column;
}

void set_slopes(const CipGrid& grid, CipField& field) {
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x) {
            field.slope_x[grid.index(x, y)] = difference_x(grid, field.value, x, y);
            field.slope_y[grid.index(x, y)] = difference_y(grid, field.value, x, y);
        }
}

CipField advected(const CipGrid& grid, const CipField& field, const std::vector<double>& velocity_x,
                  const std::vector<double>& velocity_y, double dt) {
    CipField result(grid.count());
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x) {
            const int i = grid.index(x, y);
            const int back_x = velocity_x[i] > 0 ? -1 : 1, back_y = velocity_y[i] > 0 ? -1 : 1;
            const double cell_x = back_x * grid.spacing, cell_y = back_y * grid.spacing;
            const auto corner = [&](int k) {
                return Corner{field.value[k], field.slope_x[k] * cell_x, field.slope_y[k] * cell_y};
            };
            const CubicPoint point = cubic_through(
                corner(i), corner(grid.index(x + back_x, y)), corner(grid.index(x, y + back_y)),
                field.value[grid.index(x + back_x, y + back_y)], -velocity_x[i] * dt / cell_x,
                -velocity_y[i] * dt / cell_y);
            result.value[i] = point.value;
            result.slope_x[i] = point.slope_a / cell_x;
            result.slope_y[i] = point.slope_b / cell_y;
        }
    return result;
}

CipReference::CipReference(const CipGrid& grid, const CipPaint& paint)
    : grid_(grid),
      paint_(paint),
      film_(grid.count()),
      velocity_x_(grid.count()),
      velocity_y_(grid.count()) {
    for (auto* plane : {&support_, &pressure_, &tension_x_, &tension_y_, &tension_z_, &film_change_,
                        &velocity_x_change_, &velocity_y_change_})
        plane->assign(grid.count(), 0.0);
}

void CipReference::set_film(const std::function<double(int, int)>& thickness) {
    for (int y = 0; y < grid_.height; ++y)
        for (int x = 0; x < grid_.width; ++x)
            film_.value[grid_.index(x, y)] = thickness(x, y);
    set_slopes(grid_, film_);
    first_volume_ = volume();
}

void CipReference::set_support(const std::function<double(int, int)>& height) {
    for (int y = 0; y < grid_.height; ++y)
        for (int x = 0; x < grid_.width; ++x)
            support_[grid_.index(x, y)] = height(x, y);
}

double CipReference::volume() const {
    return std::accumulate(film_.value.begin(), film_.value.end(), 0.0);
}

/// p/rho = g (h + c) + sigma/rho kappa n_z, and T/rho = sigma/rho kappa n with n inward (uphill).
void CipReference::find_pressure() {
    std::vector<double> surface(grid_.count());
    for (int i = 0; i < grid_.count(); ++i)
        surface[i] = film_.value[i] + support_[i];
    for (int y = 0; y < grid_.height; ++y)
        for (int x = 0; x < grid_.width; ++x) {
            const int i = grid_.index(x, y);
            const SurfaceShape shape = shape_of(grid_, surface, x, y);
            const double traction = paint_.tension * shape.curvature * shape.normal_z;
            pressure_[i] = paint_.gravity * surface[i] + traction;
            tension_x_[i] = traction * shape.slope_x;
            tension_y_[i] = traction * shape.slope_y;
            tension_z_[i] = -traction;
        }
}

/// k_d = 6/(3 alpha - 1), linear in the cosine between T and u.
double CipReference::drag_coefficient(int i) const {
    const double along = tension_x_[i] * velocity_x_.value[i] + tension_y_[i] * velocity_y_.value[i];
    const double norm = std::hypot(tension_x_[i], tension_y_[i], tension_z_[i]) *
                        std::hypot(velocity_x_.value[i], velocity_y_.value[i]);
    const double cosine = norm > 1e-12 ? along / norm : 0.0;
    const double against = 6 / (3 * paint_.alpha_min - 1), with = 6 / (3 * paint_.alpha_max - 1);
    return against + (with - against) * (1 + cosine) / 2;
}

void CipReference::change_wet_velocity(int x, int y, double dt) {
    const int i = grid_.index(x, y);
    const double h = film_.value[i];
    const double kept = 1 / (1 + dt * drag_coefficient(i) * paint_.viscosity / (h * h));
    const double pull = paint_.horizontal_tension / h;
    const double ax = paint_.force_x - difference_x(grid_, pressure_, x, y) + pull * tension_x_[i] +
                      paint_.viscosity * laplacian(grid_, velocity_x_.value, x, y);
    const double ay = paint_.force_y - difference_y(grid_, pressure_, x, y) + pull * tension_y_[i] +
                      paint_.viscosity * laplacian(grid_, velocity_y_.value, x, y);
    const double u = velocity_x_.value[i], v = velocity_y_.value[i];
    velocity_x_change_[i] = kept * (u + dt * ax) - u;
    velocity_y_change_[i] = kept * (v + dt * ay) - v;
}

void CipReference::extrapolate_velocity(int x, int y) {
    const std::array<int, 4> neighbours{grid_.index(x + 1, y), grid_.index(x - 1, y),
                                        grid_.index(x, y + 1), grid_.index(x, y - 1)};
    double u = 0, v = 0;
    int wet = 0;
    for (const int k : neighbours) {
        if (film_.value[k] <= paint_.dry_thickness) continue;
        u += velocity_x_.value[k] + velocity_x_change_[k];
        v += velocity_y_.value[k] + velocity_y_change_[k];
        ++wet;
    }
    const int i = grid_.index(x, y);
    velocity_x_change_[i] = (wet > 0 ? u / wet : 0.0) - velocity_x_.value[i];
    velocity_y_change_[i] = (wet > 0 ? v / wet : 0.0) - velocity_y_.value[i];
}

void CipReference::find_changes(double dt) {
    const auto is_wet = [&](int x, int y) {
        return film_.value[grid_.index(x, y)] > paint_.dry_thickness;
    };
    for (int y = 0; y < grid_.height; ++y)
        for (int x = 0; x < grid_.width; ++x) {
            film_change_[grid_.index(x, y)] = -dt * film_.value[grid_.index(x, y)] *
                                              (difference_x(grid_, velocity_x_.value, x, y) +
                                               difference_y(grid_, velocity_y_.value, x, y));
            if (is_wet(x, y)) change_wet_velocity(x, y, dt);
        }
    for (int y = 0; y < grid_.height; ++y)
        for (int x = 0; x < grid_.width; ++x)
            if (!is_wet(x, y)) extrapolate_velocity(x, y);
}

/// f += change, and the derivatives by d(f_x)/dt = change_x - u_x f_x - v_x f_y, likewise f_y.
void CipReference::apply(const std::vector<double>& change, double dt, CipField& field) const {
    for (int y = 0; y < grid_.height; ++y)
        for (int x = 0; x < grid_.width; ++x) {
            const int i = grid_.index(x, y);
            const double fx = field.slope_x[i], fy = field.slope_y[i];
            const auto& u = velocity_x_.value;
            const auto& v = velocity_y_.value;
            field.value[i] += change[i];
            field.slope_x[i] +=
                difference_x(grid_, change, x, y) -
                dt * (difference_x(grid_, u, x, y) * fx + difference_x(grid_, v, x, y) * fy);
            field.slope_y[i] +=
                difference_y(grid_, change, x, y) -
                dt * (difference_y(grid_, u, x, y) * fx + difference_y(grid_, v, x, y) * fy);
        }
}

void CipReference::cut_negative() {
    for (int i = 0; i < grid_.count(); ++i) {
        if (film_.value[i] >= 0) continue;
        cut_ -= film_.value[i];
        film_.value[i] = film_.slope_x[i] = film_.slope_y[i] = 0;
    }
}

void CipReference::restore_volume() {
    const double now = volume();
    if (now <= 0) return;
    const double scale = first_volume_ / now;
    for (int i = 0; i < grid_.count(); ++i) {
        film_.value[i] *= scale;
        film_.slope_x[i] *= scale;
        film_.slope_y[i] *= scale;
    }
}

void CipReference::step(double dt) {
    find_pressure();
    find_changes(dt);
    CipField film = film_, velocity_x = velocity_x_, velocity_y = velocity_y_;
    apply(film_change_, dt, film);
    apply(velocity_x_change_, dt, velocity_x);
    apply(velocity_y_change_, dt, velocity_y);
    film_ = advected(grid_, film, velocity_x.value, velocity_y.value, dt);
    velocity_x_ = advected(grid_, velocity_x, velocity_x.value, velocity_y.value, dt);
    velocity_y_ = advected(grid_, velocity_y, velocity_x.value, velocity_y.value, dt);
    cut_negative();
    if (paint_.keep_volume) restore_volume();
}

}  // namespace pastoso::film::test
