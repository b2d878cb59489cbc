#include "film/cell/strata.hpp"

#include "film/state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pastoso::film {

namespace {

constexpr double kMostCode = std::numeric_limits<std::uint16_t>::max();

}  // namespace

PigmentMixture mixture_of(const std::int32_t* pigment, std::int32_t thickness) {
    PigmentMixture mixture{};
    if (thickness <= 0) return mixture;
    const double per_quantum = kPaintQuantum / (thickness * kThicknessQuantum_mm);
    const double densest_per_mm = per_quantum * *std::max_element(pigment, pigment + kPigmentChannels);
    const double most_per_mm = std::max<double>(densest_per_mm, pigment::kMostPerMm);
    for (int k = 0; k < kPigmentChannels; ++k)
        mixture[k] = static_cast<std::uint16_t>(
            std::lround(kMostCode * std::sqrt(per_quantum * pigment[k] / most_per_mm)));
    return mixture;
}

pigment::Coefficients coefficients_of(const PigmentMixture& mixture) {
    pigment::Coefficients per_mm{};
    for (int k = 0; k < kPigmentChannels; ++k) {
        const double root = mixture[k] / kMostCode;
        per_mm[k] = static_cast<float>(pigment::kMostPerMm * root * root);
    }
    return per_mm;
}

DriedTotals& DriedTotals::operator+=(const DriedTotals& other) {
    thickness += other.thickness;
    for (int k = 0; k < kPigmentChannels; ++k)
        pigment[k] += other.pigment[k];
    return *this;
}

DriedTotals& DriedTotals::operator-=(const DriedTotals& other) {
    thickness -= other.thickness;
    for (int k = 0; k < kPigmentChannels; ++k)
        pigment[k] -= other.pigment[k];
    return *this;
}

StrataOptics faded(const StrataOptics& strata, float share) {
    StrataOptics rest{};
    for (int band = 0; band < pigment::kBands; ++band)
        set_optics(band, pigment::faded(optics_of(strata, band), share), rest);
    return rest;
}

bool is_empty(const PigmentCell& pigment, std::int32_t thickness) {
    return thickness == 0 && std::all_of(pigment.begin(), pigment.end(), [](auto k) { return k == 0; });
}

void replace_soluble(int tile, bool any, grid::TileBlock<std::int32_t> thickness,
                     grid::TileBlock<PigmentCell> pigment, Strata& strata) {
    if (any) {
        strata.soluble_thickness.replace(tile, std::move(thickness));
        strata.soluble_pigment.replace(tile, std::move(pigment));
    } else {
        strata.soluble_thickness.reset(tile);
        strata.soluble_pigment.reset(tile);
    }
}

DriedTotals dried_totals(const Strata& strata) {
    DriedTotals sums = strata.fixed;
    for (int tile = 0; tile < strata.soluble_thickness.tile_count(); ++tile) {
        if (strata.soluble_thickness.is_background(tile) && strata.soluble_pigment.is_background(tile))
            continue;
        const std::int32_t* thickness = strata.soluble_thickness.read(tile);
        const PigmentCell* pigment = strata.soluble_pigment.read(tile);
        for (int cell = 0; cell < grid::kTileCells; ++cell) {
            sums.thickness += thickness[cell];
            for (int k = 0; k < kPigmentChannels; ++k)
                sums.pigment[k] += pigment[cell][k];
        }
    }
    return sums;
}

void set_optics(int band, const pigment::LayerOptics<float>& optics, StrataOptics& strata) {
    const auto code = [](float share) {
        return static_cast<std::uint16_t>(std::clamp(share, 0.0F, 1.0F) * kOpticsCode + 0.5F);
    };
    strata[band] = code(optics.reflectance);
    strata[pigment::kBands + band] = code(optics.transmittance);
    strata[2 * pigment::kBands + band] = code(optics.reverse);
}

StrataOptics laid_over(const std::int32_t* pigment, const StrataOptics& lower) {
    StrataOptics result{};
    for (int band = 0; band < pigment::kBands; ++band) {
        const auto layer = pigment::layer_optics(optical_thickness(pigment[band]),
                                                 optical_thickness(pigment[band + pigment::kBands]));
        set_optics(band, pigment::laid_over(layer, optics_of(lower, band)), result);
    }
    return result;
}

StrataOptics laid_over(const StrataOptics& upper, const StrataOptics& lower) {
    StrataOptics result{};
    for (int band = 0; band < pigment::kBands; ++band)
        set_optics(band, pigment::laid_over(optics_of(upper, band), optics_of(lower, band)), result);
    return result;
}

}  // namespace pastoso::film
