// The relief of a primed plain weave, line by line. Warp threads run along y, weft threads along x.
#include "core/check.hpp"
#include "film/support/smooth_noise.hpp"
#include "film/support/support.hpp"
#include "film/support/support_sampling.hpp"
#include "film/support/threads.hpp"
#include "film/support/weave_kernel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace pastoso::film {
namespace {

/// What of a cloth's relief cells show: none of threads finer than two cells.
float shown_share(const Weave& weave, double column_mm) {
    if (!weave.averaged) return 1.0F;
    const double finer = std::min(1.0, weave.weft_pitch) * weave.thread_pitch_mm / column_mm;
    return static_cast<float>(std::clamp(0.5 * finer - 1.0, 0.0, 1.0));
}

/// Arrays are read and written as far as the widest registers reach.
constexpr std::size_t kBeyond = 16;

/// Writes a number from `begin` to `end`, and perhaps over some of kBeyond places behind: threads are
/// narrow, and a loop of fixed length needs no other.
void fill_stretch(std::vector<float>& values, std::size_t begin, std::size_t end, float value) {
    for (std::size_t k = begin; k < end; k += kBeyond)
        std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(k), kBeyond, value);
}

/// Noise of loose fibres along lines, between the two whole places on both sides of them.
class Fibres {
  public:
    /// At these places, which are ascending.
    Fibres(const std::vector<float>& u, double fibre_pitches)
        : plane_(core::scramble(static_cast<std::uint32_t>(Direction::Warp) + 11)),
          line_pitches_(3.0 * fibre_pitches),
          above_(u.size()),
          below_(u.size()) {
        for (const float each : u) {
            const NoisePlace place = noise_place(each / fibre_pitches);
            columns_.push_back(place.before);
            shares_.push_back(place.share);
        }
    }

    void find(float v) {
        const NoisePlace place = noise_place(v / line_pitches_);
        share_ = place.share;
        const std::uint32_t row = plane_ + place.before;
        if (row_ == row) return;
        if (row_ && *row_ + 1 == row)
            above_.swap(below_);
        else
            put_row(row, above_);
        put_row(row + 1, below_);
        row_ = row;
    }

    const float* above() const { return above_.data(); }
    const float* below() const { return below_.data(); }
    float share() const { return share_; }

  private:
    void put_row(std::uint32_t stream, std::vector<float>& out) const {
        for (std::size_t k = 0; k < out.size();) {
            const std::uint32_t column = columns_[k];
            const float before = core::uniform_noise(column, stream),
                        after = core::uniform_noise(column + 1, stream);
            for (; k < out.size() && columns_[k] == column; ++k)
                out[k] = before + shares_[k] * (after - before);
        }
    }

    std::uint32_t plane_;
    double line_pitches_;
    float share_ = 0.0F;
    std::optional<std::uint32_t> row_{};
    std::vector<std::uint32_t> columns_;
    std::vector<float> shares_, above_, below_;
};

/// The places of `columns` columns from the cloth's `first` on, and of those beyond.
std::vector<double> places_of(std::int64_t first, std::size_t columns, double column_pitches) {
    std::vector<double> places(columns + kBeyond);
    for (std::size_t k = 0; k < places.size(); ++k)
        places[k] = (static_cast<double>(first + static_cast<std::int64_t>(k)) + 0.5) * column_pitches;
    return places;
}

/// Scans the cloth line by line, and keeps what the lines have in common.
class ClothScanner {
  public:
    /// `first_column` is the cloth's; there are `columns` of them. Cells show `shown` of the relief.
    ClothScanner(const Weave& weave, std::int64_t first_column, std::size_t columns,
                 double column_pitches, float shown)
        : places_(places_of(first_column, columns, column_pitches)),
          u_(places_.begin(), places_.end()),
          first_warp_(static_cast<int>(std::floor(static_cast<double>(first_column) * column_pitches)) -
                      2),
          warp_(weave, Direction::Warp, first_warp_,
                static_cast<std::size_t>(
                    std::ceil(static_cast<double>(columns + kBeyond) * column_pitches)) +
                    4),
          before_(u_.size() + kBeyond),
          after_(u_.size() + kBeyond),
          parity_(u_.size() + kBeyond),
          weft_(weave, Direction::Weft, places_),
          fibres_(u_, kFibre_mm / weave.thread_pitch_mm) {
        for (WeftCourse& course : weft_courses_)
            course.sections = Sections(u_.size());
        line_.count = static_cast<int>(columns);
        line_.u = u_.data();
        line_.warp_before = columns_of(before_);
        line_.warp_after = columns_of(after_);
        line_.warp_parity = parity_.data();
        line_.twist = static_cast<float>(weave.twist);
        line_.nap = static_cast<float>(weave.nap);
        line_.shown = shown;
        heights_.resize(u_.size());
    }

    void fill_row(double v, std::span<float> heights) {
        line_.v = static_cast<float>(v);
        warp_.cut(v);
        put_warp_columns();
        const int first = static_cast<int>(std::floor(v)) - 2;
        for (int i = 0; i < kWeftsNear; ++i)
            line_.weft[i] = columns_of(followed(first + i));
        line_.weft_parity = first % 2 == 0 ? 1.0F : -1.0F;
        if (line_.nap > 0.0F) {
            fibres_.find(line_.v);
            line_.fibres_above = fibres_.above();
            line_.fibres_below = fibres_.below();
            line_.fibres_share = fibres_.share();
        }
        core::kernels<WeaveKernels>().cloth_heights(line_, heights_.data());
        std::copy_n(heights_.begin(), heights.size(), heights.begin());
    }

  private:
    static constexpr double kFibre_mm = 0.18;

    struct WeftCourse {
        std::optional<int> number{};
        Sections sections;  ///< at each column
    };

    static SectionColumns columns_of(const Sections& sections) {
        return {sections.centre.data(), sections.half_width.data(), sections.crown.data()};
    }

    /// Every column's neighbours in the warp.
    void put_warp_columns() {
        const Sections& warp = warp_.sections();
        const auto put = [](const Sections& from, std::size_t i, Sections& to, std::size_t begin,
                            std::size_t end) {
            fill_stretch(to.centre, begin, end, from.centre[i]);
            fill_stretch(to.half_width, begin, end, from.half_width[i]);
            fill_stretch(to.crown, begin, end, from.crown[i]);
        };
        for (std::size_t i = 0, begin = 0, end = 0; begin < u_.size(); begin = end) {
            while (warp.centre[i + 1] <= u_[begin])
                ++i;
            for (end = begin + 1; end < u_.size() && warp.centre[i + 1] > u_[end];)
                ++end;
            put(warp, i, before_, begin, end);
            put(warp, i + 1, after_, begin, end);
            const bool even = (static_cast<int>(i) + first_warp_) % 2 == 0;
            fill_stretch(parity_, begin, end, even ? 1.0F : -1.0F);
        }
    }

    const Sections& followed(int number) {
        const int slot = (number % kWeftsNear + kWeftsNear) % kWeftsNear;
        WeftCourse& kept = weft_courses_[static_cast<std::size_t>(slot)];
        if (kept.number != number) weft_.follow(number, kept.sections);
        kept.number = number;
        return kept.sections;
    }

    std::vector<double> places_;
    std::vector<float> u_, heights_;
    int first_warp_;
    CutThreads warp_;
    Sections before_, after_;
    std::vector<float> parity_;
    FollowedThreads weft_;
    std::array<WeftCourse, kWeftsNear> weft_courses_;
    Fibres fibres_;
    ClothLine line_;
};

}  // namespace

SupportHeights woven_support(grid::Shape shape, double cell_mm, const Weave& weave,
                             core::ThreadPool& pool, SupportForm form, const ClothPlace& place) {
    PASTOSO_CHECK_OP(cell_mm, >, 0.0);
    PASTOSO_CHECK_OP(weave.thread_pitch_mm, >, 0.0);
    PASTOSO_CHECK_OP(weave.weft_pitch, >, 0.0);
    const double cell_pitches = cell_mm / weave.thread_pitch_mm;
    const double row_pitches = cell_pitches / weave.weft_pitch;
    const float shown = shown_share(weave, cell_mm);
    const int samples = samples_per_cell(cell_pitches, 1.0 / 6.0);
    const auto columns = static_cast<std::size_t>(shape.width) * samples;
    const std::int64_t first_column = std::int64_t{place.x0} * samples;
    return sampled_in(form, {shape, place.y0}, samples, weave.relief_mm, pool, [&] {
        return [row_pitches,
                scanner = ClothScanner(weave, first_column, columns, cell_pitches / samples, shown)](
                   double y_cells, std::span<float> heights) mutable {
            scanner.fill_row(y_cells * row_pitches, heights);
        };
    });
}

}  // namespace pastoso::film
