#include "pigment/colour.hpp"
#include "pigment/kubelka_munk.hpp"
#include "shade/kernels.hpp"

#include <algorithm>

namespace pastoso::shade::PASTOSO_ISA {
namespace {

/// Cells are taken in groups, band by band, so that the loops over a group are vectorised.
constexpr int kGroup = 64;

struct Group {
    alignas(64) float optical_thickness[pigment::kChannels][kGroup];
    alignas(64) float red[kGroup], green[kGroup], blue[kGroup], wetness[kGroup];
};

void load(const film::PaintCell* pigment, const std::int32_t* thickness, int count, Group& group) {
    constexpr auto kToGloss = static_cast<float>(1.0 / kGlossyThickness_mm);
    for (int i = 0; i < count; ++i) {
        for (int k = 0; k < pigment::kChannels; ++k) {
            group.optical_thickness[k][i] = film::optical_thickness(pigment[i][k]);
        }
    }
    for (int i = 0; i < count; ++i) {
        const float t = clamp_to_unit(film::thickness_mm(thickness[i]) * kToGloss);
        group.wetness[i] = t * t * (3.0F - 2.0F * t);
        group.red[i] = group.green[i] = group.blue[i] = 0.0F;
    }
}

void add_band(int band, float ground, int count, Group& group) {
    const float* kh = group.optical_thickness[band];
    const float* sh = group.optical_thickness[pigment::kBands + band];
    const float to_red = pigment::kBandsToLinearSrgb[0][band];
    const float to_green = pigment::kBandsToLinearSrgb[1][band];
    const float to_blue = pigment::kBandsToLinearSrgb[2][band];
    for (int i = 0; i < count; ++i) {
        const float internal = pigment::layer_reflectance(kh[i], sh[i], ground);
        const float reflectance = pigment::through_surface(internal);
        group.red[i] += to_red * reflectance;
        group.green[i] += to_green * reflectance;
        group.blue[i] += to_blue * reflectance;
    }
}

void store(const Group& group, int count, CellColour* out) {
    for (int i = 0; i < count; ++i)
        out[i] = {group.red[i], group.green[i], group.blue[i], group.wetness[i]};
}

}  // namespace

void colour_cells(const film::PaintCell* pigment, const std::int32_t* thickness, int count,
                  const pigment::Bands& ground, CellColour* out) {
    Group group;
    for (int first = 0; first < count; first += kGroup) {
        const int size = std::min(kGroup, count - first);
        load(pigment + first, thickness + first, size, group);
        for (int band = 0; band < pigment::kBands; ++band)
            add_band(band, ground[band], size, group);
        store(group, size, out + first);
    }
}

}  // namespace pastoso::shade::PASTOSO_ISA
