// Parcels of milk as a part of a file.
#pragma once

#include "files/part_file.hpp"
#include "liquid/tea/parcel.hpp"

#include <cstdint>
#include <vector>

namespace pastoso::liquid_files {

/// A parcel as version 1 of frames and checkpoints has it: as round as it was poured.
struct RoundParcelRecord {
    float x_m, y_m, z_m, volume_m3, coldness;
    std::int32_t ball;
};
inline constexpr std::uint32_t kRoundParcelsVersion = 1;

/// A parcel as it is written.
struct ParcelRecord {
    RoundParcelRecord round;
    liquid::ParcelShape shape;
};
static_assert(sizeof(RoundParcelRecord) == 24 && sizeof(ParcelRecord) == 48);

void add_parcels(files::PartFileWriter& file, const std::vector<liquid::Parcel>& parcels);

/// Of a file of any version that is read. Throws InputError when a number is not finite, or a shape is
/// none (liquid::is_shape()).
std::vector<liquid::Parcel> next_parcels(files::PartFileReader& file, std::size_t count);

}  // namespace pastoso::liquid_files
