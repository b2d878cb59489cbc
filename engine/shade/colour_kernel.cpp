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
    alignas(64) float ground[pigment::kBands][kGroup];
    alignas(64) float red[kGroup], green[kGroup], blue[kGroup], wetness[kGroup];
};

template <class Cell>
void load_pigment(const Cell* cells, int count, Group& group) {
    for (int i = 0; i < count; ++i) {
        for (int k = 0; k < pigment::kChannels; ++k)
            group.optical_thickness[k][i] = film::optical_thickness(cells[i][k]);
    }
}

/// What is fixed, over the ground.
void lay_strata(const film::StrataOptics* strata, int count, Group& group) {
    alignas(64) float share[3 * pigment::kBands][kGroup];
    for (int i = 0; i < count; ++i) {
        for (int k = 0; k < 3 * pigment::kBands; ++k)
            share[k][i] = static_cast<float>(strata[i][k]) / film::kOpticsCode;
    }
    for (int band = 0; band < pigment::kBands; ++band) {
        const float* reflectance = share[band];
        const float* transmittance = share[pigment::kBands + band];
        const float* reverse = share[2 * pigment::kBands + band];
        for (int i = 0; i < count; ++i)
            group.ground[band][i] = pigment::reflectance_over(
                {reflectance[i], transmittance[i], reverse[i]}, group.ground[band][i]);
    }
}

/// The loaded pigment joins the ground.
void lay_pigment(int count, Group& group) {
    for (int band = 0; band < pigment::kBands; ++band) {
        const float* kh = group.optical_thickness[band];
        const float* sh = group.optical_thickness[pigment::kBands + band];
        for (int i = 0; i < count; ++i)
            group.ground[band][i] = pigment::layer_reflectance(kh[i], sh[i], group.ground[band][i]);
    }
}

/// The reflectance of all that lies below the wet paint.
void load_ground(const CellStack& cells, int first, int count, const pigment::Bands& bare,
                 Group& group) {
    for (int band = 0; band < pigment::kBands; ++band)
        std::fill_n(group.ground[band], count, bare[band]);
    if (cells.strata != nullptr) lay_strata(cells.strata + first, count, group);
    if (cells.soluble == nullptr) return;
    load_pigment(cells.soluble + first, count, group);
    lay_pigment(count, group);
}

/// The wet paint that is seen first; where there are two strata, the lower joins the ground.
void load_wet(const CellStack& cells, int first, int count, Group& group) {
    if (cells.lower == nullptr) return load_pigment(cells.paint + first, count, group);
    load_pigment(cells.lower + first, count, group);
    lay_pigment(count, group);
    const film::PaintCell *whole = cells.paint + first, *lower = cells.lower + first;
    for (int i = 0; i < count; ++i) {
        for (int k = 0; k < pigment::kChannels; ++k)
            group.optical_thickness[k][i] = film::optical_thickness(whole[i][k] - lower[i][k]);
    }
}

void start_colours(const std::int32_t* thickness, int count, Group& group) {
    constexpr auto kToGloss = static_cast<float>(1.0 / kGlossyThickness_mm);
    for (int i = 0; i < count; ++i) {
        const float t = clamp_to_unit(film::thickness_mm(thickness[i]) * kToGloss);
        group.wetness[i] = t * t * (3.0F - 2.0F * t);
        group.red[i] = group.green[i] = group.blue[i] = 0.0F;
    }
}

void add_band(int band, int count, const pigment::BandsToRgb& to_rgb, Group& group) {
    const float* ground = group.ground[band];
    const float* kh = group.optical_thickness[band];
    const float* sh = group.optical_thickness[pigment::kBands + band];
    const float to_red = to_rgb[0][band];
    const float to_green = to_rgb[1][band];
    const float to_blue = to_rgb[2][band];
    for (int i = 0; i < count; ++i) {
        const float internal = pigment::layer_reflectance(kh[i], sh[i], ground[i]);
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

void colour_cells(const CellStack& cells, int count, const pigment::Bands& bare_ground,
                  const pigment::BandsToRgb& to_rgb, CellColour* out) {
    Group group;
    for (int first = 0; first < count; first += kGroup) {
        const int size = std::min(kGroup, count - first);
        load_ground(cells, first, size, bare_ground, group);
        load_wet(cells, first, size, group);
        start_colours(cells.thickness + first, size, group);
        for (int band = 0; band < pigment::kBands; ++band)
            add_band(band, size, to_rgb, group);
        store(group, size, out + first);
    }
}

}  // namespace pastoso::shade::PASTOSO_ISA
