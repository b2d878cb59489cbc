#include "pigment/spectrum.hpp"

#include "core/error.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

namespace pastoso::pigment {
namespace {

constexpr const char* kWeightsKey = "weights_380_730_10nm";

/// The files are written with 16 digits; a window further from 1 than this is not a mean any more.
constexpr double kSumTolerance = 1e-9;

std::string band_label(const std::string& name, std::size_t band) {
    return name + ": band " + std::to_string(band + 1) + " of \"" + kWeightsKey + "\"";
}

double parse_weight(const nlohmann::json& value, const std::string& label, int sample) {
    const int wavelength_nm = kFirstWavelength_nm + kWavelengthStep_nm * sample;
    const std::string place = label + ", " + std::to_string(wavelength_nm) + " nm: ";
    if (!value.is_number()) throw core::InputError(place + value.dump() + " is not a number.");
    const double weight = value.get<double>();
    if (!(weight >= 0.0)) throw core::InputError(place + "the weight " + value.dump() + " is negative.");
    return weight;
}

Spectrum parse_window(const nlohmann::json& row, const std::string& label) {
    if (!row.is_array() || row.size() != kSpectralSamples) {
        throw core::InputError(label + " is not a list of " + std::to_string(kSpectralSamples) +
                               " numbers.");
    }
    Spectrum window{};
    double sum = 0.0;
    for (int i = 0; i < kSpectralSamples; ++i)
        sum += window[i] = parse_weight(row[i], label, i);
    if (std::abs(sum - 1.0) > kSumTolerance) {
        throw core::InputError(label + ": the weights add up to " + std::to_string(sum) +
                               " instead of 1.");
    }
    return window;
}

}  // namespace

BandWeights parse_band_weights(std::string_view json_text, const std::string& name) {
    const nlohmann::json root = nlohmann::json::parse(json_text, nullptr, false);
    if (root.is_discarded()) throw core::InputError(name + ": this is not valid JSON.");
    if (!root.is_object() || !root.contains(kWeightsKey)) {
        throw core::InputError(name + ": the entry \"" + kWeightsKey + "\" is missing.");
    }
    const nlohmann::json& rows = root[kWeightsKey];
    if (!rows.is_array() || rows.size() != kBands) {
        throw core::InputError(name + ": \"" + kWeightsKey + "\" is not a list of " +
                               std::to_string(kBands) + " bands.");
    }
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
