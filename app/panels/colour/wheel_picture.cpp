#include "panels/colour/wheel_picture.hpp"

#include "core/units.hpp"
#include "tools/colour_models.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pastoso::panels {
namespace {

QRgb pixel(const pigment::Srgb8& colour) {
    return qRgb(colour[0], colour[1], colour[2]);
}

/// The ring's colours in half degrees: neighbouring ones differ by less than a step of the screen.
using RingColours = std::array<QRgb, 720>;

const RingColours& ring_colours() {
    static const RingColours colours = [] {
        RingColours made{};
        for (std::size_t i = 0; i < made.size(); ++i)
            made[i] = pixel(tools::colour_from(
                tools::ColourModel::Oklch, {kRingLightness, kRingChroma, 0.5 * static_cast<double>(i)}));
        return made;
    }();
    return colours;
}

QRgb ring_colour(double hue_deg) {
    const auto count = static_cast<long>(ring_colours().size());
    const long half_degrees = std::lround(2.0 * hue_deg) % count;
    return ring_colours()[static_cast<std::size_t>((half_degrees + count) % count)];
}

/// How much of a pixel lies on the inner side of an edge that is so far away.
double covered(double distance) {
    return std::clamp(distance + 0.5, 0.0, 1.0);
}

}  // namespace

QImage hue_ring(int side, double inner, double outer) {
    QImage image(side, side, QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < side; ++y) {
        auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < side; ++x) {
            const double right = x + 0.5 - 0.5 * side, up = 0.5 * side - y - 0.5;
            const double radius = std::hypot(right, up);
            const double share = covered(outer - radius) * covered(radius - inner);
            const QRgb colour = share > 0.0 ? ring_colour(core::degrees(std::atan2(up, right))) : 0;
            row[x] = qPremultiply(qRgba(qRed(colour), qGreen(colour), qBlue(colour),
                                        static_cast<int>(std::lround(255.0 * share))));
        }
    }
    return image;
}

QImage colour_field(int side, double hue_deg) {
    QImage image(side, side, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    for (int y = 0; y < side; ++y) {
        auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
        const double lightness = 100.0 * (side - y - 0.5) / side;
        const double most = tools::most_chroma(lightness, hue_deg);
        for (int x = 0; x < side; ++x) {
            const double chroma = kFieldChroma * (x + 0.5) / side;
            if (chroma > most) break;
            row[x] = pixel(tools::colour_from(tools::ColourModel::Oklch, {lightness, chroma, hue_deg}));
        }
    }
    return image;
}

}  // namespace pastoso::panels
