#include "core/random.hpp"
#include "layers/texture/texture_heights.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::layers {
namespace {

// All lengths are in mean diameters of a grain.

/// Of the places of grains, one in each square of a lattice.
constexpr double kPitch = 0.8;
/// How far a grain may lie from the middle of its square.
constexpr double kShift = 0.4 * kPitch;
constexpr float kBinder = 0.2F;
/// The middle of a grain lies at most so high: some are embedded, some lie on others.
constexpr float kHighestMiddle = 0.5F;
constexpr double kLargestRadius = 0.9;
/// Of the relief above over any large area, found by sampling it finely.
constexpr float kMeanHeight = 0.51F;

/// The upper half of an ellipsoid, a side of which is broken off flat.
struct Grain {
    double x = 0.0, y = 0.0;
    float along_x = 1.0F, along_y = 0.0F;  ///< direction of its longer half axis
    float half_long = 0.5F, half_short = 0.5F, half_high = 0.5F;
    float middle = 0.0F;
    float slope_x = 0.0F, slope_y = 0.0F, break_height = 0.0F;  ///< of the flat side, above the middle

    /// Nothing below the binder's level counts.
    float height(float dx, float dy) const {
        const float along = (dx * along_x + dy * along_y) / half_long;
        const float across = (dy * along_x - dx * along_y) / half_short;
        const float inside = 1.0F - along * along - across * across;
        if (inside <= 0.0F) return 0.0F;
        const float flat = break_height + slope_x * dx + slope_y * dy;
        return middle + std::max(0.0F, std::min(half_high * std::sqrt(inside), flat));
    }
};

/// Numbers in [0, 1) of one place of the lattice.
class Draws {
  public:
    Draws(std::uint32_t seed, std::int64_t column, std::int64_t row)
        : stream_(core::scramble(core::scramble(seed) + static_cast<std::uint32_t>(row))),
          first_(kMost * static_cast<std::uint32_t>(column)) {}
    float next() { return core::uniform_noise(first_ + drawn_++, stream_); }
    /// In [-1, 1).
    float either_way() { return 2.0F * next() - 1.0F; }

  private:
    static constexpr std::uint32_t kMost = 16;
    std::uint32_t stream_, first_, drawn_ = 0;
};

Grain grain_at(std::uint32_t seed, std::int64_t column, std::int64_t row) {
    Draws draws(seed, column, row);
    Grain grain;
    grain.x = kPitch * (static_cast<double>(column) + 0.5) + kShift * draws.either_way();
    grain.y = kPitch * (static_cast<double>(row) + 0.5) + kShift * draws.either_way();
    const float radius = 0.3F + 0.2F * (draws.next() + draws.next());
    const float longer = 1.0F + 0.25F * draws.next();
    grain.half_long = radius * longer;
    grain.half_short = radius / longer;
    grain.half_high = radius * (0.7F + 0.4F * draws.next());
    // The tangent of half its angle makes a direction without sine and cosine.
    const float half_tangent = draws.either_way(), square = half_tangent * half_tangent;
    grain.along_x = (1.0F - square) / (1.0F + square);
    grain.along_y = 2.0F * half_tangent / (1.0F + square);
    grain.middle = kHighestMiddle * draws.next();
    grain.slope_x = 0.9F * draws.either_way();
    grain.slope_y = 0.9F * draws.either_way();
    grain.break_height = grain.half_high * (0.55F + 0.45F * draws.next());
    return grain;
}

/// Heights at evenly spaced places, row by row.
class SampledSand {
  public:
    SampledSand(double x0, double y0, double step, int width, int height)
        : x0_(x0),
          y0_(y0),
          step_(step),
          width_(width),
          height_(height),
          heights_(static_cast<std::size_t>(width) * height, kBinder) {}

    void put(const Grain& grain) {
        const int left = first_after(grain.x - kLargestRadius - x0_, width_);
        const int right = first_after(grain.x + kLargestRadius - x0_, width_);
        const int top = first_after(grain.y - kLargestRadius - y0_, height_);
        const int bottom = first_after(grain.y + kLargestRadius - y0_, height_);
        for (int j = top; j < bottom; ++j) {
            const auto dy = static_cast<float>(y0_ + (j + 0.5) * step_ - grain.y);
            float* row = &heights_[static_cast<std::size_t>(j) * width_];
            for (int i = left; i < right; ++i) {
                const auto dx = static_cast<float>(x0_ + (i + 0.5) * step_ - grain.x);
                row[i] = std::max(row[i], grain.height(dx, dy));
            }
        }
    }

    float mean(int column, int row, int samples) const {
        double sum = 0.0;
        for (int j = row * samples; j < (row + 1) * samples; ++j)
            for (int i = column * samples; i < (column + 1) * samples; ++i)
                sum += heights_[static_cast<std::size_t>(j) * width_ + i];
        return static_cast<float>(sum / (samples * samples));
    }

  private:
    /// The first place that lies not before `distance`, or the end.
    int first_after(double distance, int end) const {
        return static_cast<int>(std::clamp(std::ceil(distance / step_ - 0.5), 0.0, 1.0 * end));
    }

    double x0_, y0_, step_;
    int width_, height_;
    std::vector<float> heights_;
};

std::int64_t square_of(double place) {
    return static_cast<std::int64_t>(std::floor(place / kPitch));
}

}  // namespace

CellHeights sand_heights(const SandTexture& sand, const grid::Rect& cells, double cell_mm) {
    const int columns = cells.x1 - cells.x0, rows = cells.y1 - cells.y0;
    CellHeights heights(static_cast<std::size_t>(columns) * rows);
    const auto grain_mm = static_cast<float>(sand.grain_mm);
    const double cell = cell_mm / sand.grain_mm;
    if (cell * kFinestGrain_cells > 1.0) {
        std::fill(heights.begin(), heights.end(), kMeanHeight * grain_mm);
        return heights;
    }
    const int samples =
        std::clamp(static_cast<int>(std::ceil(4.0 * cell)), kLeastTextureSamples, kMostTextureSamples);
    const double x0 = cells.x0 * cell, y0 = cells.y0 * cell;
    SampledSand sampled(x0, y0, cell / samples, columns * samples, rows * samples);
    constexpr double kReach = kLargestRadius + kShift;
    for (std::int64_t row = square_of(y0 - kReach); row <= square_of(cells.y1 * cell + kReach); ++row)
        for (std::int64_t column = square_of(x0 - kReach); column <= square_of(cells.x1 * cell + kReach);
             ++column)
            sampled.put(grain_at(sand.seed, column, row));
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
            heights[static_cast<std::size_t>(y) * columns + x] = grain_mm * sampled.mean(x, y, samples);
    return heights;
}

}  // namespace pastoso::layers
