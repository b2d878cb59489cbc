// Spectra as the palette's files hold them, and the windows that reduce them to the six bands.
#pragma once

#include "pigment/bands.hpp"

#include <array>
#include <string>
#include <string_view>

namespace pastoso::pigment {

inline constexpr int kSpectralSamples = 36;
inline constexpr int kFirstWavelength_nm = 380;
inline constexpr int kWavelengthStep_nm = 10;

/// One value every 10 nm from 380 to 730 nm.
using Spectrum = std::array<double, kSpectralSamples>;

/// One window per band: the weights of the 36 samples, all >= 0, of sum 1.
using BandWeights = std::array<Spectrum, kBands>;

/// Reads "weights_380_730_10nm" of a JSON object (resources/pigments/bands_6.json shows the form).
/// `name` is the file's name for errors. Throws InputError that names the band, the wavelength and the
/// value.
BandWeights parse_band_weights(std::string_view json_text, const std::string& name);

/// The weighted mean of a spectrum in every band.
Bands reduce_to_bands(const Spectrum& spectrum, const BandWeights& weights);

}  // namespace pastoso::pigment
