#include "liquid_files/tea_checkpoint.hpp"

#include "core/check.hpp"
#include "liquid/tea/tea_settings.hpp"
#include "liquid_files/box_values.hpp"
#include "liquid_files/parcel_records.hpp"

#include <array>
#include <cmath>

namespace pastoso::liquid_files {
namespace {

using grid::BoxField;
using grid::BoxShape;
using liquid::FlowState;
using liquid::MilkJug;
using liquid::TeaState;

constexpr std::size_t kMostSpareCells = 2;

struct StreamFacts {
    double seconds = 0.0;
    std::int64_t parcels = 0;
};

/// Of the head. Its flags are 1 where a hand pours, else 0.
struct Facts {
    std::int64_t step = 0;
    std::int32_t nx = 0, ny = 0, nz = 0;
    float cell_m = 0.0F;
    std::uint64_t parcel_count = 0;
    std::uint64_t spare_cells = 0;
    double next_ball_s = 0.0;
    std::int32_t balls = 0;
    std::uint32_t ball_draws = 0;
    StreamFacts recipe, hand;
    float hand_x_m = 0.0F, hand_y_m = 0.0F;
    double poured_m3 = 0.0;
    std::uint64_t jug_places = 0;
    // Versions 1 and 2 end here: a recipe's stream ends as the scene says, a hand's with the hand.
    double recipe_until_s = MilkJug::kNoEnd_s, hand_until_s = 0.0;
    float recipe_x_m = 0.0F, recipe_y_m = 0.0F;

    BoxShape shape() const { return {nx, ny, nz, cell_m}; }
};
static_assert(sizeof(Facts) == 136);
constexpr std::size_t kShortFactBytes = 112;
constexpr std::uint32_t kShortVersion = 2;

/// Parcels; dissolved, coldness; velocity x, y, z; pressure; spare velocity x, y, z; two spare fields of
/// cells.
files::PartFileKind kind() {
    constexpr int kMost = liquid::kMaxTeaCells;
    constexpr std::size_t kFields = 11;
    const std::size_t samples = sample_count({kMost, kMost, kMost, 0.0F}, BoxSamples::All);
    return {.what = core::Pattern<0>("checkpoint of tea"),
            .mark = {'T', 'e', 'a', 'S', 't', 'a', 't', 'e'},
            .version = kTeaCheckpointVersion,
            .oldest = kRoundParcelsVersion,
            .fact_bytes = sizeof(Facts),
            .parts = 1 + kFields,
            .most_bytes =
                kFields * packing::most_packed_bytes(sizeof(float) * samples) +
                packing::most_packed_bytes(sizeof(ParcelRecord) * std::size_t{liquid::kMaxParcels}),
            .short_version = kShortVersion,
            .short_fact_bytes = kShortFactBytes};
}

StreamFacts facts_of(const MilkJug::Stream& stream) {
    return {stream.seconds, stream.parcels};
}

MilkJug::Stream stream_of(const StreamFacts& facts, double until_s, float x_m, float y_m) {
    return {facts.seconds, until_s, static_cast<int>(facts.parcels), {x_m, y_m}};
}

bool hand_pours(const MilkJug::Stream& hand) {
    return hand.until_s == MilkJug::kNoEnd_s;
}

Facts facts_of(const TeaState& state) {
    const BoxShape& shape = state.dissolved.shape();
    Facts facts;
    facts.step = state.step;
    facts.nx = shape.nx;
    facts.ny = shape.ny;
    facts.nz = shape.nz;
    facts.cell_m = shape.cell_m;
    facts.parcel_count = state.parcels.size();
    facts.spare_cells = state.flow.spare_cells.size();
    facts.next_ball_s = state.balls.next_s;
    facts.balls = state.balls.count;
    facts.ball_draws = state.balls.draws;
    facts.recipe = facts_of(state.jug.recipe);
    facts.hand = facts_of(state.jug.hand);
    facts.recipe_until_s = state.jug.recipe.until_s;
    facts.hand_until_s = state.jug.hand.until_s;
    facts.recipe_x_m = state.jug.recipe.at_m.x;
    facts.recipe_y_m = state.jug.recipe.at_m.y;
    facts.hand_x_m = state.jug.hand.at_m.x;
    facts.hand_y_m = state.jug.hand.at_m.y;
    facts.poured_m3 = state.jug.poured_m3;
    facts.jug_places = state.jug.places;
    return facts;
}

/// What is not looked at here, MilkTea::set_state() does.
bool is_allowed(const Facts& facts) {
    for (const std::int32_t side : {facts.nx, facts.ny, facts.nz})
        if (side < 1 || side > liquid::kMaxTeaCells) return false;
    constexpr std::int64_t kMost = std::int64_t{1} << 30;
    for (const std::int64_t count : {facts.step, facts.recipe.parcels, facts.hand.parcels})
        if (count < 0 || count > kMost) return false;
    return facts.cell_m > 0.0F && std::isfinite(facts.cell_m) &&
           facts.parcel_count <= std::uint64_t{liquid::kMaxParcels} &&
           facts.spare_cells <= kMostSpareCells && facts.jug_places <= UINT32_MAX;
}

void take_numbers(const Facts& facts, bool hand_pours, TeaState& state) {
    const double hand_until_s = hand_pours ? MilkJug::kNoEnd_s : facts.hand_until_s;
    state.step = static_cast<int>(facts.step);
    state.balls = {facts.next_ball_s, facts.balls, facts.ball_draws};
    state.jug.recipe = stream_of(facts.recipe, facts.recipe_until_s, facts.recipe_x_m, facts.recipe_y_m);
    state.jug.hand = stream_of(facts.hand, hand_until_s, facts.hand_x_m, facts.hand_y_m);
    state.jug.poured_m3 = facts.poured_m3;
    state.jug.places = static_cast<std::uint32_t>(facts.jug_places);
}

/// Those that are always there, in the file's order.
template <class State>
auto fields_of(State& state) {
    auto& flow = state.flow;
    return std::array{&state.dissolved,       &state.coldness,        &flow.velocity.x,
                      &flow.velocity.y,       &flow.velocity.z,       &flow.pressure,
                      &flow.spare_velocity.x, &flow.spare_velocity.y, &flow.spare_velocity.z};
}

}  // namespace

std::filesystem::path tea_checkpoint_path(const std::filesystem::path& folder) {
    return folder / "checkpoint.tea";
}

void write_tea_checkpoint(const std::filesystem::path& path, const TeaState& state,
                          std::uint64_t scene_hash) {
    const Facts facts = facts_of(state);
    PASTOSO_CHECK(is_allowed(facts));
    files::PartFileWriter file(kind());
    add_parcels(file, state.parcels);
    for (const BoxField* field : fields_of(state))
        add_field(file, *field, BoxSamples::All);
    for (std::size_t n = 0; n < kMostSpareCells; ++n)
        n < facts.spare_cells ? add_field(file, state.flow.spare_cells[n], BoxSamples::All)
                              : file.add_nothing();
    file.write(path, scene_hash, hand_pours(state.jug.hand) ? 1 : 0, facts);
}

TeaState read_tea_checkpoint(const std::filesystem::path& path, std::uint64_t scene_hash) {
    files::PartFileReader file(path, kind(), scene_hash);
    const auto facts = file.facts<Facts>();
    if (!is_allowed(facts) || file.flags() > 1) file.refuse("holds sizes or numbers that no tea has.");
    TeaState state;
    take_numbers(facts, file.flags() == 1, state);
    state.parcels = next_parcels(file, facts.parcel_count);
    for (BoxField* field : fields_of(state))
        *field = next_field(file, facts.shape(), BoxSamples::All);
    for (std::uint64_t n = 0; n < facts.spare_cells; ++n)
        state.flow.spare_cells.push_back(next_field(file, facts.shape(), BoxSamples::All));
    return state;
}

}  // namespace pastoso::liquid_files
