#include "tank/level_cases.hpp"

#include "tank/extension.hpp"
#include "tank/liquid_volume.hpp"

#include <cmath>
#include <ctime>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>

namespace pastoso::tank::cases {
namespace {

constexpr double kPi = std::numbers::pi;
struct Course {
    double duration_s, fastest_m_s;
    bool returns;  ///< the velocity's factor is the cosine of half a turn
};
Course course(Flow flow) {
    if (flow == Flow::Rotation) return {2.0 * kPi, 0.5, false};
    return {flow == Flow::Enright ? 3.0 : 1.0, 2.0, true};
}

grid::BoxField first_distance(Flow flow, const grid::BoxShape& shape) {
    if (flow == Flow::Tank) return sampled(shape, [](const glm::vec3& p) { return p.z - 0.4F; });
    return sampled(shape, sphere(glm::vec3(0.35F), 0.15F));
}

constexpr float kUnknown_m_s = 1e3F;

/// Forgets the velocity of faces between two cells of air and continues it from the others.
void continue_into_air(const grid::BoxField& phi, VelocityExtension& extension, float reach_cells,
                       liquid::VelocityField& velocity, core::ThreadPool& pool) {
    const grid::BoxShape& shape = phi.shape();
    liquid::VelocityField known(shape);
    for (const int axis : liquid::kAxes) {
        const std::ptrdiff_t back = liquid::stride(shape, axis);
        const auto [nx, ny, nz] = liquid::sample_counts(shape, liquid::face_across(axis));
        for (int k = 0; k < nz; ++k)
            for (int j = 0; j < ny; ++j)
                for (int i = 0; i < nx; ++i) {
                    const float* here = phi.row(j, k) + i;
                    const bool is_known = *here < 0.0F || here[-back] < 0.0F;
                    known.along(axis).at(i, j, k) = is_known ? 1.0F : 0.0F;
                    if (!is_known) velocity.along(axis).at(i, j, k) = kUnknown_m_s;
                }
    }
    extension.extend(phi, known, reach_cells, velocity, pool);
}

template <class Value>
void fill(grid::BoxField& field, liquid::Location location, const Value& value) {
    const grid::BoxShape& shape = field.shape();
    const auto [nx, ny, nz] = liquid::sample_counts(shape, location);
    constexpr int kGhosts = grid::kBoxGhosts;
    for (int k = -kGhosts; k < nz + kGhosts; ++k)
        for (int j = -kGhosts; j < ny + kGhosts; ++j)
            for (int i = -kGhosts; i < nx + kGhosts; ++i)
                field.at(i, j, k) =
                    value((glm::vec3(i, j, k) + liquid::offset_cells(location)) * shape.cell_m);
}

/// What is separable of Enright's field: sin^2(pi a), sin(2 pi a).
struct Sines {
    double square, twice;
};
Sines sines(float a) {
    const double s = std::sin(kPi * static_cast<double>(a));
    return {s * s, std::sin(2.0 * kPi * static_cast<double>(a))};
}

glm::vec3 velocity_at_start(Flow flow, const glm::vec3& p) {
    if (flow == Flow::Rotation) return {0.5F - p.y, p.x - 0.5F, 0.0F};
    const Sines x = sines(p.x), y = sines(p.y), z = sines(p.z);
    return {2.0 * x.square * y.twice * z.twice, -x.twice * y.square * z.twice,
            -x.twice * y.twice * z.square};
}

double shape_error(const grid::BoxField& a, const grid::BoxField& b) {
    const grid::BoxShape& shape = a.shape();
    double between = 0.0, sum = 0.0;
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i) {
                const float in_a = std::clamp(0.5F - a.at(i, j, k) / shape.cell_m, 0.0F, 1.0F),
                            in_b = std::clamp(0.5F - b.at(i, j, k) / shape.cell_m, 0.0F, 1.0F);
                between += static_cast<double>(std::abs(in_a - in_b));
                sum += static_cast<double>(in_a);
            }
    return between / sum;
}

}  // namespace

grid::BoxShape unit_box(int cells) {
    return {cells, cells, cells, 1.0F / static_cast<float>(cells)};
}

grid::BoxField sampled(const grid::BoxShape& shape, const Distance& value) {
    grid::BoxField field(shape);
    fill(field, liquid::Location::Cell, value);
    return field;
}

Distance sphere(const glm::vec3& centre_m, float radius_m) {
    return [=](const glm::vec3& p) { return glm::length(p - centre_m) - radius_m; };
}

liquid::VelocityField velocity_at_start(Flow flow, const grid::BoxShape& shape) {
    liquid::VelocityField velocity(shape);
    for (const int axis : liquid::kAxes)
        fill(velocity.along(axis), liquid::face_across(axis),
             [&](const glm::vec3& p) { return velocity_at_start(flow, p)[axis]; });
    return velocity;
}

liquid::VelocityField scaled(const liquid::VelocityField& velocity, float factor) {
    liquid::VelocityField result = velocity;
    for (const int axis : liquid::kAxes)
        for (float& value : result.along(axis).values())
            value *= factor;
    return result;
}

Followed follow(Flow flow, int cells, const Following& how, core::ThreadPool& pool) {
    const grid::BoxShape shape = unit_box(cells);
    Followed result{first_distance(flow, shape), 0.0, 0.0, 0, 0, 0, 0.0};
    grid::BoxField& phi = result.phi;
    const bool reinitialises = how.steps_per_reinitialisation > 0;
    // Without reinitialisation the whole box is the band.
    const float reach_cells = reinitialises ? how.reach_cells : 4.0F * static_cast<float>(cells);
    Reinitialisation reinitialisation(shape);
    if (reinitialises) reinitialisation.apply(phi, reach_cells, how.kept_within_cells, pool);
    const grid::BoxField first = phi;
    const double volume_m3 = liquid_volume_m3(phi, pool);
    LevelSetAdvection advection(shape);
    std::optional<SurfaceParticles> particles;
    if (how.particles_per_cell > 0) {
        particles.emplace(shape, SurfaceParticleSettings{.per_cell = how.particles_per_cell});
        particles->seed(phi, pool);
    }
    const Course way = course(flow);
    result.steps = static_cast<int>(std::ceil(way.duration_s * way.fastest_m_s * cells / how.courant));
    const double dt_s = way.duration_s / result.steps;
    VelocityExtension extension(shape);
    const liquid::VelocityField start = velocity_at_start(flow, shape);
    for (int step = 0; step < result.steps; ++step) {
        const double turn = way.returns ? kPi * (step + 0.5) / result.steps : 0.0;
        liquid::VelocityField velocity = scaled(start, static_cast<float>(std::cos(turn)));
        const std::clock_t begin = std::clock();
        if (flow == Flow::Tank) continue_into_air(phi, extension, reach_cells, velocity, pool);
        advection.advect(phi, velocity, static_cast<float>(dt_s), reach_cells, how.scheme, pool,
                         how.interpolation);
        if (particles) {
            particles->carry(velocity, static_cast<float>(dt_s), pool);
            result.escaped = particles->mend(phi, pool);
        }
        const auto is_turn = [&](int steps) { return steps > 0 && step % steps == steps - 1; };
        if (is_turn(how.steps_per_reinitialisation))
            reinitialisation.apply(phi, reach_cells, how.kept_within_cells, pool);
        if (particles && is_turn(kStepsPerReinitialisation)) particles->adjust_radii(phi, pool);
        if (particles && is_turn(how.steps_per_reseeding)) particles->reseed(phi, pool);
        result.seconds += static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    }
    if (particles) result.particles = particles->positions_m().size();
    result.volume_error = liquid_volume_m3(phi, pool) / volume_m3 - 1.0;
    result.shape_error = shape_error(first, phi);
    return result;
}

}  // namespace pastoso::tank::cases
