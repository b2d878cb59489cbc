#include "trace/wood.hpp"

#include "core/random.hpp"
#include "trace/numbers.hpp"

namespace pastoso::trace {
namespace {

constexpr float kBoard_m = 0.085F, kGap_m = 0.0007F, kGapShade = 0.55F;
constexpr std::uint32_t kToneStream = 1, kShiftStream = 2;

float wave(float turns) {
    return cos_sin_of_turns(turns - std::floor(turns)).y;
}

}  // namespace

float wood_grain(const glm::vec2& place_m) {
    const float board = std::floor(place_m.y / kBoard_m);
    const float across_m = place_m.y - board * kBoard_m;
    if (across_m < kGap_m) return kGapShade;
    const auto which = static_cast<std::uint32_t>(static_cast<std::int32_t>(board));
    const float shift = core::uniform_noise(which, kShiftStream);
    const float tone = 0.93F + 0.14F * core::uniform_noise(which, kToneStream);
    const float along_m = place_m.x + 5.0F * shift;
    const float bend_m = 0.006F * wave(1.9F * along_m) + 0.002F * wave(7.3F * along_m + shift);
    const float ring = 150.0F * (across_m + bend_m) + 1.3F * wave(21.0F * across_m + shift);
    const float late = ring - std::floor(ring);
    const float fibres = wave(1100.0F * across_m + 3.0F * wave(11.0F * along_m)) *
                         wave(23.0F * along_m + 40.0F * across_m);
    return tone * (1.05F - 0.2F * late * late * late + 0.025F * fibres);
}

}  // namespace pastoso::trace
