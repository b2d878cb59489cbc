#include "few_colours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace pastoso::screens {
namespace {

constexpr std::size_t kColours = 256;
constexpr int kEvery = 3;  ///< pixels of a row and rows that are looked at, one of so many

using Pixels = std::vector<QRgb>;

int part(QRgb pixel, int channel) {
    return static_cast<int>(pixel >> (8 * channel)) & 0xff;
}

struct Spread {
    int channel = 0;  ///< of blue, green, red
    int width = 0;
    int middle = 0;
};

/// Of the channel in which they differ most.
Spread widest(const Pixels& pixels) {
    Spread widest;
    for (int channel = 0; channel < 3; ++channel) {
        const auto less = [channel](QRgb a, QRgb b) { return part(a, channel) < part(b, channel); };
        const auto [low, high] = std::minmax_element(pixels.begin(), pixels.end(), less);
        const int width = part(*high, channel) - part(*low, channel);
        if (width > widest.width) widest = {channel, width, part(*low, channel) + (width + 1) / 2};
    }
    return widest;
}

QRgb mean(const Pixels& pixels) {
    std::array<long, 3> sums{};
    for (const QRgb pixel : pixels)
        for (int channel = 0; channel < 3; ++channel)
            sums[static_cast<std::size_t>(channel)] += part(pixel, channel);
    const auto count = static_cast<long>(pixels.size());
    return qRgb(static_cast<int>(sums[2] / count), static_cast<int>(sums[1] / count),
                static_cast<int>(sums[0] / count));
}

struct Box {
    Pixels pixels;
    Spread spread;
    /// Rare pixels count as well: a small accent keeps its colour.
    double weight() const { return spread.width * std::sqrt(static_cast<double>(pixels.size())); }
};

Box box_of(Pixels pixels) {
    const Spread spread = widest(pixels);
    return {std::move(pixels), spread};
}

/// Median cut: the heaviest box is cut in two until there are enough.
std::vector<Box> cut(Pixels pixels) {
    std::vector<Box> boxes{box_of(std::move(pixels))};
    while (boxes.size() < kColours) {
        const auto heaviest =
            std::max_element(boxes.begin(), boxes.end(),
                             [](const Box& a, const Box& b) { return a.weight() < b.weight(); });
        if (heaviest->spread.width == 0) break;
        Pixels all = std::move(heaviest->pixels);
        const int channel = heaviest->spread.channel;
        const int middle = heaviest->spread.middle;
        const auto half = std::partition(all.begin(), all.end(),
                                         [&](QRgb pixel) { return part(pixel, channel) < middle; });
        Pixels rest(half, all.end());
        all.erase(half, all.end());
        *heaviest = box_of(std::move(all));
        boxes.push_back(box_of(std::move(rest)));
    }
    return boxes;
}

}  // namespace

QImage in_few_colours(const QImage& picture) {
    const QImage plain = picture.convertToFormat(QImage::Format_RGB32);
    Pixels pixels;
    for (int y = 0; y < plain.height(); y += kEvery) {
        const auto* row = reinterpret_cast<const QRgb*>(plain.constScanLine(y));
        for (int x = 0; x < plain.width(); x += kEvery)
            pixels.push_back(row[x]);
    }
    QList<QRgb> colours;
    for (const Box& box : cut(std::move(pixels)))
        colours.append(mean(box.pixels));
    return plain.convertToFormat(QImage::Format_Indexed8, colours,
                                 Qt::ThresholdDither | Qt::AvoidDither);
}

}  // namespace pastoso::screens
