// The tooth of a panel: gesso that was brushed on, line by line.
#include "core/check.hpp"
#include "film/support/smooth_noise.hpp"
#include "film/support/support.hpp"
#include "film/support/support_sampling.hpp"

#include <algorithm>
#include <vector>

namespace pastoso::film {
namespace {

constexpr double kFineBrushMark_mm = 0.3;

/// Places along a line.
using Places = std::vector<double>;

/// Brush marks in gesso, long in x and narrow in y, in two widths, over a fine grain.
class Gesso {
  public:
    void put_heights(const Places& x_mm, const Places& y_mm, std::vector<float>& heights) {
        put(drift_, x_mm, 40.0, y_mm, 60.0, drifts_);
        drifted_mm_.resize(y_mm.size());
        for (std::size_t k = 0; k < y_mm.size(); ++k)
            drifted_mm_[k] = y_mm[k] + 3.0 * drifts_[k];
        put(broad_, x_mm, 30.0, drifted_mm_, 1.2, broads_);
        put(fine_, x_mm, 9.0, drifted_mm_, kFineBrushMark_mm, fines_);
        put(grain_, x_mm, 0.6, y_mm, 0.4, grains_);
        heights.resize(x_mm.size());
        for (std::size_t k = 0; k < heights.size(); ++k)
            heights[k] = 0.4F * broads_[k] + 0.4F * fines_[k] + 0.2F * grains_[k];
    }

  private:
    void put(const NoiseLine& noise, const Places& x_mm, double along_mm, const Places& y_mm,
             double across_mm, std::vector<float>& values) {
        places_.resize(x_mm.size());
        for (std::size_t k = 0; k < places_.size(); ++k)
            places_[k] = noise_place(x_mm[k] / along_mm, y_mm[k] / across_mm);
        values.resize(places_.size());
        noise.put(places_, values);
    }

    NoiseLine drift_{1}, broad_{2}, fine_{3}, grain_{4};
    Places drifted_mm_;
    std::vector<NoisePlace> places_;
    std::vector<float> drifts_, broads_, fines_, grains_;
};

/// One coat.
class SingleCoat {
  public:
    void put_heights(const Places& x_mm, double y_mm, std::span<float> heights) {
        y_mm_.assign(x_mm.size(), y_mm);
        coat_.put_heights(x_mm, y_mm_, found_);
        std::copy(found_.begin(), found_.end(), heights.begin());
    }

  private:
    Gesso coat_;
    Places y_mm_;
    std::vector<float> found_;
};

/// A second coat, laid across the first with a brush three times as broad.
class CrossedCoats {
  public:
    void put_heights(const Places& x_mm, double y_mm, std::span<float> heights) {
        constexpr double kBroader = 3.0;
        first_.put_heights(x_mm, y_mm, heights);
        along_mm_.assign(x_mm.size(), y_mm / kBroader + 500.0);
        across_mm_.resize(x_mm.size());
        for (std::size_t k = 0; k < x_mm.size(); ++k)
            across_mm_[k] = x_mm[k] / kBroader;
        second_.put_heights(along_mm_, across_mm_, found_);
        for (std::size_t k = 0; k < heights.size(); ++k)
            heights[k] = 0.45F * heights[k] + 0.55F * found_[k];
    }

  private:
    SingleCoat first_;
    Gesso second_;
    Places along_mm_, across_mm_;
    std::vector<float> found_;
};

template <class Coats>
SupportHeights gesso_support(grid::Shape shape, double cell_mm, double relief_mm, core::ThreadPool& pool,
                             SupportForm form, const ClothPlace& place) {
    const int samples = samples_per_cell(cell_mm, kFineBrushMark_mm / 2.0);
    const double first_sample = static_cast<double>(place.x0) * samples, step_mm = cell_mm / samples;
    Places x_mm(static_cast<std::size_t>(shape.width) * samples);
    for (std::size_t k = 0; k < x_mm.size(); ++k)
        x_mm[k] = (first_sample + static_cast<double>(k) + 0.5) * step_mm;
    return sampled_in(form, {shape, place.y0}, samples, relief_mm, pool, [&] {
        return [&x_mm, cell_mm, coats = Coats()](double y_cells, std::span<float> heights) mutable {
            coats.put_heights(x_mm, y_cells * cell_mm, heights);
        };
    });
}

}  // namespace

SupportHeights panel_support(grid::Shape shape, double cell_mm, double relief_mm, GessoCoats coats,
                             core::ThreadPool& pool, SupportForm form, const ClothPlace& place) {
    PASTOSO_CHECK_OP(cell_mm, >, 0.0);
    return coats == GessoCoats::One
               ? gesso_support<SingleCoat>(shape, cell_mm, relief_mm, pool, form, place)
               : gesso_support<CrossedCoats>(shape, cell_mm, relief_mm, pool, form, place);
}

}  // namespace pastoso::film
