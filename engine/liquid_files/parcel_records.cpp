#include "liquid_files/parcel_records.hpp"

#include "liquid/tea/parcel_shape.hpp"

#include <cmath>

namespace pastoso::liquid_files {
namespace {

using liquid::Parcel;

Parcel parcel_of(const RoundParcelRecord& record) {
    return {{record.x_m, record.y_m, record.z_m}, record.volume_m3, record.coldness, record.ball};
}

Parcel parcel_of(const ParcelRecord& record) {
    Parcel parcel = parcel_of(record.round);
    parcel.shape = record.shape;
    return parcel;
}

void check(const Parcel& parcel, std::size_t number, const files::PartFileReader& file) {
    const glm::vec3& at = parcel.position_m;
    for (const float value : {at.x, at.y, at.z, parcel.volume_m3, parcel.coldness})
        if (!std::isfinite(value))
            file.refuse("holds a parcel (number %1) whose values are not finite.", number);
    if (!liquid::is_shape(parcel.shape))
        file.refuse("holds a parcel (number %1) whose shape is none.", number);
}

template <class Record>
std::vector<Parcel> next_parcels_as(files::PartFileReader& file, std::size_t count) {
    std::vector<Parcel> parcels;
    parcels.reserve(count);
    for (const Record& record : file.next<Record>(count)) {
        const Parcel parcel = parcel_of(record);
        check(parcel, parcels.size(), file);
        parcels.push_back(parcel);
    }
    return parcels;
}

}  // namespace

void add_parcels(files::PartFileWriter& file, const std::vector<Parcel>& parcels) {
    std::vector<ParcelRecord> records;
    records.reserve(parcels.size());
    for (const Parcel& parcel : parcels) {
        const glm::vec3& at = parcel.position_m;
        records.push_back(
            {{at.x, at.y, at.z, parcel.volume_m3, parcel.coldness, parcel.ball}, parcel.shape});
    }
    file.add(records);
}

std::vector<Parcel> next_parcels(files::PartFileReader& file, std::size_t count) {
    return file.version() == kRoundParcelsVersion ? next_parcels_as<RoundParcelRecord>(file, count)
                                                  : next_parcels_as<ParcelRecord>(file, count);
}

}  // namespace pastoso::liquid_files
