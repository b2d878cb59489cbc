// The lights that a painting can be looked at under, by their spectra.
#pragma once

#include "pigment/spectrum.hpp"

#include <array>
#include <string>
#include <string_view>

namespace pastoso::pigment {

struct Illuminant {
    std::string name;  ///< as it was asked for: "D65", or the path of a file
    Spectrum power{};  ///< relative spectral power
};

/// The lights that come with the program (resources/illuminants), of CIE 015:2018: daylight, the light
/// of print viewing booths, an incandescent lamp, a phosphor LED (LED-B3).
inline constexpr std::array kBundledIlluminants = {"D65", "D50", "A", "LED"};

/// Reads a CSV text: lines that start with # are skipped, a heading "wavelength_nm,power" may stand
/// first, then one reading a line, wavelengths ascending from 400 or less to 700 or more, powers >= 0 in
/// any unit. A sample lies on the straight line between the readings around it; where readings stand
/// closer than the samples it is their mean under a triangle of 10 nm to either side, so that the lines
/// of a lamp keep their share. Beyond the readings their first and last value hold. `name` is the file's
/// name for errors. Throws InputError that names line and value; also when the light is so nearly a pure
/// colour that no eye sees white under it.
Illuminant parse_illuminant(std::string_view csv_text, const std::string& name);

/// A bundled light by its name, in capitals or not, or the light in the CSV file at that path. Throws
/// InputError that names the lights there are when it is neither.
Illuminant find_illuminant(const std::string& name_or_path);

}  // namespace pastoso::pigment
