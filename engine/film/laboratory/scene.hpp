// A film without a brush, as plain data: what it lies on, how thick it is at first, what kind of paint
// it is and which forces act on it. Experiments and proofs describe themselves so
// (docs/scene-format.md).
#pragma once

#include "film/solver.hpp"
#include "film/support/support.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace pastoso::film {

/// Millimetres from the upper left corner of the canvas, x right, y down.
struct Point {
    double x_mm = 0.0, y_mm = 0.0;
};
struct Area {
    double x0_mm = 0.0, y0_mm = 0.0, x1_mm = 0.0, y1_mm = 0.0;
};

/// A grey image stretched over the canvas: width * height values in [0, 1], row by row.
struct GreyMap {
    int width = 0, height = 0;
    std::vector<float> grey;
};

/// A value for every cell of the canvas, row by row, in memory of whoever makes the film; it is read
/// then, and not after.
struct CellValues {
    std::span<const float> values;
};

/// One of the supports that come with the program; relief 0: its own.
struct BundledRelief {
    std::string name;
    double relief_mm = 0.0;
};
struct ImageRelief {  ///< black lies at low_mm, white at high_mm
    GreyMap map;
    double low_mm = 0.0, high_mm = 0.5;
};
struct Ramp {  ///< rises by `slope` per length towards direction_deg, from 0 at the lowest corner
    double slope = 0.0;
    double direction_deg = 0.0;  ///< 0 right, 90 to the lower edge
};
struct Bump {  ///< height_mm exp(-r^2 / (2 deviation^2))
    Point centre;
    double height_mm = 0.0, deviation_mm = 1.0;
};
struct CellHeights : CellValues {};  ///< mm
using Relief = std::variant<BundledRelief, Weave, ImageRelief, Ramp, Bump, CellHeights>;

/// The forms of paint, each scaled by the thickness of its primitive.
struct Slab {};  ///< everywhere
struct Box {
    Area area;
};
struct Disc {
    Point centre;
    double radius_mm = 1.0;
};
struct SphericalCap {  ///< of this base radius; the thickness, at most the radius, is its height
    Point centre;
    double radius_mm = 1.0;
};
struct Gaussian {  ///< exp(-r^2 / (2 deviation^2))
    Point centre;
    double deviation_mm = 1.0;
};
struct Cosine {  ///< (1 + cos(2 pi s / wavelength - phase)) / 2, s along direction_deg from the corner
    double wavelength_mm = 1.0;
    double direction_deg = 0.0;
    double phase_deg = 0.0;
};
struct WhiteNoise {  ///< independent in every cell, uniform from 0 to 1
    std::uint32_t seed = 1;
};
using Form =
    std::variant<Slab, Box, Disc, SphericalCap, Gaussian, Cosine, WhiteNoise, GreyMap, CellValues>;

struct Primitive {
    Form form;
    double thickness_mm = 0.0;
    pigment::Coefficients pigment{};    ///< per mm; zeros: clear medium
    std::optional<Medium> medium = {};  ///< its own kind of paint, instead of the scene's
};

struct Scene {
    grid::Shape shape;
    double cell_mm = 0.25;
    std::vector<Relief> support;  ///< heights add up; none: flat
    std::vector<Primitive> film;  ///< thicknesses and pigments add up
    Medium medium;
    Gravity gravity;
    SolverOptions solver;
    double duration_s = 1.0;
};

/// The highest support, below which floats hold surface, support and thickness exactly (support.hpp).
inline constexpr double kMaxSupport_mm = 16.0;

/// The support's heights: cell means of the sum of its reliefs, in multiples of kSupportQuantum_mm.
/// Throws InputError when they leave 0 to kMaxSupport_mm, for an unknown bundled relief, and where there
/// is not a height for every cell.
SupportHeights make_support(const Scene& scene);

/// The film at time 0, at rest: cell means of the primitives, rounded to whole quanta; the pigment of a
/// cell is sum(thickness * coefficients). A box is exact; other outlines are sampled at 16 x 16 points a
/// cell, smooth forms at 4 x 4. Throws InputError when a cell would hold more than kMaxThickness_mm or
/// less than nothing, and where there is not a value for every cell.
FilmState make_film(const Scene& scene);

}  // namespace pastoso::film
