// The picture of a painting under light, on the CPU: the reference for the window's shader and the
// renderer of every exported image.
#pragma once

#include "core/thread_pool.hpp"
#include "film/state.hpp"
#include "pigment/image.hpp"
#include "pigment/viewing.hpp"
#include "shade/surface.hpp"

#include <limits>
#include <vector>

namespace pastoso::shade {

/// One far light over an even sky, and how wet paint shines.
struct Lighting {
    double azimuth_deg = 135.0;   ///< where the light comes from: 0 right, 90 top, 180 left
    double elevation_deg = 36.0;  ///< above the canvas plane, 5 to 90
    double ambient = 0.30;        ///< share of the light that comes from the sky, 0 to 1
    double wet_roughness = 0.14;  ///< GGX alpha of wet paint, 0.05 to 1
    double dry_roughness = 0.60;  ///< of the bare support
    double shadow_softness_mm = 0.05;
    bool specular = true;
    friend bool operator==(const Lighting&, const Lighting&) = default;
};

struct CellLayers;

struct RenderSettings {
    double scale = 1.0;  ///< pixels per cell; the surface is interpolated, never the pixels
    Lighting lighting;
    pigment::Viewing viewing;  ///< the light's spectrum, and the space of the picture
    bool outlined = true;      ///< edges of paint are sharp where the picture is enlarged
    int most_samples = std::numeric_limits<int>::max();  ///< along a side of a pixel, at least 1
    /// Of the canvas and kLayersAround cells beyond it (cell_layers.hpp), where they are at hand; they
    /// outlive the renderer.
    const CellLayers* layers = nullptr;
};

/// Renders a region of the canvas, given in cells. The same bits on any number of threads.
pigment::LinearImage render(const film::FilmState& film, const pigment::Bands& ground,
                            const grid::Rect& cells, const RenderSettings& settings,
                            core::ThreadPool& pool);

/// What lies under a pixel, whatever light falls on it: means over the pixel.
struct SurfaceSample {
    float red = 0.0F, green = 0.0F, blue = 0.0F;  ///< the colour under even light, linear
    float wetness = 0.0F;                         ///< 0 dry to 1 wet
    float height_mm = 0.0F;                       ///< support and paint, above level 0 of the support
    float slope_x = 0.0F, slope_y = 0.0F;         ///< of the height; x runs right, y down
};

/// Row by row from the top.
struct SurfaceSamples {
    int width = 0, height = 0;
    std::vector<SurfaceSample> samples;
};

/// Even rows and columns of pixels on a canvas.
struct Lattice {
    double left_cells = 0.0, top_cells = 0.0;  ///< where the first pixel begins
    double scale_x = 1.0, scale_y = 1.0;       ///< pixels per cell
    int width = 0, height = 0;                 ///< in pixels
};

/// The pixels of a region of the canvas. Throws InputError when the scale is outside 1/64 to 64, the
/// region is not on the canvas, or a side is longer than 32768 pixels.
Lattice picture_lattice(const grid::Shape& canvas, const grid::Rect& cells, double scale);

/// Renders a large picture part by part: each part has the bits that it has in the whole, and takes the
/// memory of its own pixels and of the cells below them.
class Renderer {
  public:
    /// `film` and `pool` outlive the renderer. The scale of `settings` does not count.
    Renderer(const film::FilmState& film, const pigment::Bands& ground, const Lattice& lattice,
             const RenderSettings& settings, core::ThreadPool& pool);

    const Lattice& lattice() const { return lattice_; }

    /// The pixels of a rectangle under the light, or as they are; null for what is not wanted.
    void render(const grid::Rect& pixels, pigment::LinearImage* lit, SurfaceSamples* surface) const;

  private:
    const film::FilmState& film_;
    pigment::Bands ground_;
    Lattice lattice_;
    RenderSettings settings_;
    core::ThreadPool& pool_;
    HeightRange range_;  ///< of the whole canvas, where layers are made
};

}  // namespace pastoso::shade
