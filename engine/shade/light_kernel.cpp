#include "shade/kernels.hpp"

namespace pastoso::shade::PASTOSO_ISA {

void add_horizon(const HorizonLook& look, const float* height, int count, float* out) {
    for (int x = 0; x < count; ++x) {
        float slope = 0.0F;
        for (int k = 0; k < kHorizonDistances; ++k) {
            const float rise =
                (height[x + look.offset[k]] - height[x]) * look.inverse_distance_per_mm[k];
            slope = rise > slope ? rise : slope;
        }
        out[x] += 0.125F / (1.0F + slope * slope);
    }
}

void raise_shadow(const float* near, const float* far, float far_share, float drop_mm, int count,
                  float* out) {
    for (int x = 0; x < count; ++x) {
        const float shadow = near[x] + far_share * (far[x] - near[x]) - drop_mm;
        out[x] = shadow > out[x] ? shadow : out[x];
    }
}

}  // namespace pastoso::shade::PASTOSO_ISA
