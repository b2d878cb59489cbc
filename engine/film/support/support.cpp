#include "film/support/support.hpp"

#include "core/check.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "film/support/support_sampling.hpp"
#include "grid/bspline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace pastoso::film {
namespace {

constexpr Weave kLinen{};
constexpr Weave kCottonDuck{.thread_pitch_mm = 0.6,
                            .relief_mm = 0.08,
                            .irregularity = 0.4,
                            .thread_width = 0.92,
                            .pairing = 0.06};
constexpr Weave kFinePortraitLinen{.thread_pitch_mm = 0.46,
                                   .relief_mm = 0.06,
                                   .irregularity = 0.7,
                                   .thread_width = 0.94,
                                   .weft_pitch = 1.08,
                                   .drift = 0.04,
                                   .unevenness = 0.2,
                                   .slubs_per_m = 0.2,
                                   .twist = 0.06,
                                   .nap = 0.08,
                                   .averaged = true};
constexpr Weave kMediumLinen{.thread_pitch_mm = 0.7,
                             .relief_mm = 0.11,
                             .irregularity = 0.9,
                             .thread_width = 0.92,
                             .weft_pitch = 1.14,
                             .drift = 0.05,
                             .unevenness = 0.24,
                             .slubs_per_m = 0.3,
                             .twist = 0.12,
                             .nap = 0.1,
                             .averaged = true};
constexpr Weave kRoughJute{.thread_pitch_mm = 1.7,
                           .relief_mm = 0.34,
                           .irregularity = 1.0,
                           .thread_width = 0.88,
                           .weft_pitch = 1.1,
                           .drift = 0.06,
                           .unevenness = 0.25,
                           .slubs_per_m = 0.5,
                           .twist = 0.18,
                           .nap = 0.14,
                           .averaged = true};
constexpr double kPanelRelief_mm = 0.02, kGessoRelief_mm = 0.06;

struct NamedWeave {
    std::string_view name;
    Weave weave;
};
constexpr NamedWeave kWeaves[] = {{"fine portrait linen", kFinePortraitLinen},
                                  {"medium linen", kMediumLinen},
                                  {"rough jute", kRoughJute},
                                  {"linen", kLinen},
                                  {"cotton duck", kCottonDuck}};
struct NamedPanel {
    std::string_view name;
    double relief_mm;
    GessoCoats coats;
};
constexpr NamedPanel kPanels[] = {{"gesso panel", kGessoRelief_mm, GessoCoats::Crossed},
                                  {"panel", kPanelRelief_mm, GessoCoats::One}};

/// B-spline coefficients of a grey image whose pixels are means over their area.
class SplineImage {
  public:
    SplineImage(const std::vector<float>& grey, int width, int height) : width_(width), height_(height) {
        PASTOSO_CHECK(width > 0 && height > 0);
        PASTOSO_CHECK_OP(grey.size(), ==,
                         static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        coefficients_ = prefiltered(prefiltered(grey, 1, 0), 0, 1);
    }

    /// x and y in pixels from the upper left corner; beyond the edges the outermost pixels go on.
    float at(double x, double y) const {
        const double left = std::floor(x - 0.5);
        const double top = std::floor(y - 0.5);
        const auto weights_x = grid::bspline_weights(static_cast<float>(x - 0.5 - left)).value;
        const auto weights_y = grid::bspline_weights(static_cast<float>(y - 0.5 - top)).value;
        float height = 0.0F;
        for (int row = 0; row < 4; ++row) {
            for (int column = 0; column < 4; ++column) {
                height += weights_y[row] * weights_x[column] *
                          pixel(coefficients_, static_cast<int>(left) + column - 1,
                                static_cast<int>(top) + row - 1);
            }
        }
        return std::clamp(height, 0.0F, 1.0F);
    }

  private:
    float pixel(const std::vector<float>& values, int x, int y) const {
        const int row = std::clamp(y, 0, height_ - 1);
        return values[static_cast<std::size_t>(row) * width_ + std::clamp(x, 0, width_ - 1)];
    }

    std::vector<float> prefiltered(const std::vector<float>& values, int step_x, int step_y) const {
        std::vector<float> filtered(values.size());
        std::size_t index = 0;
        for (int y = 0; y < height_; ++y) {
            for (int x = 0; x < width_; ++x, ++index) {
                for (int tap = 0; tap < static_cast<int>(grid::kPrefilterTaps.size()); ++tap) {
                    const int offset = tap - grid::kPrefilterReach;
                    filtered[index] += grid::kPrefilterTaps[tap] *
                                       pixel(values, x + offset * step_x, y + offset * step_y);
                }
            }
        }
        return filtered;
    }

    int width_, height_;
    std::vector<float> coefficients_;
};

/// An image as large as a canvas.
struct StretchedImage {
    StretchedImage(grid::Shape shape, const std::vector<float>& grey, int width, int height)
        : image(grey, width, height),
          pixels_per_cell_x(static_cast<double>(width) / shape.width),
          pixels_per_cell_y(static_cast<double>(height) / shape.height),
          samples(samples_per_cell(std::max(pixels_per_cell_x, pixels_per_cell_y), 1.0)) {}

    void fill_row(double y_cells, std::span<float> heights) const {
        for (std::size_t k = 0; k < heights.size(); ++k) {
            const double x_cells = (static_cast<double>(k) + 0.5) / samples;
            heights[k] = image.at(x_cells * pixels_per_cell_x, y_cells * pixels_per_cell_y);
        }
    }

    SplineImage image;
    double pixels_per_cell_x, pixels_per_cell_y;
    int samples;
};

}  // namespace

SupportHeights image_support(grid::Shape shape, const std::vector<float>& grey, int width, int height,
                             double relief_mm, core::ThreadPool& pool) {
    const StretchedImage image(shape, grey, width, height);
    return sampled_levels({shape}, image.samples, relief_mm, pool, [&] {
        return [&](double y_cells, std::span<float> heights) { image.fill_row(y_cells, heights); };
    });
}

SupportHeights image_heights(grid::Shape shape, const std::vector<float>& grey, int width, int height,
                             double relief_mm) {
    const StretchedImage image(shape, grey, width, height);
    return sampled_heights(
        {shape}, image.samples, relief_mm,
        [&](double y_cells, std::span<float> heights) { image.fill_row(y_cells, heights); });
}

const std::vector<std::string>& support_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const NamedWeave& cloth : kWeaves)
            all.emplace_back(cloth.name);
        for (const NamedPanel& panel : kPanels)
            all.emplace_back(panel.name);
        return all;
    }();
    return names;
}

SupportHeights named_support(std::string_view name, grid::Shape shape, double cell_mm, double relief_mm,
                             core::ThreadPool& pool, SupportForm form, const ClothPlace& place) {
    const std::string wanted = core::lower_case(name);
    for (const NamedPanel& panel : kPanels) {
        if (panel.name != wanted) continue;
        return panel_support(shape, cell_mm, relief_mm > 0.0 ? relief_mm : panel.relief_mm, panel.coats,
                             pool, form, place);
    }
    for (const NamedWeave& cloth : kWeaves) {
        if (cloth.name != wanted) continue;
        Weave weave = cloth.weave;
        if (relief_mm > 0.0) weave.relief_mm = relief_mm;
        return woven_support(shape, cell_mm, weave, pool, form, place);
    }
    throw core::InputError("There is no support \"%1\"; the supports are: %2.", name,
                           core::listed(support_names()));
}

SupportForm form_of(const SupportHeights& named_mm) {
    return named_mm.block(0).in_levels() ? SupportForm::Levels : SupportForm::Fine;
}

}  // namespace pastoso::film
