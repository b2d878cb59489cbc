// The paints there are, by Colour Index name, and mixing them.
#pragma once

#include "pigment/bands.hpp"
#include "pigment/spectrum.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pastoso::pigment {

/// A full-strength paint of one pigment.
struct Pigment {
    std::string ci_name;          ///< Colour Index name, unique in a palette, for example "PB29"
    std::string name;             ///< what painters call it
    Coefficients coefficients{};  ///< the spectra below, reduced to the bands
    Spectrum absorption_per_mm{};
    Spectrum scattering_per_mm{};
};

/// Reads a CSV text: lines that start with # are skipped, then comes the heading
/// ci_name,name,coef,380,...,730 and per pigment one line whose coef is K and one whose coef is S, 36
/// values per mm each. `name` is the file's name for errors. Throws InputError that names line, column
/// and value: a missing or surplus column, text, a negative or infinite value, a pigment given twice or
/// by half.
std::vector<Pigment> parse_palette(std::string_view csv_text, const BandWeights& weights,
                                   const std::string& name);

/// The pigments that come with the program (resources/pigments), in the order of the file. Throws
/// InputError when the program's own files are missing or broken.
const std::vector<Pigment>& bundled_palette();

/// The windows of the bands that come with the program. Throws InputError like bundled_palette().
const BandWeights& bundled_band_weights();

/// The bundled pigment of that Colour Index name, or the user's own (pigment/user_pigments.hpp). Throws
/// InputError that suggests the nearest names, lists those there are, and says which of the user's files
/// could not be read.
const Pigment& find_pigment(std::string_view ci_name);

/// One part of a mixture; `parts` by volume, >= 0.
struct Portion {
    Coefficients coefficients{};
    double parts = 1.0;
};

/// The mixture's coefficients, sum(parts * coefficients) / sum(parts). Clear medium is a portion of
/// zeros. The parts must not all be 0.
Coefficients mix(std::span<const Portion> portions);

}  // namespace pastoso::pigment
