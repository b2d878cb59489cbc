// The picture of a painting under light, on the CPU: the reference for the window's shader and the
// renderer of every exported image.
#pragma once

#include "core/thread_pool.hpp"
#include "film/state.hpp"
#include "pigment/viewing.hpp"

#include <cstdint>
#include <vector>

namespace pastoso::shade {

/// A picture of linear-light values, row by row from the top, three floats a pixel.
struct LinearImage {
    int width = 0, height = 0;
    std::vector<float> rgb;
    pigment::WorkingSpace space = pigment::WorkingSpace::Srgb;
};

/// The same encoded for screens: eight bits, sRGB transfer curve, three bytes a pixel.
struct Image8 {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
    pigment::WorkingSpace space = pigment::WorkingSpace::Srgb;
};

/// The same in sixteen bits.
struct Image16 {
    int width = 0, height = 0;
    std::vector<std::uint16_t> rgb;
    pigment::WorkingSpace space = pigment::WorkingSpace::Srgb;
};

/// One far light over an even sky, and how wet paint shines.
struct Lighting {
    double azimuth_deg = 135.0;   ///< where the light comes from: 0 right, 90 top, 180 left
    double elevation_deg = 36.0;  ///< above the canvas plane, 5 to 90
    double ambient = 0.30;        ///< share of the light that comes from the sky, 0 to 1
    double wet_roughness = 0.14;  ///< GGX alpha of wet paint, 0.05 to 1
    double dry_roughness = 0.60;  ///< of the bare support
    double shadow_softness_mm = 0.05;
    bool specular = true;
};

struct RenderSettings {
    double scale = 1.0;  ///< pixels per cell; the surface is interpolated, never the pixels
    Lighting lighting;
    pigment::Viewing viewing;  ///< the light's spectrum, and the space of the picture
};

/// Renders a region of the canvas, given in cells. The same bits on any number of threads.
LinearImage render(const film::FilmState& film, const pigment::Bands& ground, const grid::Rect& cells,
                   const RenderSettings& settings, core::ThreadPool& pool);

/// Linear to 8 or 16 bits with the curve of sRGB, in the picture's own space; values outside its gamut
/// are brought in half by clipping, half by desaturation.
Image8 encode_srgb8(const LinearImage& image);
Image16 encode_srgb16(const LinearImage& image);

}  // namespace pastoso::shade
