#include "film/laboratory/scene_forms.hpp"

#include "core/check.hpp"
#include "core/random.hpp"
#include "core/units.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::film {
namespace {

constexpr int kOutlineSamples = 16;
constexpr int kSmoothSamples = 4;

double distance2(const Point& centre, double x_mm, double y_mm) {
    const double dx = x_mm - centre.x_mm, dy = y_mm - centre.y_mm;
    return dx * dx + dy * dy;
}

/// Mean of height(x_mm, y_mm) over samples x samples points of the cell.
template <class Height>
double mean_of(int x, int y, double cell_mm, int samples, const Height& height) {
    const double step_mm = cell_mm / samples;
    double sum = 0.0;
    for (int j = 0; j < samples; ++j) {
        for (int i = 0; i < samples; ++i)
            sum += height(x * cell_mm + (i + 0.5) * step_mm, y * cell_mm + (j + 0.5) * step_mm);
    }
    return sum / (samples * samples);
}

/// The share of [first, first + 1) that [begin, end) covers.
double overlap(int first, double begin, double end) {
    return std::max(0.0, std::min(end, first + 1.0) - std::max(begin, static_cast<double>(first)));
}

struct CellMean {
    int x, y;
    double cell_mm;
    double thickness_mm;

    double operator()(const Slab&) const { return thickness_mm; }
    double operator()(const Box& box) const {
        return thickness_mm * overlap(x, box.area.x0_mm / cell_mm, box.area.x1_mm / cell_mm) *
               overlap(y, box.area.y0_mm / cell_mm, box.area.y1_mm / cell_mm);
    }
    double operator()(const Disc& disc) const {
        const double radius2 = disc.radius_mm * disc.radius_mm;
        return thickness_mm * mean_of(x, y, cell_mm, kOutlineSamples, [&](double at_x, double at_y) {
                   return distance2(disc.centre, at_x, at_y) < radius2 ? 1.0 : 0.0;
               });
    }
    double operator()(const SphericalCap& cap) const {
        const double base2 = cap.radius_mm * cap.radius_mm;
        const double sphere_mm = (base2 + thickness_mm * thickness_mm) / (2.0 * thickness_mm);
        return mean_of(x, y, cell_mm, kOutlineSamples, [&](double at_x, double at_y) {
            const double r2 = distance2(cap.centre, at_x, at_y);
            return r2 < base2 ? std::sqrt(sphere_mm * sphere_mm - r2) - (sphere_mm - thickness_mm) : 0.0;
        });
    }
    double operator()(const Gaussian& gaussian) const {
        const double exponent = -0.5 / (gaussian.deviation_mm * gaussian.deviation_mm);
        return thickness_mm * mean_of(x, y, cell_mm, kSmoothSamples, [&](double at_x, double at_y) {
                   return std::exp(exponent * distance2(gaussian.centre, at_x, at_y));
               });
    }
    double operator()(const Cosine& wave) const {
        const double wavenumber = 2.0 * core::kPi / wave.wavelength_mm;
        const double kx = wavenumber * std::cos(core::radians(wave.direction_deg));
        const double ky = wavenumber * std::sin(core::radians(wave.direction_deg));
        const double phase = core::radians(wave.phase_deg);
        return thickness_mm * mean_of(x, y, cell_mm, kSmoothSamples, [&](double at_x, double at_y) {
                   return 0.5 + 0.5 * std::cos(kx * at_x + ky * at_y - phase);
               });
    }
    double operator()(const WhiteNoise& noise) const {
        const std::uint32_t row = core::scramble(static_cast<std::uint32_t>(y) ^ noise.seed);
        return thickness_mm * core::uniform_noise(static_cast<std::uint32_t>(x), row);
    }
    double operator()(const GreyMap&) const {
        PASTOSO_CHECK(!"an image is resampled as a whole");
        return 0.0;
    }
    double operator()(const CellValues&) const {
        PASTOSO_CHECK(!"values of cells need no mean");
        return 0.0;
    }
};

grid::Rect cells_around(const Point& centre, double radius_mm, double cell_mm) {
    const auto cell = [cell_mm](double at_mm) { return static_cast<int>(std::floor(at_mm / cell_mm)); };
    return {cell(centre.x_mm - radius_mm), cell(centre.y_mm - radius_mm),
            cell(centre.x_mm + radius_mm) + 1, cell(centre.y_mm + radius_mm) + 1};
}

}  // namespace

grid::Rect reach_of(const Form& form, grid::Shape shape, double cell_mm) {
    if (const auto* disc = std::get_if<Disc>(&form))
        return grid::intersection(shape.cells(), cells_around(disc->centre, disc->radius_mm, cell_mm));
    if (const auto* cap = std::get_if<SphericalCap>(&form))
        return grid::intersection(shape.cells(), cells_around(cap->centre, cap->radius_mm, cell_mm));
    return shape.cells();
}

double mean_thickness_mm(const Primitive& primitive, int x, int y, double cell_mm) {
    return std::visit(CellMean{x, y, cell_mm, primitive.thickness_mm}, primitive.form);
}

}  // namespace pastoso::film
