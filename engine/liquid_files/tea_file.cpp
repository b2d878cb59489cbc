#include "liquid_files/tea_file.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/looking.hpp"
#include "liquid_files/box_values.hpp"
#include "liquid_files/parcel_records.hpp"

#include <cmath>

namespace pastoso::liquid_files {
namespace {

using grid::BoxShape;
using liquid::TeaFrame;

/// Of the head; its flags are 1 where coldness is kept, else 0.
struct Facts {
    double time_s = 0.0;
    std::int64_t step = 0;
    std::int32_t nx = 0, ny = 0, nz = 0;
    float cell_m = 0.0F;
    std::uint64_t parcel_count = 0;

    std::int64_t cell_count() const { return std::int64_t{nx} * ny * nz; }
    BoxShape shape() const { return {nx, ny, nz, cell_m}; }
};

/// Parcels, dissolved, coldness.
files::PartFileKind kind() {
    const auto cells = static_cast<std::size_t>(kMostTeaCells);
    return {.what = "frame of tea",
            .mark = {'P', 'a', 's', 't', 'o', 'T', 'e', 'a'},
            .version = kTeaFileVersion,
            .oldest = kRoundParcelsVersion,
            .fact_bytes = sizeof(Facts),
            .parts = 3,
            .most_bytes = 2 * packing::most_packed_bytes(sizeof(float) * cells) +
                          packing::most_packed_bytes(sizeof(ParcelRecord) *
                                                     static_cast<std::size_t>(kMostTeaParcels))};
}

bool is_allowed(const Facts& facts, std::uint32_t has_coldness) {
    for (const std::int32_t side : {facts.nx, facts.ny, facts.nz})
        if (side < 0 || side > kMostTeaCellsAlong) return false;
    const bool has_cells = facts.nx > 0 && facts.ny > 0 && facts.nz > 0;
    const bool is_empty = facts.nx == 0 && facts.ny == 0 && facts.nz == 0 && has_coldness == 0;
    if (!is_empty && !(has_cells && facts.cell_m > 0.0F && std::isfinite(facts.cell_m))) return false;
    return facts.cell_count() <= kMostTeaCells && has_coldness <= 1 &&
           facts.parcel_count <= std::uint64_t{kMostTeaParcels} && std::isfinite(facts.time_s) &&
           facts.step >= 0 && facts.step <= std::int64_t{1} << 30;
}

bool is_allowed(const files::PartFileReader& file) {
    return is_allowed(file.facts<Facts>(), file.flags());
}

}  // namespace

void write_tea_frame(const std::filesystem::path& path, const TeaFrame& frame,
                     std::uint64_t scene_hash) {
    const BoxShape& shape = frame.dissolved.shape();
    const std::uint32_t has_coldness = frame.coldness.shape().nx > 0 ? 1 : 0;
    PASTOSO_CHECK(has_coldness == 0 || frame.coldness.shape() == shape);
    const Facts facts{frame.time_s, frame.step,          shape.nx, shape.ny, shape.nz,
                      shape.cell_m, frame.parcels.size()};
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
