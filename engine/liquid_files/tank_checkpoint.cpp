#include "liquid_files/tank_checkpoint.hpp"

#include "core/check.hpp"
#include "liquid_files/box_values.hpp"
#include "tank/tank_scene.hpp"

#include <cmath>
#include <span>

namespace pastoso::liquid_files {
namespace {

using grid::BoxField;
using grid::BoxShape;
using tank::LevelState;
using tank::Particle;
using tank::TankState;

// What a state has besides velocity and pressure.
constexpr std::uint32_t kHasLevel = 1, kHasSurfaceParticles = 2;
constexpr std::uint64_t kMostParticles = std::uint64_t{1} << 29;  ///< four times a full tank's
constexpr std::uint64_t kMostRows = 1'000'001;

struct Facts {
    double time_s = 0.0;
    std::int64_t steps = 0;
    double brought_m3 = 0.0;
    std::int32_t nx = 0, ny = 0, nz = 0;
    float cell_m = 0.0F;
    std::uint64_t particle_count = 0, surface_particle_count = 0, row_count = 0;
    std::uint32_t particles_made = 0, seedings = 0;
    double due_m3 = 0.0;
    std::int64_t level_steps = 0;
    float fastest_m_s = 0.0F;
    std::uint32_t unused = 0;

    BoxShape shape() const { return {nx, ny, nz, cell_m}; }
};
static_assert(sizeof(Facts) == 96);
static_assert(sizeof(Particle) == 28 && sizeof(glm::vec3) == 12);  // as they are written

/// Series; particles; velocity x, y, z; pressure; level, milk; places and radii of the
/// surface's particles.
files::PartFileKind kind() {
    constexpr int kMost = tank::kMaxTankCells;
    constexpr std::size_t kFields = 6;
    const std::size_t samples = sample_count({kMost, kMost, kMost, 0.0F}, BoxSamples::All);
    return {
        .what = core::Pattern<0>("checkpoint of a tank"),
        .mark = {'T', 'a', 'n', 'k', 'S', 't', 'a', 't'},
        .version = kTankCheckpointVersion,
        .oldest = kTankCheckpointVersion,
        .fact_bytes = sizeof(Facts),
        .parts = 4 + kFields,
        .most_bytes = kFields * packing::most_packed_bytes(sizeof(float) * samples) +
                      packing::most_packed_bytes(sizeof(TankSeriesRow) * std::size_t{kMostRows}) +
                      packing::most_packed_bytes(2 * sizeof(Particle) * std::size_t{kMostParticles})};
}

std::uint32_t flags_of(const TankState& state) {
    if (!state.liquid.level) return 0;
    return kHasLevel | (state.liquid.level->particles ? kHasSurfaceParticles : 0);
}

Facts facts_of(const TankCheckpoint& checkpoint) {
    const TankState& state = checkpoint.state;
    const BoxShape& shape = state.liquid.pressure.shape();
    Facts facts;
    facts.time_s = state.time_s;
    facts.steps = state.steps;
    facts.brought_m3 = state.brought_m3;
    facts.nx = shape.nx;
    facts.ny = shape.ny;
    facts.nz = shape.nz;
    facts.cell_m = shape.cell_m;
    facts.particle_count = state.liquid.particles.size();
    facts.row_count = checkpoint.series.size();
    facts.particles_made = state.liquid.particles_made;
    facts.fastest_m_s = state.liquid.fastest_m_s;
    if (const auto& level = state.liquid.level) {
        facts.due_m3 = level->due_m3;
        facts.level_steps = level->steps;
        if (level->particles) {
            facts.seedings = level->particles->seedings;
            facts.surface_particle_count = level->particles->positions_m.size();
        }
    }
    return facts;
}

/// What is not looked at here, LiquidTank::set_state() does.
bool is_allowed(const Facts& facts, std::uint32_t flags) {
    for (const std::int32_t side : {facts.nx, facts.ny, facts.nz})
        if (side < tank::kMinTankCells || side > tank::kMaxTankCells) return false;
    constexpr std::int64_t kMostSteps = std::int64_t{1} << 30;
    for (const std::int64_t count : {facts.steps, facts.level_steps})
        if (count < 0 || count > kMostSteps) return false;
    for (const double number : {facts.time_s, facts.brought_m3, facts.due_m3})
        if (!std::isfinite(number)) return false;
    return facts.cell_m > 0.0F && std::isfinite(facts.cell_m) && facts.fastest_m_s >= 0.0F &&
           std::isfinite(facts.fastest_m_s) && facts.particle_count <= kMostParticles &&
           facts.surface_particle_count <= kMostParticles && facts.row_count <= kMostRows &&
           (flags == 0 || flags == kHasLevel || flags == (kHasLevel | kHasSurfaceParticles));
}

void add_level(files::PartFileWriter& file, const LevelState* level) {
    if (level == nullptr) {
        for (int part = 0; part < 4; ++part)
            file.add_nothing();
        return;
    }
    for (const BoxField* field : {&level->level_m, &level->milk})
        add_field(file, *field, BoxSamples::All);
    if (level->particles) {
        file.add(level->particles->positions_m);
        file.add(level->particles->signed_radii_m);
    } else {
        file.add_nothing();
        file.add_nothing();
    }
}

template <class Value>
std::vector<Value> next_numbers(files::PartFileReader& file, std::uint64_t count) {
    std::vector<Value> values = file.next<Value>(count);
    const std::span numbers(reinterpret_cast<const float*>(values.data()),
                            values.size() * sizeof(Value) / sizeof(float));
    for (const float number : numbers)
        if (!std::isfinite(number)) file.refuse("holds a particle whose numbers are not finite.");
    return values;
}

LevelState next_level(files::PartFileReader& file, const Facts& facts) {
    LevelState level;
    for (BoxField* field : {&level.level_m, &level.milk})
        *field = next_field(file, facts.shape(), BoxSamples::All);
    level.due_m3 = facts.due_m3;
    level.steps = static_cast<int>(facts.level_steps);
    if ((file.flags() & kHasSurfaceParticles) != 0) {
        level.particles = tank::SurfaceParticleState{facts.seedings, {}, {}};
        level.particles->positions_m = next_numbers<glm::vec3>(file, facts.surface_particle_count);
        level.particles->signed_radii_m = next_numbers<float>(file, facts.surface_particle_count);
    }
    return level;
}

}  // namespace

std::filesystem::path tank_checkpoint_path(const std::filesystem::path& folder) {
    return folder / "checkpoint.tank";
}

void write_tank_checkpoint(const std::filesystem::path& path, const TankCheckpoint& checkpoint,
                           std::uint64_t scene_hash) {
    const tank::LiquidState& liquid = checkpoint.state.liquid;
    const Facts facts = facts_of(checkpoint);
    const std::uint32_t flags = flags_of(checkpoint.state);
    PASTOSO_CHECK(is_allowed(facts, flags));
    files::PartFileWriter file(kind());
    file.add(checkpoint.series);
    file.add(liquid.particles);
    for (const BoxField* field :
         {&liquid.velocity.x, &liquid.velocity.y, &liquid.velocity.z, &liquid.pressure})
        add_field(file, *field, BoxSamples::All);
    add_level(file, liquid.level ? &*liquid.level : nullptr);
    file.write(path, scene_hash, flags, facts);
}

TankCheckpoint read_tank_checkpoint(const std::filesystem::path& path, std::uint64_t scene_hash) {
    files::PartFileReader file(path, kind(), scene_hash);
    const auto facts = file.facts<Facts>();
    if (!is_allowed(facts, file.flags())) file.refuse("holds sizes or numbers that no tank has.");
    TankCheckpoint checkpoint;
    checkpoint.series = file.next<TankSeriesRow>(facts.row_count);
    TankState& state = checkpoint.state;
    state.time_s = facts.time_s;
    state.steps = static_cast<int>(facts.steps);
    state.brought_m3 = facts.brought_m3;
    tank::LiquidState& liquid = state.liquid;
    liquid.fastest_m_s = facts.fastest_m_s;
    liquid.particles_made = facts.particles_made;
    liquid.particles = next_numbers<Particle>(file, facts.particle_count);
    for (BoxField* field :
         {&liquid.velocity.x, &liquid.velocity.y, &liquid.velocity.z, &liquid.pressure})
        *field = next_field(file, facts.shape(), BoxSamples::All);
    if ((file.flags() & kHasLevel) != 0) liquid.level = next_level(file, facts);
    return checkpoint;
}

}  // namespace pastoso::liquid_files
