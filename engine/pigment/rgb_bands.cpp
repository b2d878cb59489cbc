#include "pigment/rgb_bands.hpp"

#include "core/thread_pool.hpp"
#include "pigment/appearance.hpp"
#include "pigment/smooth_bands.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace pastoso::pigment {
namespace {

constexpr int kLevels = kRgbBandsLevels;

struct Table {
    std::array<float, kLevels> levels{};
    std::vector<Bands> nodes;  ///< red slowest, blue fastest

    const Bands& node(int red, int green, int blue) const {
        return nodes[static_cast<std::size_t>((red * kLevels + green) * kLevels + blue)];
    }
};

Table make_table() {
    Table table;
    for (int k = 0; k < kLevels; ++k)
        table.levels[k] = static_cast<float>(decode_srgb(k / (kLevels - 1.0)));
    table.nodes.resize(std::size_t{kLevels} * kLevels * kLevels);
    core::ThreadPool pool;
    pool.run(table.nodes.size(), [&](std::size_t index, int) {
        const auto place = static_cast<int>(index);
        const LinearRgb colour = {table.levels[place / (kLevels * kLevels)],
                                  table.levels[place / kLevels % kLevels],
                                  table.levels[place % kLevels]};
        table.nodes[index] = smooth_bands(paint_colour(colour)).reflectance;
    });
    return table;
}

const Table& table() {
    static const Table made = make_table();
    return made;
}

/// Between which levels a value lies, and how far towards the upper one.
struct Place {
    int lower;
    float share;
};
Place place_of(float value, const std::array<float, kLevels>& levels) {
    const auto above = std::upper_bound(levels.begin() + 1, levels.end() - 1, value);
    const auto lower = static_cast<int>(above - levels.begin()) - 1;
    const float share = (value - levels[lower]) / (levels[lower + 1] - levels[lower]);
    return {lower, std::clamp(share, 0.0F, 1.0F)};
}

Bands between(const Bands& a, const Bands& b, float share) {
    Bands mean{};
    for (int band = 0; band < kBands; ++band)
        mean[band] = a[band] + share * (b[band] - a[band]);
    return mean;
}

}  // namespace

Bands rgb_bands(const LinearRgb& on_screen) {
    const Table& known = table();
    const Place red = place_of(on_screen[0], known.levels);
    const Place green = place_of(on_screen[1], known.levels);
    const Place blue = place_of(on_screen[2], known.levels);
    const auto along_blue = [&](int r, int g) {
        return between(known.node(r, g, blue.lower), known.node(r, g, blue.lower + 1), blue.share);
    };
    const auto along_green = [&](int r) {
        return between(along_blue(r, green.lower), along_blue(r, green.lower + 1), green.share);
    };
    return between(along_green(red.lower), along_green(red.lower + 1), red.share);
}

}  // namespace pastoso::pigment
