#include "layers/picture_means.hpp"

#include "core/check.hpp"
#include "layers/footprint.hpp"
#include "pigment/hex_colour.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pastoso::layers {
namespace {

/// Shares below this come from rounding alone.
constexpr double kLeastShare = 1e-9;

const std::array<float, 256>& decoded_levels() {
    static const auto levels = [] {
        std::array<float, 256> decoded{};
        for (int level = 0; level < 256; ++level)
            decoded[level] = static_cast<float>(pigment::decode_srgb(level / 255.0));
        return decoded;
    }();
    return levels;
}

/// The shares that pixels have of the length from `from` to `to`, in pixels. What lies beyond the
/// picture counts for its last pixel.
AxisCover cover_of(double from, double to, int pixels) {
    const double last = pixels - 1.0;
    AxisCover cover;
    cover.first = static_cast<int>(std::clamp(std::floor(from + kLeastShare), 0.0, last));
    const int end =
        static_cast<int>(std::clamp(std::ceil(to - kLeastShare), cover.first + 1.0, last + 1.0));
    for (int pixel = cover.first; pixel < end; ++pixel) {
        const double low = pixel == 0 ? from : std::max(from, static_cast<double>(pixel));
        const double high = pixel == pixels - 1 ? to : std::min(to, pixel + 1.0);
        cover.weights.push_back(std::max(0.0, high - low) / (to - from));
    }
    return cover;
}

grid::Rect cells_touched(const PicturePlace& place, double cell_mm, const grid::Shape& shape) {
    const auto cell = [](double at, int most) {
        return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(most)));
    };
    return {cell(std::floor(place.x_mm / cell_mm), shape.width),
            cell(std::floor(place.y_mm / cell_mm), shape.height),
            cell(std::ceil((place.x_mm + place.width_mm) / cell_mm), shape.width),
            cell(std::ceil((place.y_mm + place.height_mm) / cell_mm), shape.height)};
}

/// Of the light that pixels send, as far as they cover.
class LightSum {
  public:
    void add(const std::uint8_t* pixel, double share) {
        const std::array<float, 256>& levels = decoded_levels();
        const double covering = share * pixel[3];
        for (int k = 0; k < 3; ++k)
            sums_[k] += covering * levels[pixel[k]];
        covered_ += covering;
    }
    /// In a cell of which so large a part is theirs.
    CoveredColour mean(double share_x, double share_y) const {
        if (covered_ <= 0.0) return {};
        CoveredColour mean;
        for (int k = 0; k < 3; ++k)
            mean.colour[k] = static_cast<float>(sums_[k] / covered_);
        mean.coverage = static_cast<float>(std::min(1.0, covered_ / 255.0 * share_x * share_y));
        return mean;
    }

  private:
    double sums_[3] = {0.0, 0.0, 0.0}, covered_ = 0.0;
};

void append(const CoveredColour& mean, pigment::Picture& picture) {
    const pigment::Srgb8 colour = pigment::encoded(mean.colour);
    picture.rgba.insert(picture.rgba.end(), colour.begin(), colour.end());
    picture.rgba.push_back(static_cast<std::uint8_t>(std::lround(255.0F * mean.coverage)));
}

}  // namespace

std::vector<AxisCover> axis_covers(double begin, double length, int pixels, int first, int end) {
    const double per_cell = pixels / length;
    std::vector<AxisCover> covers;
    for (int cell = first; cell < end; ++cell) {
        const double share = std::min(cell + 1.0, begin + length) - std::max<double>(cell, begin);
        if (share < kLeastShare) {
            covers.emplace_back();
            continue;
        }
        const double middle = (cell + 0.5 - begin) * per_cell;
        const double half = 0.5 * std::max(1.0, per_cell);
        covers.push_back(cover_of(middle - half, middle + half, pixels));
        covers.back().share = share;
    }
    return covers;
}

PictureMeans::PictureMeans(const pigment::Picture& picture, const PicturePlace& place, double cell_mm,
                           const grid::Shape& shape)
    : picture_(picture), cells_(cells_touched(place, cell_mm, shape)) {
    PASTOSO_CHECK_OP(picture.rgba.size(), ==, std::size_t{4} * picture.width * picture.height);
    columns_ =
        axis_covers(place.x_mm / cell_mm, place.width_mm / cell_mm, picture.width, cells_.x0, cells_.x1);
    rows_ = axis_covers(place.y_mm / cell_mm, place.height_mm / cell_mm, picture.height, cells_.y0,
                        cells_.y1);
}

CoveredColour PictureMeans::at(int x, int y) const {
    const AxisCover& column = columns_[static_cast<std::size_t>(x - cells_.x0)];
    const AxisCover& row = rows_[static_cast<std::size_t>(y - cells_.y0)];
    LightSum sum;
    for (std::size_t j = 0; j < row.weights.size(); ++j) {
        const std::size_t start =
            (static_cast<std::size_t>(row.first) + j) * picture_.width + column.first;
        const std::uint8_t* pixel = &picture_.rgba[4 * start];
        for (std::size_t i = 0; i < column.weights.size(); ++i, pixel += 4)
            sum.add(pixel, row.weights[j] * column.weights[i]);
    }
    return sum.mean(column.share, row.share);
}

pigment::Picture resampled(const pigment::Picture& picture, const Projective& map, int width,
                           int height) {
    pigment::Picture result{width, height, {}};
    result.rgba.reserve(std::size_t{4} * width * height);
    Footprint footprint(inverse(map), {0, 0, picture.width, picture.height});
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            LightSum sum;
            for (const CellShare& share : footprint.of(x, y))
                sum.add(&picture.rgba[4 * (static_cast<std::size_t>(share.y) * picture.width + share.x)],
                        share.share);
            append(sum.mean(1.0, 1.0), result);
        }
    return result;
}

pigment::Picture reduced(pigment::Picture picture, int most_width, int most_height) {
    PASTOSO_CHECK(most_width > 0 && most_height > 0);
    if (picture.width <= most_width && picture.height <= most_height) return picture;
    pigment::Picture small{
        std::min(picture.width, most_width), std::min(picture.height, most_height), {}};
    const PictureMeans means(
        picture, {0.0, 0.0, static_cast<double>(small.width), static_cast<double>(small.height)}, 1.0,
        {small.width, small.height});
    small.rgba.reserve(std::size_t{4} * small.width * small.height);
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x)
            append(means.at(x, y), small);
    return small;
}

}  // namespace pastoso::layers
