// Compiled once per instruction set; see pastoso_add_kernels.
#include "core/lane_power.hpp"
#include "film/explicit/tile_kernels.hpp"
#include "film/face/lane_groups.hpp"

namespace pastoso::film::PASTOSO_ISA {
namespace {

constexpr float kLog2E = 1.44269504F;
constexpr auto kThinnest_mm2_s = static_cast<float>(kThinnest_m2_s * 1e6);
/// Thickness quanta in a quantum of what is carried.
constexpr auto kQuantaPerCarried = static_cast<float>(kPaintQuantum / kThicknessQuantum_mm);

/// The carried numbers per thickness: log2(nu / kThinnest_m2_s) and tau_y in Pa, both within the bounds
/// that drying keeps.
[[gnu::always_inline]] inline void ratios(const PaintCell& paint, std::int32_t thickness,
                                          float yield_per_Pa, float& exponent, float& yield) {
    constexpr float kMostExponent = 33.2192809F;
    constexpr float kMost_Pa = 1000.0F;
    const float per_mm = thickness > 0 ? kQuantaPerCarried / static_cast<float>(thickness) : 0.0F;
    exponent = lanes::min(static_cast<float>(paint[kViscosityChannel]) * per_mm * kLog2E, kMostExponent);
    yield = lanes::min(static_cast<float>(paint[kYieldChannel]) * per_mm, kMost_Pa) * yield_per_Pa;
}

}  // namespace

void cell_rheology(const PaintCell* paint, const std::int32_t* thickness, int count, float yield_per_Pa,
                   float* viscosity, float* yield) {
    for (int i = 0; i < count; ++i)
        ratios(paint[i], thickness[i], yield_per_Pa, viscosity[i], yield[i]);
    int i = 0;
    for (; i + kLanes <= count; i += kLanes)
        store(viscosity + i, Lanes(kThinnest_mm2_s) * lanes::exp2(load(viscosity + i)));
    for (; i < count; ++i)
        viscosity[i] = kThinnest_mm2_s * lanes::exp2(viscosity[i]);
}

}  // namespace pastoso::film::PASTOSO_ISA
