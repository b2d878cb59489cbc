// The tooth of a panel: gesso that was brushed on, line by line.
#include "core/check.hpp"
#include "film/support/gesso_kernel.hpp"
#include "film/support/smooth_noise.hpp"
#include "film/support/support.hpp"
#include "film/support/support_sampling.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace pastoso::film {
namespace {

/// Arrays are read and written as far as the widest registers reach.
constexpr std::size_t kBeyond = 16;

using Lengths = std::span<const double>;

/// Where a noise is looked up.
class NoisePlaces {
  public:
    void put(Lengths at_mm, double width_mm) {
        before_.clear();
        share_.clear();
        for (const double each_mm : at_mm) {
            const NoisePlace place = noise_place(each_mm / width_mm);
            before_.push_back(place.before);
            share_.push_back(place.share);
        }
    }
    NoiseColumns columns() const { return {before_.data(), share_.data()}; }

  private:
    std::vector<std::uint32_t> before_;
    std::vector<float> share_;
};

enum class Lines { AlongMarks, AcrossMarks };

/// Brush marks in gesso, long and narrow, in two widths, over a fine grain; seen along parallel lines.
template <Lines kLines>
class Coat {
  public:
    /// The lines' columns, those beyond included.
    explicit Coat(std::vector<double> columns_mm) : columns_mm_(std::move(columns_mm)) {
        if constexpr (kLines == Lines::AlongMarks)
            put_along(columns_mm_);
        else
            put_across(columns_mm_);
        heights_.resize(columns_mm_.size());
    }

    /// Of the columns, from 0 to 1.
    const std::vector<float>& heights(double line_mm) {
        const GessoKernels& kernels = core::kernels<GessoKernels>();
        if constexpr (kLines == Lines::AlongMarks) {
            put_across({&line_mm, 1});
            kernels.along_marks(line(&line_mm), heights_.data());
        } else {
            put_along({&line_mm, 1});
            kernels.across_marks(line(columns_mm_.data()), heights_.data());
        }
        return heights_;
    }

  private:
    void put_along(Lengths at_mm) {
        drift_along_.put(at_mm, kGessoDrift.along_mm);
        broad_along_.put(at_mm, kBroadMarks.along_mm);
        fine_along_.put(at_mm, kFineMarks.along_mm);
        grain_along_.put(at_mm, kGessoGrain.along_mm);
    }

    void put_across(Lengths at_mm) {
        drift_across_.put(at_mm, kGessoDrift.across_mm);
        grain_across_.put(at_mm, kGessoGrain.across_mm);
    }

    GessoLine line(const double* across_mm) const {
        return {.count = static_cast<int>(columns_mm_.size() - kBeyond),
                .drift_along = drift_along_.columns(),
                .broad_along = broad_along_.columns(),
                .fine_along = fine_along_.columns(),
                .grain_along = grain_along_.columns(),
                .drift_across = drift_across_.columns(),
                .grain_across = grain_across_.columns(),
                .across_mm = across_mm};
    }

    std::vector<double> columns_mm_;
    NoisePlaces drift_along_, broad_along_, fine_along_, grain_along_, drift_across_, grain_across_;
    std::vector<float> heights_;
};

/// One coat, from left to right.
class SingleCoat {
  public:
    explicit SingleCoat(const std::vector<double>& x_mm) : coat_(x_mm) {}

    void put_heights(double y_mm, std::span<float> heights) {
        std::copy_n(coat_.heights(y_mm).begin(), heights.size(), heights.begin());
    }

  private:
    Coat<Lines::AlongMarks> coat_;
};

/// A second coat, laid across the first with a brush three times as broad.
class CrossedCoats {
  public:
    explicit CrossedCoats(const std::vector<double>& x_mm) : first_(x_mm), second_(narrower(x_mm)) {}

    void put_heights(double y_mm, std::span<float> heights) {
        const std::vector<float>&first = first_.heights(y_mm),
              &second = second_.heights(y_mm / kBroader + 500.0);
        for (std::size_t k = 0; k < heights.size(); ++k)
            heights[k] = 0.45F * first[k] + 0.55F * second[k];
    }

  private:
    static constexpr double kBroader = 3.0;

    static std::vector<double> narrower(std::vector<double> x_mm) {
        for (double& each : x_mm)
            each /= kBroader;
        return x_mm;
    }

    Coat<Lines::AlongMarks> first_;
    Coat<Lines::AcrossMarks> second_;
};

/// Of the cells' samples, and of those beyond.
std::vector<double> sampled_places(std::int64_t first, std::size_t count, double step_mm) {
    std::vector<double> places_mm(count + kBeyond);
    for (std::size_t k = 0; k < places_mm.size(); ++k)
        places_mm[k] = (static_cast<double>(first) + static_cast<double>(k) + 0.5) * step_mm;
    return places_mm;
}

template <class Coats>
SupportHeights gesso_support(grid::Shape shape, double cell_mm, double relief_mm, core::ThreadPool& pool,
                             SupportForm form, const ClothPlace& place) {
    const int samples = samples_per_cell(cell_mm, kFineMarks.across_mm / 2.0);
    const std::vector<double> x_mm =
        sampled_places(std::int64_t{place.x0} * samples, static_cast<std::size_t>(shape.width) * samples,
                       cell_mm / samples);
    return sampled_in(form, {shape, place.y0}, samples, relief_mm, pool, [&] {
        return [cell_mm, coats = Coats(x_mm)](double y_cells, std::span<float> heights) mutable {
            coats.put_heights(y_cells * cell_mm, heights);
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
