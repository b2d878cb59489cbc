// How noisy the tiles of a picture under way are, and the blocks that they are looked at by.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace pastoso::trace {

/// Pixels across.
inline constexpr int kTile = 16, kBlock = 4;
inline constexpr int kBlocksAcross = kTile / kBlock, kBlocks = kBlocksAcross * kBlocksAcross;

/// The index of a pixel's block in its tile.
inline int block_of(int x, int y) {
    return x % kTile / kBlock + y % kTile / kBlock * kBlocksAcross;
}

/// The error of pixels, root mean square, against their mean and what the eye takes for black. It is
/// estimated from the halves of each pixel's samples, which differ by twice the error of its mean, on
/// the average.
class ErrorSums {
  public:
    /// What the even and the odd samples add to a pixel's mean.
    void add(double even, double odd) {
        squares_ += (even - odd) * (even - odd);
        sum_ += even + odd;
        ++pixels_;
    }
    /// 0 of no pixels.
    double error() const {
        constexpr double kBlack = 0.05;
        const double pixels = std::max(pixels_, 1);
        return std::sqrt(squares_ / pixels) / (sum_ / pixels + kBlack);
    }

  private:
    double squares_ = 0.0, sum_ = 0.0;
    int pixels_ = 0;
};

struct TileErrors {
    ErrorSums tile;
    std::array<ErrorSums, kBlocks> blocks;
};

}  // namespace pastoso::trace
