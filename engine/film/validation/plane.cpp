#include "film/validation/plane.hpp"

#include "core/units.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::film::validation {
namespace {

constexpr int kSamples = 8;
/// Of a canvas across which nothing varies.
constexpr int kNarrow_cells = 4;

int whole_cells(double length_mm, double cell_mm) {
    return std::max(2, static_cast<int>(std::lround(length_mm / cell_mm)));
}

}  // namespace

Plane::Plane(double period_mm, double angle_deg, double cell_mm) : cell_mm_(cell_mm) {
    const double cosine = std::cos(core::radians(angle_deg)), sine = std::sin(core::radians(angle_deg));
    const bool along_x = sine < 1e-9, along_y = cosine < 1e-9;
    width_ = along_y ? kNarrow_cells : whole_cells(period_mm / cosine, cell_mm);
    height_ = along_x ? kNarrow_cells : whole_cells(period_mm / sine, cell_mm);
    const double wave_x = along_y ? 0.0 : 1.0 / (width_ * cell_mm);
    const double wave_y = along_x ? 0.0 : 1.0 / (height_ * cell_mm);
    period_mm_ = 1.0 / std::hypot(wave_x, wave_y);
    towards_x_ = wave_x * period_mm_;
    towards_y_ = wave_y * period_mm_;
}

double Plane::along_mm(double x, double y) const {
    const double along = (x * towards_x_ + y * towards_y_) * cell_mm_;
    return along - std::floor(along / period_mm_) * period_mm_;
}

double Plane::mean(const std::function<double(double)>& profile, int x, int y) const {
    const int across_x = towards_x_ > 0.0 ? kSamples : 1, across_y = towards_y_ > 0.0 ? kSamples : 1;
    double sum = 0.0;
    for (int j = 0; j < across_y; ++j)
        for (int i = 0; i < across_x; ++i)
            sum += profile(along_mm(x + (i + 0.5) / across_x, y + (j + 0.5) / across_y));
    return sum / (across_x * across_y);
}

void Plane::fill(Bench& bench, const std::function<double(double)>& profile) const {
    bench.fill([&](int x, int y) { return mean(profile, x, y); });
}

Setup Plane::placed(Setup setup, double force) const {
    setup.width = width_;
    setup.height = height_;
    setup.cell_mm = cell_mm_;
    setup.force_x = force * towards_x_;
    setup.force_y = force * towards_y_;
    return setup;
}

double Plane::integral(const Bench& bench, const std::function<double(double, double)>& value) const {
    double sum = 0.0;
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x)
            sum += value(along_mm(x + 0.5, y + 0.5), bench.h(x, y));
    return sum / (width_ * height_) * period_mm_;
}

Curve Plane::profile(const Bench& bench, double level_mm) const {
    const int strips = whole_cells(period_mm_, cell_mm_);
    struct Strip {
        double along = 0.0, thickness = 0.0, cells = 0.0;
    };
    std::vector<Strip> sums(static_cast<std::size_t>(strips));
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) {
            const double along = along_mm(x + 0.5, y + 0.5);
            const int strip = std::min(strips - 1, static_cast<int>(along / period_mm_ * strips));
            Strip& sum = sums[static_cast<std::size_t>(strip)];
            sum.along += along;
            sum.thickness += bench.h(x, y);
            sum.cells += 1.0;
        }
    Curve curve;
    for (const Strip& sum : sums)
        if (sum.cells > 0.0)
            curve.push_back({sum.along / sum.cells, sum.thickness / sum.cells - level_mm});
    return curve;
}

double Plane::l1_error(const Bench& bench, const std::function<double(double)>& exact) const {
    double error = 0.0, all = 0.0;
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) {
            const double wanted = mean(exact, x, y);
            error += std::abs(bench.h(x, y) - wanted);
            all += wanted;
        }
    return error / all;
}

}  // namespace pastoso::film::validation
