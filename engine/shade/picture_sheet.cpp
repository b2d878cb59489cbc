#include "shade/picture_sheet.hpp"

#include "core/check.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace pastoso::shade {
namespace {

template <class Image>
std::size_t offset(const Image& picture, int x, int y) {
    return 3 * (static_cast<std::size_t>(y) * picture.width + x);
}

/// The two pixels around a place along one axis, and the share of the second.
struct Between {
    int first = 0, second = 0;
    double share = 0.0;
};
Between between(int enlarged_pixel, int factor, int count) {
    const double place = std::clamp((enlarged_pixel + 0.5) / factor - 0.5, 0.0, count - 1.0);
    const int first = static_cast<int>(place);
    return {first, std::min(first + 1, count - 1), place - first};
}

void copy_into(const pigment::Image8& picture, pigment::Image8& sheet, int left, int top) {
    for (int y = 0; y < picture.height; ++y) {
        const auto row = picture.rgb.begin() + static_cast<std::ptrdiff_t>(offset(picture, 0, y));
        std::copy(row, row + 3 * static_cast<std::ptrdiff_t>(picture.width),
                  sheet.rgb.begin() + static_cast<std::ptrdiff_t>(offset(sheet, left, top + y)));
    }
}

/// Where spans of these lengths begin when a gap follows each; the last entry is the end of all.
std::vector<int> starts_of(const std::vector<int>& lengths, int gap) {
    std::vector<int> starts = {0};
    for (const int length : lengths)
        starts.push_back(starts.back() + length + gap);
    return starts;
}

}  // namespace

pigment::Image8 enlarged(const pigment::Image8& picture, int factor) {
    PASTOSO_CHECK_OP(factor, >=, 1);
    pigment::Image8 large{picture.width * factor, picture.height * factor, {}, picture.space};
    large.rgb.reserve(picture.rgb.size() * static_cast<std::size_t>(factor) * factor);
    for (int y = 0; y < large.height; ++y) {
        const Between rows = between(y, factor, picture.height);
        for (int x = 0; x < large.width; ++x) {
            const Between columns = between(x, factor, picture.width);
            const auto value = [&](int column, int row, int channel) {
                return static_cast<double>(picture.rgb[offset(picture, column, row) + channel]);
            };
            for (int channel = 0; channel < 3; ++channel) {
                const auto along = [&](int row) {
                    return std::lerp(value(columns.first, row, channel),
                                     value(columns.second, row, channel), columns.share);
                };
                large.rgb.push_back(static_cast<std::uint8_t>(
                    std::lround(std::lerp(along(rows.first), along(rows.second), rows.share))));
            }
        }
    }
    return large;
}

pigment::LinearImage framed(const pigment::LinearImage& picture, int width, int height) {
    constexpr float kMiddleGrey = 0.18F;
    pigment::LinearImage frame{width, height, {}, picture.space};
    frame.rgb.assign(static_cast<std::size_t>(width) * height * 3, kMiddleGrey);
    const int left = (width - picture.width) / 2, top = (height - picture.height) / 2;
    const int first = std::max(0, -left), end = std::min(picture.width, width - left);
    for (int y = std::max(0, -top); y < std::min(picture.height, height - top); ++y) {
        const auto row =
            std::span(picture.rgb)
                .subspan(offset(picture, first, y), 3 * static_cast<std::size_t>(end - first));
        std::copy(row.begin(), row.end(), &frame.rgb[offset(frame, left + first, top + y)]);
    }
    return frame;
}

pigment::Image8 arranged(const std::vector<std::vector<pigment::Image8>>& rows, int gap_px) {
    std::vector<int> widths, heights;
    for (const auto& row : rows) {
        heights.push_back(0);
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i) {
            widths[i] = std::max(widths[i], row[i].width);
            heights.back() = std::max(heights.back(), row[i].height);
        }
    }
    PASTOSO_CHECK(!widths.empty() && !rows.front().empty());
    const std::vector<int> lefts = starts_of(widths, gap_px), tops = starts_of(heights, gap_px);
    pigment::Image8 sheet{lefts.back() - gap_px, tops.back() - gap_px, {}, rows.front().front().space};
    sheet.rgb.assign(static_cast<std::size_t>(sheet.width) * sheet.height * 3, 255);
    for (std::size_t j = 0; j < rows.size(); ++j)
        for (std::size_t i = 0; i < rows[j].size(); ++i)
            copy_into(rows[j][i], sheet, lefts[i], tops[j]);
    return sheet;
}

}  // namespace pastoso::shade
