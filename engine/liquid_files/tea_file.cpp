#include "liquid_files/tea_file.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/looking.hpp"
#include "liquid_files/box_values.hpp"
#include "liquid_files/parcel_records.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pastoso::liquid_files {
namespace {

using grid::BoxShape;
using liquid::TeaFrame;

/// A stream in the air; all 0: none.
struct StreamFacts {
    float x_m = 0.0F, y_m = 0.0F, lip_m = 0.0F, high_m = 0.0F, low_m = 0.0F;
    float lip_speed_m_s = 0.0F, lip_radius_m = 0.0F;

    bool is_none() const { return lip_radius_m == 0.0F; }
};
constexpr std::size_t kMostStreams = 2;  ///< the recipe's and a hand's

/// Of the head; its flags are 1 where coldness is kept, else 0.
struct Facts {
    double time_s = 0.0;
    std::int64_t step = 0;
    std::int32_t nx = 0, ny = 0, nz = 0;
    float cell_m = 0.0F;
    std::uint64_t parcel_count = 0;
    // Versions 1 and 2 end here.
    std::array<StreamFacts, kMostStreams> streams{};
    float level_m = 0.0F;  ///< 0: that of the scene's cup
    float spare = 0.0F;

    std::int64_t cell_count() const { return std::int64_t{nx} * ny * nz; }
    BoxShape shape() const { return {nx, ny, nz, cell_m}; }
};

static_assert(sizeof(Facts) == 104);
constexpr std::size_t kShortFactBytes = 40;
constexpr std::uint32_t kShortVersion = 2;

/// Parcels, dissolved, coldness.
files::PartFileKind kind() {
    const auto cells = static_cast<std::size_t>(kMostTeaCells);
    return {.what = core::Pattern<0>("frame of tea"),
            .mark = {'P', 'a', 's', 't', 'o', 'T', 'e', 'a'},
            .version = kTeaFileVersion,
            .oldest = kRoundParcelsVersion,
            .fact_bytes = sizeof(Facts),
            .parts = 3,
            .most_bytes = 2 * packing::most_packed_bytes(sizeof(float) * cells) +
                          packing::most_packed_bytes(sizeof(ParcelRecord) *
                                                     static_cast<std::size_t>(kMostTeaParcels)),
            .short_version = kShortVersion,
            .short_fact_bytes = kShortFactBytes};
}

bool is_allowed(const StreamFacts& stream) {
    for (const float number : {stream.x_m, stream.y_m, stream.lip_m, stream.high_m, stream.low_m})
        if (!std::isfinite(number)) return false;
    if (stream.is_none()) return true;
    return std::isfinite(stream.lip_speed_m_s) && stream.lip_speed_m_s > 0.0F &&
           std::isfinite(stream.lip_radius_m) && stream.lip_radius_m > 0.0F &&
           stream.low_m <= stream.high_m && stream.high_m <= stream.lip_m;
}

bool is_allowed(const Facts& facts, std::uint32_t has_coldness) {
    for (const std::int32_t side : {facts.nx, facts.ny, facts.nz})
        if (side < 0 || side > kMostTeaCellsAlong) return false;
    const bool has_cells = facts.nx > 0 && facts.ny > 0 && facts.nz > 0;
    const bool is_empty = facts.nx == 0 && facts.ny == 0 && facts.nz == 0 && has_coldness == 0;
    if (!is_empty && !(has_cells && facts.cell_m > 0.0F && std::isfinite(facts.cell_m))) return false;
    if (!std::all_of(facts.streams.begin(), facts.streams.end(),
                     [](const StreamFacts& stream) { return is_allowed(stream); }))
        return false;
    return std::isfinite(facts.level_m) && facts.level_m >= 0.0F &&
           facts.cell_count() <= kMostTeaCells && has_coldness <= 1 &&
           facts.parcel_count <= std::uint64_t{kMostTeaParcels} && std::isfinite(facts.time_s) &&
           facts.step >= 0 && facts.step <= std::int64_t{1} << 30;
}

bool is_allowed(const files::PartFileReader& file) {
    return is_allowed(file.facts<Facts>(), file.flags());
}

Facts facts_of(const TeaFrame& frame) {
    const BoxShape& shape = frame.dissolved.shape();
    Facts facts;
    facts.time_s = frame.time_s;
    facts.step = frame.step;
    facts.nx = shape.nx;
    facts.ny = shape.ny;
    facts.nz = shape.nz;
    facts.cell_m = shape.cell_m;
    facts.parcel_count = frame.parcels.size();
    PASTOSO_CHECK_OP(frame.pour.streams.size(), <=, kMostStreams);
    for (std::size_t n = 0; n < frame.pour.streams.size(); ++n) {
        const liquid::MilkStream& stream = frame.pour.streams[n];
        facts.streams[n] = {stream.at_m.x, stream.at_m.y,        stream.lip_m,       stream.high_m,
                            stream.low_m,  stream.lip_speed_m_s, stream.lip_radius_m};
    }
    facts.level_m = frame.pour.level_m;
    return facts;
}

liquid::SeenPour pour_of(const Facts& facts) {
    liquid::SeenPour pour{facts.level_m, {}};
    for (const StreamFacts& stream : facts.streams)
        if (!stream.is_none())
            pour.streams.push_back({{stream.x_m, stream.y_m},

                                    stream.lip_m,
                                    stream.high_m,
                                    stream.low_m,
                                    stream.lip_speed_m_s,
                                    stream.lip_radius_m});
    return pour;
}

}  // namespace

void write_tea_frame(const std::filesystem::path& path, const TeaFrame& frame,
                     std::uint64_t scene_hash) {
    const BoxShape& shape = frame.dissolved.shape();
    const std::uint32_t has_coldness = frame.coldness.shape().nx > 0 ? 1 : 0;
    PASTOSO_CHECK(has_coldness == 0 || frame.coldness.shape() == shape);
    const Facts facts = facts_of(frame);
    PASTOSO_CHECK(is_allowed(facts, has_coldness));
    files::PartFileWriter file(kind());
    add_parcels(file, frame.parcels);
    shape.nx > 0 ? add_field(file, frame.dissolved, BoxSamples::Cells) : file.add_nothing();
    has_coldness != 0 ? add_field(file, frame.coldness, BoxSamples::Cells) : file.add_nothing();
    file.write(path, scene_hash, has_coldness, facts);
}

TeaFrame read_tea_frame(const std::filesystem::path& path, std::uint64_t scene_hash) {
    files::PartFileReader file(path, kind(), scene_hash);
    if (!is_allowed(file)) file.refuse("holds sizes or times that no frame has.");
    const auto facts = file.facts<Facts>();
    TeaFrame frame;
    frame.time_s = facts.time_s;
    frame.step = static_cast<int>(facts.step);
    frame.pour = pour_of(facts);
    frame.parcels = next_parcels(file, facts.parcel_count);
    if (facts.nx > 0) frame.dissolved = next_field(file, facts.shape(), BoxSamples::Cells);
    if (file.flags() != 0) frame.coldness = next_field(file, facts.shape(), BoxSamples::Cells);
    return frame;
}

bool is_whole_tea_frame(const std::filesystem::path& path, std::uint64_t scene_hash) {
    if (!core::is_regular_file(path)) return false;
    try {
        return is_allowed(files::PartFileReader(path, kind(), scene_hash));
    } catch (const core::InputError&) {
        return false;
    }
}

}  // namespace pastoso::liquid_files
