#include "brush/stroke_slopes.hpp"

#include "brush/preset_library.hpp"
#include "brush/studio.hpp"
#include "core/thread_pool.hpp"
#include "core/units.hpp"
#include "document/painting.hpp"
#include "document/painting_state.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace pastoso::brush::studio {
namespace {

constexpr double kLength_mm = 34.0, kDuration_s = 0.6, kMargin_mm = 4.0;
constexpr int kSamplesPerTick = 4, kTicksAfter = 60;
constexpr double kFirst_mm = 12.0, kLast_mm = 28.0, kInnerShare = 0.6, kSpacing_mm = 1.0 / 32.0;

/// The cubic spline through values at whole places (M. Unser, "Splines: a perfect fit", 1999).
class Spline {
  public:
    Spline(std::vector<double> values, int width, int height)
        : coefficients_(std::move(values)), width_(width) {
        for (int y = 0; y < height; ++y)
            filter(index(0, y), 1, width);
        for (int x = 0; x < width; ++x)
            filter(index(x, 0), index(0, 1), height);
    }

    double at(double x, double y) const {
        const auto left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
        const auto across = weights(x - left), down = weights(y - top);
        double sum = 0.0;
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i)
                sum += down[j] * across[i] * coefficients_[index(left + i - 1, top + j - 1)];
        return sum;
    }

  private:
    static std::array<double, 4> weights(double t) {
        const double u = 1.0 - t;
        return {u * u * u / 6.0, 2.0 / 3.0 - t * t * (1.0 - 0.5 * t),
                2.0 / 3.0 - u * u * (1.0 - 0.5 * u), t * t * t / 6.0};
    }

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }

    /// Values of a row or a column to coefficients.
    void filter(std::size_t first, std::size_t step, int count) {
        const double pole = std::sqrt(3.0) - 2.0;
        const auto c = [&](int i) -> double& {
            return coefficients_[first + static_cast<std::size_t>(i) * step];
        };
        for (int i = 1; i < count; ++i)
            c(i) += pole * c(i - 1);
        c(count - 1) *= pole / (pole - 1.0);
        for (int i = count - 2; i >= 0; --i)
            c(i) = pole * (c(i + 1) - c(i));
        for (int i = 0; i < count; ++i)
            c(i) *= 6.0;
    }

    std::vector<double> coefficients_;
    int width_;
};

Spline surface_of(const film::FilmState& film, int block) {
    const int width = film.shape.width / block, height = film.shape.height / block;
    std::vector<double> means_mm;
    for (int y = 0; y < height * block; y += block)
        for (int x = 0; x < width * block; x += block) {
            double sum_mm = 0.0;
            for (int j = y; j < y + block; ++j)
                for (int i = x; i < x + block; ++i)
                    sum_mm += thickness_mm(film, i, j) + film.support_mm.at(i, j);
            means_mm.push_back(sum_mm / (block * block));
        }
    return {std::move(means_mm), width, height};
}

double half_width_mm(const StraightStroke& stroke) {
    return 0.5 * find_preset(stroke.preset).tip.width_mm;
}

struct Place {
    double x_mm, y_mm;
};

/// The stroke's line on its canvas.
class Line {
  public:
    explicit Line(const StraightStroke& stroke)
        : along_x_(std::cos(core::radians(stroke.angle_deg))),
          along_y_(std::sin(core::radians(stroke.angle_deg))),
          start_mm_(half_width_mm(stroke) + kMargin_mm) {}

    /// Where it is `along_mm` from its start and `across_mm` from its middle.
    Place at(double along_mm, double across_mm) const {
        return {start_mm_ + along_mm * along_x_ - across_mm * along_y_,
                start_mm_ + along_mm * along_y_ + across_mm * along_x_};
    }

  private:
    double along_x_, along_y_, start_mm_;
};

}  // namespace

film::FilmState painted(const StraightStroke& stroke, double px_per_mm) {
    const Line travel(stroke);
    const Place start = travel.at(0.0, 0.0), end = travel.at(kLength_mm, 0.0);
    document::CanvasSettings canvas;
    canvas.width_mm = std::ceil(end.x_mm + start.x_mm + 2.0);
    canvas.height_mm = std::ceil(end.y_mm + start.y_mm + 2.0);
    canvas.px_per_mm = px_per_mm;
    canvas.support = "panel";
    core::ThreadPool pool(2);
    document::Painting painting(canvas, pool);
    document::LoadPaint load;
    load.paint.ingredients = {{"PB29", 1.0}};
    load.fill = stroke.fill;
    painting.apply(document::TakeBrush{stroke.preset, 0.0, 1});
    painting.apply(load);
    const Movement movement =
        line(start.x_mm, start.y_mm, end.x_mm, end.y_mm, 0.45, stroke.angle_deg + 90.0);
    const int samples = static_cast<int>(std::lround(kDuration_s / document::kTick_s)) * kSamplesPerTick;
    for (int i = 0; i <= samples; ++i) {
        PenSample sample = movement(static_cast<double>(i) / samples);
        sample.time_s = kDuration_s * i / samples;
        if (i == 0)
            painting.apply(document::PenDown{sample});
        else
            painting.apply(document::PenMove{sample});
        if (i % kSamplesPerTick == kSamplesPerTick - 1) painting.advance_tick();
    }
    painting.apply(document::PenUp{});
    for (int tick = 0; tick < kTicksAfter; ++tick)
        painting.advance_tick();
    return painting.state().value.film;
}

Slopes slopes_of(const film::FilmState& film, const StraightStroke& stroke, int block) {
    const Spline surface = surface_of(film, block);
    const Line travel(stroke);
    const double per_mm = 1.0 / (film.cell_mm * block), inner_mm = kInnerShare * half_width_mm(stroke);
    const int length = static_cast<int>((kLast_mm - kFirst_mm) / kSpacing_mm);
    const int width = static_cast<int>(2.0 * inner_mm / kSpacing_mm);
    std::vector<double> heights_mm;
    for (int j = 0; j <= width; ++j)
        for (int i = 0; i <= length; ++i) {
            const Place place = travel.at(kFirst_mm + i * kSpacing_mm, j * kSpacing_mm - inner_mm);
            heights_mm.push_back(surface.at(place.x_mm * per_mm - 0.5, place.y_mm * per_mm - 0.5));
        }
    const auto height_mm = [&](int i, int j) {
        return heights_mm[static_cast<std::size_t>(j * (length + 1) + i)];
    };
    double along = 0.0, across = 0.0;
    for (int j = 0; j < width; ++j)
        for (int i = 0; i < length; ++i) {
            const double here_mm = height_mm(i, j);
            along += std::pow((height_mm(i + 1, j) - here_mm) / kSpacing_mm, 2.0);
            across += std::pow((height_mm(i, j + 1) - here_mm) / kSpacing_mm, 2.0);
        }
    const double count = static_cast<double>(width) * length;
    return {std::sqrt(along / count), std::sqrt(across / count)};
}

}  // namespace pastoso::brush::studio
