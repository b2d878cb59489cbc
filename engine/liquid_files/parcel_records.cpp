#include "liquid_files/parcel_records.hpp"

#include <cmath>

namespace pastoso::liquid_files {

using liquid::Parcel;

void add_parcels(files::PartFileWriter& file, const std::vector<Parcel>& parcels) {
    std::vector<ParcelRecord> records;
    records.reserve(parcels.size());
    for (const Parcel& parcel : parcels) {
        const glm::vec3& at = parcel.position_m;
        records.push_back({at.x, at.y, at.z, parcel.volume_m3, parcel.coldness, parcel.ball});
    }
    file.add(records);
}

std::vector<Parcel> next_parcels(files::PartFileReader& file, std::size_t count) {
    std::vector<Parcel> parcels;
    parcels.reserve(count);
    for (const ParcelRecord& record : file.next<ParcelRecord>(count)) {
        for (const float value :
             {record.x_m, record.y_m, record.z_m, record.volume_m3, record.coldness}) {
            if (std::isfinite(value)) continue;
            file.refuse("holds a parcel (number " + std::to_string(parcels.size()) +
                        ") whose values are not finite.");
        }
        parcels.push_back(
            {{record.x_m, record.y_m, record.z_m}, record.volume_m3, record.coldness, record.ball});
    }
    return parcels;
}

}  // namespace pastoso::liquid_files
