#include "pigment/spectrum.hpp"

#include "core/error.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

namespace pastoso::pigment {
namespace {

constexpr const char* kWeightsKey = "weights_380_730_10nm";

/// The files are written with 16 digits; a window further from 1 than this is not a mean any more.
constexpr double kSumTolerance = 1e-9;

core::Message band_label(const std::string& name, std::size_t band) {
    return core::message("%1: band %2 of \"%3\"", name, band + 1, kWeightsKey);
}

double parse_weight(const nlohmann::json& value, const core::Message& label, int sample) {
    const int wavelength_nm = kFirstWavelength_nm + kWavelengthStep_nm * sample;
    if (!value.is_number())
        throw core::InputError("%1, %2 nm: %3 is not a number.", label, wavelength_nm, value.dump());
    const double weight = value.get<double>();
    if (!(weight >= 0.0))
        throw core::InputError("%1, %2 nm: the weight %3 is negative.", label, wavelength_nm,
                               value.dump());
    return weight;
}

Spectrum parse_window(const nlohmann::json& row, const core::Message& label) {
    if (!row.is_array() || row.size() != kSpectralSamples)
        throw core::InputError("%1 is not a list of %2 numbers.", label, kSpectralSamples);
    Spectrum window{};
    double sum = 0.0;
    for (int i = 0; i < kSpectralSamples; ++i)
        sum += window[i] = parse_weight(row[i], label, i);
    if (std::abs(sum - 1.0) > kSumTolerance)
        throw core::InputError("%1: the weights add up to %2 instead of 1.", label, std::to_string(sum));
    return window;
}

}  // namespace

BandWeights parse_band_weights(std::string_view json_text, const std::string& name) {
    const nlohmann::json root = nlohmann::json::parse(json_text, nullptr, false);
    if (root.is_discarded()) throw core::InputError("%1: this is not valid JSON.", name);
    if (!root.is_object() || !root.contains(kWeightsKey))
        throw core::InputError("%1: the entry \"%2\" is missing.", name, kWeightsKey);
    const nlohmann::json& rows = root[kWeightsKey];
    if (!rows.is_array() || rows.size() != kBands)
        throw core::InputError("%1: \"%2\" is not a list of %3 bands.", name, kWeightsKey, kBands);
    BandWeights weights{};
    for (std::size_t band = 0; band < kBands; ++band) {
        weights[band] = parse_window(rows[band], band_label(name, band));
    }
    return weights;
}

Bands reduce_to_bands(const Spectrum& spectrum, const BandWeights& weights) {
    Bands bands{};
    for (int band = 0; band < kBands; ++band) {
        double sum = 0.0;
        for (int i = 0; i < kSpectralSamples; ++i)
            sum += weights[band][i] * spectrum[i];
        bands[band] = static_cast<float>(sum);
    }
    return bands;
}

}  // namespace pastoso::pigment
