#include "session/tea_frames.hpp"

#include "core/check.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

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

void TeaFrames::clear() {
    frames_.clear();
    interval_ = 1;
}

void TeaFrames::keep(int step, const std::vector<liquid::Parcel>& parcels,
                     const grid::BoxField& dissolved) {
    PASTOSO_CHECK(frames_.empty() || frames_.back().step < step);
    if (step % interval_ != 0) return;
    shape_ = dissolved.shape();
    Packed frame{step, {}, packed(dissolved)};
    frame.parcels.reserve(parcels.size());
    for (const liquid::Parcel& parcel : parcels)
        frame.parcels.emplace_back(parcel.position_m, parcel.volume_m3);
    frames_.push_back(std::move(frame));
    // Two always stay, however little memory there is.
    while (bytes() > budget_bytes_ && frames_.size() > 2)
        thin_out();
}

void TeaFrames::thin_out() {
    interval_ *= 2;
    std::erase_if(frames_, [this](const Packed& frame) { return frame.step % interval_ != 0; });
}

std::vector<int> TeaFrames::steps() const {
    std::vector<int> steps;
    std::transform(frames_.begin(), frames_.end(), std::back_inserter(steps),
                   [](const Packed& frame) { return frame.step; });
    return steps;
}

TeaFrame TeaFrames::at(int step) const {
    PASTOSO_CHECK(!frames_.empty());
    const auto after =
        std::upper_bound(frames_.begin(), frames_.end(), step,
                         [](int wanted, const Packed& frame) { return wanted < frame.step; });
    const Packed& found = after == frames_.begin() ? *after : *std::prev(after);
    TeaFrame frame{found.step, {}, unpacked(shape_, found.dissolved)};
    for (const glm::vec4& parcel : found.parcels)
        frame.parcels.push_back({.position_m = glm::vec3(parcel), .volume_m3 = parcel.w});
    return frame;
}

std::size_t TeaFrames::bytes() const {
    std::size_t sum = 0;
    for (const Packed& frame : frames_)
        sum += frame.bytes();
    return sum;
}

}  // namespace pastoso::session
