#include "screen/squint.hpp"

#include "appearance/screen_colours.hpp"
#include "pigment/colour.hpp"
#include "screen/encoded_pixels.hpp"

#include <algorithm>
#include <cmath>

#include <QScreen>
#include <QWidget>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace pastoso::screen {
namespace {

/// Light and its share, square by square.
struct Squares {
    Squares(int squares_wide, int squares_high)
        : width(squares_wide),
          height(squares_high),
          values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

    int width, height;
    std::vector<glm::vec4> values;

    glm::vec4& at(int x, int y) {
        return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
    const glm::vec4& nearest(int x, int y) const {
        return values[static_cast<std::size_t>(std::clamp(y, 0, height - 1)) *
                          static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(std::clamp(x, 0, width - 1))];
    }
};

/// Of 12 bits: finer steps are lost in a mean of squares.
const std::vector<float>& decoded_levels() {
    static const std::vector<float> levels = [] {
        std::vector<float> made;
        for (int level = 0; level < 4096; ++level)
            made.push_back(static_cast<float>(pigment::decode_srgb(level / 4095.0)));
        return made;
    }();
    return levels;
}

float light_of(quint16 encoded) {
    return decoded_levels()[encoded >> 4U];
}

/// `work(x, y)` for all squares.
template <class Work>
void for_squares(const Squares& squares, core::ThreadPool& pool, const Work& work) {
    pool.run(static_cast<std::size_t>(squares.height), [&](std::size_t row, int) {
        for (int x = 0; x < squares.width; ++x)
            work(x, static_cast<int>(row));
    });
}

glm::vec4 mean_of_square(const QImage& picture, int left, int top) {
    glm::vec4 sum(0.0F);
    for (int y = top; y < top + kSquintSquare_px; ++y) {
        const auto* line =
            reinterpret_cast<const QRgba64*>(picture.constScanLine(std::min(y, picture.height() - 1)));
        for (int x = left; x < left + kSquintSquare_px; ++x) {
            const QRgba64 pixel = line[std::min(x, picture.width() - 1)];
            sum += glm::vec4(light_of(pixel.red()), light_of(pixel.green()), light_of(pixel.blue()),
                             static_cast<float>(pixel.alpha() / kMost16));
        }
    }
    return sum / static_cast<float>(kSquintSquare_px * kSquintSquare_px);
}

/// With steps of one square rightwards or downwards.
Squares blurred(const Squares& squares, const std::vector<float>& weights, int right, int down,
                core::ThreadPool& pool) {
    Squares result(squares.width, squares.height);
    for_squares(squares, pool, [&](int x, int y) {
        glm::vec4 sum = weights[0] * squares.nearest(x, y);
        for (int i = 1; i < static_cast<int>(weights.size()); ++i)
            sum += weights[static_cast<std::size_t>(i)] * (squares.nearest(x - i * right, y - i * down) +
                                                           squares.nearest(x + i * right, y + i * down));
        result.at(x, y) = sum;
    });
    return result;
}

void encode_with_less_contrast(Squares& squares, core::ThreadPool& pool) {
    for_squares(squares, pool, [&](int x, int y) {
        glm::vec4& value = squares.at(x, y);
        for (int i = 0; i < 3; ++i)
            value[i] = static_cast<float>(
                0.5 + kSquintContrast * (pigment::encode_srgb(static_cast<double>(value[i])) - 0.5));
    });
}

/// Between the middles of four squares.
glm::vec4 between(const Squares& squares, int x, int y) {
    const glm::vec2 place = (glm::vec2(x, y) + 0.5F) / static_cast<float>(kSquintSquare_px) - 0.5F;
    const glm::vec2 first = glm::floor(place), share = place - first;
    const auto left = static_cast<int>(first.x), top = static_cast<int>(first.y);
    return glm::mix(
        glm::mix(squares.nearest(left, top), squares.nearest(left + 1, top), share.x),
        glm::mix(squares.nearest(left, top + 1), squares.nearest(left + 1, top + 1), share.x), share.y);
}

quint16 level(float value) {
    return static_cast<quint16>(std::lround(kMost16 * std::clamp(static_cast<double>(value), 0.0, 1.0)));
}

}  // namespace

double squint_px(const QWidget& widget) {
    constexpr double kInch_mm = 25.4, kLeast_dpi = 50.0, kMost_dpi = 400.0;
    if (!appearance::screen_colours().squints()) return 0.0;
    // What screens say of their size is not always so.
    const double told_dpi = widget.screen()->physicalDotsPerInch();
    const bool likely = told_dpi >= kLeast_dpi && told_dpi <= kMost_dpi;
    const double dpi = likely ? told_dpi : widget.screen()->logicalDotsPerInch();
    return kSquintBlur_mm / kInch_mm * dpi * widget.devicePixelRatioF();
}

std::vector<float> squint_weights(double blur_px) {
    constexpr int kMostReach = 31;
    constexpr double kSide = kSquintSquare_px;
    // The variances of a square's mean and of the interpolation, in pixels.
    constexpr double kOwn = (kSide * kSide - 1.0) / 12.0 + kSide * kSide / 6.0;
    const double variance = std::max(blur_px * blur_px - kOwn, 0.0) / (kSide * kSide);
    const int reach = std::min(static_cast<int>(std::ceil(3.0 * std::sqrt(variance))), kMostReach);
    std::vector<float> weights = {1.0F};
    double sum = 1.0;
    for (int i = 1; i <= reach; ++i) {
        const double weight = std::exp(-0.5 * i * i / variance);
        weights.push_back(static_cast<float>(weight));
        sum += 2.0 * weight;
    }
    for (float& weight : weights)
        weight /= static_cast<float>(sum);
    return weights;
}

QImage squinted(const QImage& picture, double blur_px, core::ThreadPool& pool) {
    const auto squares_of = [](int pixels) {
        return (pixels + kSquintSquare_px - 1) / kSquintSquare_px;
    };
    Squares squares(squares_of(picture.width()), squares_of(picture.height()));
    for_squares(squares, pool, [&](int x, int y) {
        squares.at(x, y) = mean_of_square(picture, kSquintSquare_px * x, kSquintSquare_px * y);
    });
    const std::vector<float> weights = squint_weights(blur_px);
    squares = blurred(squares, weights, 1, 0, pool);
    squares = blurred(squares, weights, 0, 1, pool);
    encode_with_less_contrast(squares, pool);
    QImage result(picture.size(), QImage::Format_RGBA64);
    uchar* const bits = result.bits();
    pool.run(static_cast<std::size_t>(result.height()), [&](std::size_t row, int) {
        const int y = static_cast<int>(row);
        auto* line = reinterpret_cast<QRgba64*>(bits + y * result.bytesPerLine());
        for (int x = 0; x < result.width(); ++x) {
            const glm::vec4 here = between(squares, x, y);
            line[x] = qRgba64(level(here.r), level(here.g), level(here.b), level(here.a));
        }
    });
    return result;
}

}  // namespace pastoso::screen
