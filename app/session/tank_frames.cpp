#include "session/tank_frames.hpp"

#include <cmath>
#include <cstdint>
#include <span>

namespace pastoso::session {
namespace {

/// Levels reach less than four cells from the surface.
constexpr float kLevelSteps = 8000.0F, kMilkSteps = 255.0F;

std::size_t count_of(const liquid::Lattice& lattice) {
    return static_cast<std::size_t>(lattice.nx) * static_cast<std::size_t>(lattice.ny) *
           static_cast<std::size_t>(lattice.nz);
}

std::size_t count_of(const grid::BoxShape& shape) {
    return static_cast<std::size_t>(shape.nx) * static_cast<std::size_t>(shape.ny) *
           static_cast<std::size_t>(shape.nz);
}

/// The upper bytes first, then the lower ones: most of the upper ones are alike.
packing::Bytes packed_level(const liquid::SampledField& level_m, float cell_m) {
    const liquid::Lattice& lattice = level_m.lattice();
    const std::size_t count = count_of(lattice);
    packing::Bytes bytes(2 * count);
    std::size_t at = 0;
    for (int k = 0; k < lattice.nz; ++k)
        for (int j = 0; j < lattice.ny; ++j)
            for (int i = 0; i < lattice.nx; ++i, ++at) {
                const float steps = kLevelSteps * level_m.at(i, j, k) / cell_m;
                const auto value = static_cast<std::uint16_t>(
                    std::lround(std::clamp(steps, -32000.0F, 32000.0F)) + 32768);
                bytes[at] = static_cast<std::byte>(value >> 8);
                bytes[count + at] = static_cast<std::byte>(value & 0xFF);
            }
    return packing::packed(bytes);
}

liquid::SampledField unpacked_level(const packing::Bytes& packed, const liquid::Lattice& lattice,
                                    float cell_m) {
    const std::size_t count = count_of(lattice);
    const packing::Bytes bytes = packing::unpacked(packed, 2 * count);
    liquid::SampledField level_m(lattice);
    std::size_t at = 0;
    for (int k = 0; k < lattice.nz; ++k)
        for (int j = 0; j < lattice.ny; ++j)
            for (int i = 0; i < lattice.nx; ++i, ++at) {
                const int value =
                    256 * static_cast<int>(bytes[at]) + static_cast<int>(bytes[count + at]);
                level_m.at(i, j, k) = static_cast<float>(value - 32768) * cell_m / kLevelSteps;
            }
    return level_m;
}

packing::Bytes packed_milk(const grid::BoxField& milk) {
    const grid::BoxShape& shape = milk.shape();
    packing::Bytes bytes;
    bytes.reserve(count_of(shape));
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i) {
                const float share = std::clamp(milk.at(i, j, k), 0.0F, 1.0F);
                bytes.push_back(static_cast<std::byte>(std::lround(kMilkSteps * share)));
            }
    return packing::packed(bytes);
}

grid::BoxField unpacked_milk(const packing::Bytes& packed, const grid::BoxShape& shape) {
    const packing::Bytes bytes = packing::unpacked(packed, count_of(shape));
    grid::BoxField milk(shape);
    auto value = bytes.begin();
    for (int k = 0; k < shape.nz; ++k)
        for (int j = 0; j < shape.ny; ++j)
            for (int i = 0; i < shape.nx; ++i)
                milk.at(i, j, k) = static_cast<float>(*value++) / kMilkSteps;
    return milk;
}

}  // namespace

void TankFrames::keep(const TankSeen& seen) {
    if (!kept_.wants(seen.step)) return;
    lattice_ = seen.level_m.lattice();
    shape_ = seen.milk.shape();
    kept_.keep({seen.step, std::make_shared<const Content>(Content{
                               seen.time_s, seen.volume_m3, packed_level(seen.level_m, shape_.cell_m),
                               packed_milk(seen.milk), seen.arrows})});
}

TankSeen TankFrames::at(int step) const {
    const Packed& found = kept_.at(step);
    const Content& content = *found.content;
    return {found.step,
            content.time_s,
            content.volume_m3,
            unpacked_level(content.level, lattice_, shape_.cell_m),
            unpacked_milk(content.milk, shape_),
            content.arrows};
}

}  // namespace pastoso::session
