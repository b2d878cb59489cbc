#include "core/units.hpp"
#include "film/support/smooth_noise.hpp"
#include "layers/texture/texture_heights.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::layers {
namespace {

// Lengths along and across the passes are in spacings of ridges, heights in the greatest one.

/// A pass of the knife begins in each place of a lattice, somewhere in it.
constexpr double kPitchAlong = 9.0;
constexpr double kPitchAcross = 2.6;
constexpr double kHalfLength = 10.0;
constexpr double kHalfWidth = 0.5 * kRidgesInPass;
/// How far a pass turns away from the others: the sine of it.
constexpr double kMostTurn = 0.3;
/// How far its sides wander, slowly and quickly, and its ends are torn.
constexpr double kRagged = 0.45;
constexpr double kRough = 0.16;
constexpr double kTorn = 2.5;
/// The lip of paste that the knife leaves at its edges.
constexpr double kLipWidth = 0.6;
/// No part of a pass is farther than this from its middle.
constexpr double kReach = kHalfLength + kHalfWidth;
constexpr float kLowest = 0.04F;

/// Noise in [-1, 1].
float swing(double along, std::uint32_t stream) {
    return 2.0F * film::smooth_noise(along, stream) - 1.0F;
}
float swing(double along, double across, std::uint32_t stream) {
    return 2.0F * film::smooth_noise(along, across, stream) - 1.0F;
}

/// 1 at an edge, falling smoothly to 0 a lip's width away.
float lip_at(double distance) {
    return film::smooth_step(static_cast<float>(std::clamp(1.0 - distance / kLipWidth, 0.0, 1.0)));
}

/// One stroke of the knife.
class Pass {
  public:
    Pass(std::uint32_t seed, std::int32_t column, std::int32_t row)
        : stream_(core::scramble(core::scramble(seed + static_cast<std::uint32_t>(row)) +
                                 static_cast<std::uint32_t>(column))),
          middle_along_(kPitchAlong * (column + double{draw(0)})),
          middle_across_(kPitchAcross * (row + double{draw(1)})),
          sine_(kMostTurn * (2.0 * draw(2) - 1.0)),
          cosine_(std::sqrt(1.0 - sine_ * sine_)),
          level_(0.22F + 0.3F * draw(3)),
          lean_(0.1F * (2.0F * draw(4) - 1.0F)) {}

    /// Those that come later lie above.
    float order() const { return draw(5); }

    /// 0 beside the pass.
    float height(double along, double across) const {
        const double x = along - middle_along_, y = across - middle_across_;
        const double on = x * cosine_ + y * sine_, straight = y * cosine_ - x * sine_;
        if (std::abs(on) > kHalfLength || std::abs(straight) > kHalfWidth + kRagged + kRough)
            return 0.0F;
        const double beside =
            straight + kRagged * swing(on / 2.5, stream_ + 1) + kRough * swing(on * 1.3, stream_ + 2);
        const double torn = kTorn * film::smooth_noise(beside * 0.9, stream_ + 3);
        const Edges edges{.side = kHalfWidth - std::abs(beside),
                          .start = kHalfLength - torn + on,
                          .end = kHalfLength - torn - on};
        if (std::min({edges.side, edges.start, edges.end}) <= 0.0) return 0.0F;
        const float height = level_ + lean_ * static_cast<float>(beside / kHalfWidth) + lips(on, edges) +
                             ridges(on, beside);
        return std::clamp(height, kLowest, 1.0F);
    }

  private:
    /// How far they are from a place within.
    struct Edges {
        double side = 0.0, start = 0.0, end = 0.0;
    };

    /// Where the knife was set down it pressed the paste away.
    float lips(double on, const Edges& edges) const {
        const float side = lip_at(edges.side) * film::smooth_noise(on / 3.0, stream_ + 4);
        return 0.36F * std::max(side, 0.9F * lip_at(edges.end)) - 0.2F * lip_at(edges.start / 3.0);
    }
    float ridges(double on, double beside) const {
        return 0.13F * swing(on / 9.0, beside * 1.2, stream_ + 5) +
               0.05F * swing(on / 7.0, beside * 4.0, stream_ + 6);
    }
    float draw(std::uint32_t which) const { return core::uniform_noise(which, stream_); }

    std::uint32_t stream_;
    double middle_along_, middle_across_, sine_, cosine_;
    float level_, lean_;
};

/// What lies within a stretch along the passes and another one across them.
struct Stretch {
    double least = 0.0, most = 0.0;
};

class KnifedPaste {
  public:
    KnifedPaste(std::uint32_t seed, const Stretch& along, const Stretch& across) {
        const auto place = [](double at, double pitch) {
            return static_cast<std::int32_t>(std::floor(at / pitch));
        };
        const std::int32_t last_row = place(across.most + kReach, kPitchAcross),
                           last_column = place(along.most + kReach, kPitchAlong);
        for (std::int32_t row = place(across.least - kReach, kPitchAcross); row <= last_row; ++row)
            for (std::int32_t column = place(along.least - kReach, kPitchAlong); column <= last_column;
                 ++column)
                passes_.emplace_back(seed, column, row);
        std::stable_sort(passes_.begin(), passes_.end(),
                         [](const Pass& a, const Pass& b) { return a.order() > b.order(); });
    }

    float height(double along, double across) const {
        for (const Pass& pass : passes_)
            if (const float height = pass.height(along, across); height > 0.0F) return height;
        return kLowest;
    }

  private:
    std::vector<Pass> passes_;  ///< from the last one
};

/// Places of the canvas, in cells, as places along and across the passes.
class Turned {
  public:
    Turned(double direction_deg, double cell)
        : x_(std::cos(core::radians(direction_deg)) * cell),
          y_(std::sin(core::radians(direction_deg)) * cell) {}

    double along(double x, double y) const { return x * x_ + y * y_; }
    double across(double x, double y) const { return y * x_ - x * y_; }

    Stretch along(const grid::Rect& cells) const {
        return stretch({along(cells.x0, cells.y0), along(cells.x1, cells.y0), along(cells.x0, cells.y1),
                        along(cells.x1, cells.y1)});
    }
    Stretch across(const grid::Rect& cells) const {
        return stretch({across(cells.x0, cells.y0), across(cells.x1, cells.y0),
                        across(cells.x0, cells.y1), across(cells.x1, cells.y1)});
    }

  private:
    static Stretch stretch(std::initializer_list<double> corners) {
        return {std::min(corners), std::max(corners)};
    }

    double x_, y_;
};

}  // namespace

CellHeights knifed_heights(const KnifedTexture& knifed, const grid::Rect& cells, double cell_mm) {
    const double cell = cell_mm / knifed.spacing_mm;
    const Turned turned(knifed.direction_deg, cell);
    const KnifedPaste paste(knifed.seed, turned.along(cells), turned.across(cells));
    const int samples =
        std::clamp(static_cast<int>(std::ceil(8.0 * cell)), kLeastTextureSamples, kMostTextureSamples);
    const double scale = knifed.height_mm / (samples * samples);
    CellHeights heights;
    heights.reserve(static_cast<std::size_t>(cells.width()) * cells.height());
    for (int y = cells.y0; y < cells.y1; ++y)
        for (int x = cells.x0; x < cells.x1; ++x) {
            double sum = 0.0;
            for (int j = 0; j < samples; ++j)
                for (int i = 0; i < samples; ++i) {
                    const double at_x = x + (i + 0.5) / samples, at_y = y + (j + 0.5) / samples;
                    sum += paste.height(turned.along(at_x, at_y), turned.across(at_x, at_y));
                }
            heights.push_back(static_cast<float>(sum * scale));
        }
    return heights;
}

}  // namespace pastoso::layers
