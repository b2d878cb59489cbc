#include "screen/far_picture.hpp"

#include "screen/encoded_pixels.hpp"
#include "screen/qt_rect.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace pastoso::screen {
namespace {

constexpr auto kMost = static_cast<float>(kMost16);

int far_pixels(int cells) {
    return static_cast<int>(std::ceil(cells * kFarZoom));
}

int half(int pixels) {
    return (pixels + 1) / 2;
}

/// The pixels of a row or a column that a stretch of it covers, and how much it covers of each. What is
/// beyond the ends is as the last one is.
struct Taps {
    std::array<int, 4> at{};
    std::array<float, 4> share{};
    int count = 0;

    Taps(double middle, double length, int pixels) {
        const double from = middle - 0.5 * length, to = middle + 0.5 * length;
        for (int i = static_cast<int>(std::floor(from)); i < to && count < 4; ++i, ++count) {
            at[count] = std::clamp(i, 0, pixels - 1);
            share[count] =
                static_cast<float>((std::min(to, i + 1.0) - std::max(from, i + 0.0)) / length);
        }
    }
};

}  // namespace

void FarPicture::begin(const grid::Shape& canvas) {
    canvas_ = canvas;
    known_ = {};
    levels_.clear();
}

void FarPicture::forget(const QRegion& cells) {
    if (known_.isEmpty()) return;
    for (const QRect& part : cells) {
        const auto first = [](int cell) { return static_cast<int>(std::floor(cell * kFarZoom)); };
        known_ -= qt_rect({first(part.left()), first(part.top()), far_pixels(part.right() + 1),
                           far_pixels(part.bottom() + 1)});
    }
}

/// Of which a pixel of the window is as large as one to two.
std::size_t FarPicture::level_for(double zoom) const {
    const auto level = static_cast<int>(std::floor(std::log2(kFarZoom / zoom)));
    return static_cast<std::size_t>(std::max(level, 0));
}

/// A pixel's stretch lies within the corners of the part, however the canvas is turned.
QRegion FarPicture::missing(const ViewTransform& view, const QRect& part) const {
    const glm::dvec2 corner{part.left(), part.top()}, size{part.width(), part.height()};
    glm::dvec2 low{1e300, 1e300}, high{-1e300, -1e300};
    for (const glm::dvec2& share : {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, glm::dvec2{1.0, 1.0}}) {
        const glm::dvec2 cell = view.cell_from_device(corner + share * size);
        low = glm::min(low, kFarZoom * cell);
        high = glm::max(high, kFarZoom * cell);
    }
    const double texel = std::exp2(static_cast<double>(level_for(view.zoom)));
    low = texel * glm::floor(low / texel);
    high = texel * glm::ceil(high / texel);
    const QRect needed = qt_rect({static_cast<int>(low.x), static_cast<int>(low.y),
                                  static_cast<int>(high.x), static_cast<int>(high.y)});
    const QRect all(0, 0, far_pixels(canvas_.width), far_pixels(canvas_.height));
    return QRegion(needed & all) - known_;
}

FarPicture::Level FarPicture::half_of(const Level& level) {
    Level made{half(level.width), half(level.height)};
    made.texels.resize(static_cast<std::size_t>(made.width) * made.height);
    return made;
}

void FarPicture::make_levels() {
    Level first{far_pixels(canvas_.width), far_pixels(canvas_.height)};
    first.texels.resize(static_cast<std::size_t>(first.width) * first.height);
    levels_.push_back(std::move(first));
    for (double zoom = kFarZoom; zoom > kSmallestZoom; zoom *= 0.5)
        levels_.push_back(half_of(levels_.back()));
}

void FarPicture::put(const grid::Rect& pixels, const pigment::LinearImage& picture,
                     core::ThreadPool& pool) {
    if (levels_.empty()) make_levels();
    Level& all = levels_.front();
    pool.run(static_cast<std::size_t>(pixels.height()), [&](std::size_t row, int) {
        const float* rgb = picture.rgb.data() + 3 * row * static_cast<std::size_t>(pixels.width());
        Texel* texel = all.texels.data() +
                       static_cast<std::size_t>(pixels.y0 + static_cast<int>(row)) * all.width +
                       pixels.x0;
        for (int x = 0; x < pixels.width(); ++x, ++texel)
            for (std::uint16_t& value : *texel)
                value = static_cast<std::uint16_t>(kMost * std::clamp(*rgb++, 0.0F, 1.0F) + 0.5F);
    });
    known_ += qt_rect(pixels);
    grid::Rect part = pixels;
    for (std::size_t level = 1; level < levels_.size(); ++level) {
        part = {part.x0 / 2, part.y0 / 2, half(part.x1), half(part.y1)};
        reduce(level, part, pool);
    }
}

void FarPicture::reduce(std::size_t level, const grid::Rect& pixels, core::ThreadPool& pool) {
    const Level& from = levels_[level - 1];
    Level& to = levels_[level];
    pool.run(static_cast<std::size_t>(pixels.height()), [&](std::size_t row, int) {
        const int y = pixels.y0 + static_cast<int>(row);
        const int y1 = std::min(2 * y + 1, from.height - 1);
        for (int x = pixels.x0; x < pixels.x1; ++x) {
            const int x1 = std::min(2 * x + 1, from.width - 1);
            const Texel& a = from.at(2 * x, 2 * y);
            const Texel& b = from.at(x1, 2 * y);
            const Texel& c = from.at(2 * x, y1);
            const Texel& d = from.at(x1, y1);
            Texel& mean = to.texels[static_cast<std::size_t>(y) * to.width + x];
            for (std::size_t i = 0; i < mean.size(); ++i)
                mean[i] = static_cast<std::uint16_t>((a[i] + b[i] + c[i] + d[i] + 2) / 4);
        }
    });
}

void FarPicture::draw(const ViewTransform& view, const QRect& part, QImage& window,
                      core::ThreadPool& pool) const {
    if (levels_.empty()) return;  // of the canvas, no part is in this one
    const std::size_t number = level_for(view.zoom);
    const Level& level = levels_[number];
    const double scale = kFarZoom * std::exp2(-static_cast<double>(number));
    const double length = scale / view.zoom;
    uchar* const first = window.bits();
    pool.run(static_cast<std::size_t>(part.height()), [&](std::size_t row, int) {
        const int y = part.top() + static_cast<int>(row);
        auto* line =
            reinterpret_cast<QRgba64*>(first + static_cast<qsizetype>(y) * window.bytesPerLine());
        for (int x = part.left(); x <= part.right(); ++x) {
            const glm::dvec2 place = scale * view.cell_from_device({x + 0.5, y + 0.5});
            const Taps across(place.x, length, level.width), down(place.y, length, level.height);
            std::array<float, 3> sum{};
            for (int j = 0; j < down.count; ++j)
                for (int i = 0; i < across.count; ++i) {
                    const float share = down.share[j] * across.share[i] / kMost;
                    const Texel& texel = level.at(across.at[i], down.at[j]);
                    for (std::size_t k = 0; k < sum.size(); ++k)
                        sum[k] += share * static_cast<float>(texel[k]);
                }
            line[x] =
                encoded_light(std::min(sum[0], 1.0F), std::min(sum[1], 1.0F), std::min(sum[2], 1.0F));
        }
    });
}

}  // namespace pastoso::screen
