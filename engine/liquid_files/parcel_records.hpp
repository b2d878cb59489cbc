// Parcels of milk as a part of a file.
#pragma once

#include "files/part_file.hpp"
#include "liquid/tea/parcel.hpp"

#include <cstdint>
#include <vector>

namespace pastoso::liquid_files {

/// A parcel as it is written.
struct ParcelRecord {
    float x_m, y_m, z_m, volume_m3, coldness;
    std::int32_t ball;
};
static_assert(sizeof(ParcelRecord) == 24);

void add_parcels(files::PartFileWriter& file, const std::vector<liquid::Parcel>& parcels);

/// Throws InputError when a number is not finite.
std::vector<liquid::Parcel> next_parcels(files::PartFileReader& file, std::size_t count);

}  // namespace pastoso::liquid_files
