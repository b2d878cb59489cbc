#include "liquid/classic/classic_tea.hpp"

#include "core/random.hpp"
#include "core/value_range.hpp"
#include "liquid/surface/metaballs.hpp"
#include "liquid/tea/tea_settings.hpp"

#include <cmath>

namespace pastoso::liquid {
namespace {

using core::check_range;

constexpr int kMinCells = 4, kMaxCells = 256;

std::variant<SourceLattice, PeriodicFlow> flow_of(const ClassicSettings& settings) {
    check_classic(settings);
    const int cells = settings.cells;
    const grid::BoxShape shape{cells, cells, cells, settings.box_m / static_cast<float>(cells)};
    if (settings.solver == ClassicSolver::Source) return SourceLattice(shape);
    FlowParameters parameters;
    parameters.viscosity_m2_s = settings.viscosity_m2_s;
    return PeriodicFlow(shape, parameters);
}

/// Adds a force to the samples of a field that lie at `offset` in their cells.
template <class Force>
void add_force(grid::BoxField& field, const glm::vec3& offset, const Force& force) {
    const grid::BoxShape& shape = field.shape();
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i)
                field.at(i, j, k) += force(shape.cell_m * (glm::vec3(i, j, k) + offset));
}

/// The voxel that a coordinate lies in, and how far along it, in voxels between lattice points.
struct InVoxel {
    int voxel;
    double part;
};

InVoxel in_voxel(float position_m, int cells, float box_m) {
    const double at = static_cast<double>(position_m) / static_cast<double>(box_m) * cells - 0.5;
    const double whole = std::floor(at);
    return {(static_cast<int>(whole) + cells) % cells, at - whole};
}

}  // namespace

void check_classic(const ClassicSettings& settings) {
    check_range("cells", settings.cells, kMinCells, kMaxCells);
    check_range("particles", settings.particles, 1, kMaxParcels);
    check_range("box_m", static_cast<double>(settings.box_m), 0.01, 10.0);
    check_range("step_s", static_cast<double>(settings.step_s), 1e-4, 0.2);
    check_range("viscosity_m2_s", static_cast<double>(settings.viscosity_m2_s), 0.0, 1.0);
    check_range("swirl_rad_s2", static_cast<double>(settings.swirl_rad_s2), -1e3, 1e3);
    check_range("push_m_s2", static_cast<double>(settings.push_m_s2), -1e3, 1e3);
}

ClassicTea::ClassicTea(const ClassicSettings& settings) : settings_(settings), flow_(flow_of(settings)) {
    const auto drawn = [&](std::uint32_t particle, std::uint32_t axis) {
        return settings.box_m * core::uniform_noise(3 * particle + axis, settings.seed);
    };
    for (int i = 0; i < settings.particles; ++i) {
        const auto particle = static_cast<std::uint32_t>(i);
        particles_m_.emplace_back(drawn(particle, 0), drawn(particle, 1), drawn(particle, 2));
    }
}

std::vector<Parcel> ClassicTea::parcels() const {
    std::vector<Parcel> parcels;
    for (const glm::vec3& position_m : particles_m_)
        parcels.push_back({position_m, Metaballs{}.unit_volume_m3, 0.0F, -1});
    return parcels;
}

void ClassicTea::step(core::ThreadPool& pool) {
    std::visit([&](auto& flow) { step_on(flow, pool); }, flow_);
    ++steps_;
}

/// dt (swirl e_z x (x - axis) - push e_z).
glm::vec3 ClassicTea::force_over_step(const glm::vec3& point_m) const {
    const glm::vec2 from_axis_m = glm::vec2(point_m) - settings_.axis_m;
    return settings_.step_s * glm::vec3(-settings_.swirl_rad_s2 * from_axis_m.y,
                                        settings_.swirl_rad_s2 * from_axis_m.x, -settings_.push_m_s2);
}

void ClassicTea::step_on(SourceLattice& flow, core::ThreadPool& pool) {
    for (const int axis : kAxes)
        add_force(flow.along(axis), glm::vec3(0.5F),
                  [&](const glm::vec3& point_m) { return force_over_step(point_m)[axis]; });
    flow.step(settings_.step_s, settings_.viscosity_m2_s, pool);
    for (glm::vec3& particle_m : particles_m_)
        particle_m =
            wrapped(particle_m + settings_.step_s * flow.velocity_at(particle_m), settings_.box_m);
}

void ClassicTea::step_on(PeriodicFlow& flow, core::ThreadPool& pool) {
    for (const int axis : kAxes)
        add_force(flow.velocity().along(axis), offset_cells(face_across(axis)),
                  [&](const glm::vec3& point_m) { return force_over_step(point_m)[axis]; });
    flow.diffuse_and_project(settings_.step_s, pool);
    flow.carry(particles_m_, settings_.step_s, pool);
    flow.advect_velocity(settings_.step_s, pool);
}

PileUp pile_up(std::span<const glm::vec3> points_m, int cells, float box_m) {
    constexpr double kNear = 0.1;
    std::vector<int> counts(static_cast<std::size_t>(cells * cells * cells));
    int near = 0;
    for (const glm::vec3& point_m : points_m) {
        std::size_t voxel = 0;
        for (const int axis : kAxes) {
            const InVoxel in = in_voxel(point_m[2 - axis], cells, box_m);
            voxel = voxel * static_cast<std::size_t>(cells) + static_cast<std::size_t>(in.voxel);
            near += in.part < kNear || in.part > 1.0 - kNear ? 1 : 0;
        }
        ++counts[voxel];
    }
    const auto number = static_cast<double>(points_m.size());
    const double mean = number / static_cast<double>(counts.size());
    double squares = 0.0;
    for (const int count : counts)
        squares += (count - mean) * (count - mean);
    return {near / (3.0 * number) / (2.0 * kNear), squares / static_cast<double>(counts.size()) / mean};
}

}  // namespace pastoso::liquid
