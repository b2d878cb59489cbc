#include "session/tea_frames.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::session {
namespace {

constexpr float kSteps = 65535.0F;

std::vector<std::uint16_t> packed(const grid::BoxField& field) {
    const grid::BoxShape& shape = field.shape();
    std::vector<std::uint16_t> values;
    values.reserve(static_cast<std::size_t>(shape.nx) * static_cast<std::size_t>(shape.ny) *
                   static_cast<std::size_t>(shape.nz));
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i) {
                const float share = std::clamp(field.at(i, j, k), 0.0F, 1.0F);
                values.push_back(static_cast<std::uint16_t>(std::lround(kSteps * share)));
            }
    return values;
}

grid::BoxField unpacked(const grid::BoxShape& shape, const std::vector<std::uint16_t>& values) {
    grid::BoxField field(shape);
    auto value = values.begin();
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i)
                field.at(i, j, k) = static_cast<float>(*value++) / kSteps;
    return field;
}

}  // namespace

void TeaFrames::keep(int step, const std::vector<liquid::Parcel>& parcels,
                     const grid::BoxField& dissolved, const liquid::SeenPour& pour) {
    if (!kept_.wants(step)) return;
    shape_ = dissolved.shape();
    Packed frame{step, {}, packed(dissolved), pour};
    frame.parcels.reserve(parcels.size());
    for (const liquid::Parcel& parcel : parcels)
        frame.parcels.push_back({parcel.position_m, parcel.volume_m3, parcel.shape});
    kept_.keep(std::move(frame));
}

TeaFrame TeaFrames::at(int step) const {
    const Packed& found = kept_.at(step);
    TeaFrame frame{found.step, {}, unpacked(shape_, found.dissolved), found.pour};
    for (const PackedParcel& parcel : found.parcels)
        frame.parcels.push_back(
            {.position_m = parcel.position_m, .volume_m3 = parcel.volume_m3, .shape = parcel.shape});
    return frame;
}

}  // namespace pastoso::session
