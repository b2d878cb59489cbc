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

/// The most chroma of a lightness, in half degrees of hue.
class MostChroma {
  public:
    explicit MostChroma(double lightness) {
        for (std::size_t i = 0; i < most_.size(); ++i)
            most_[i] = tools::most_chroma(lightness, 0.5 * static_cast<double>(i));
    }
    double at(double hue_deg) const {
        return most_[static_cast<std::size_t>(std::lround(2.0 * hue_deg)) % most_.size()];
    }

  private:
    std::array<double, 720> most_{};
};

/// How much of a pixel lies on the inner side of an edge that is so far away.
double covered(double distance) {
    return std::clamp(distance + 0.5, 0.0, 1.0);
}

/// A square picture of `colour_at(right, up)`, in pixels from its middle, where `share_at` of the
/// distance from there is more than 0: the share of a pixel that is seen.
template <class ShareAt, class ColourAt>
QImage round_picture(int side, const ShareAt& share_at, const ColourAt& colour_at) {
    QImage image(side, side, QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < side; ++y) {
        auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < side; ++x) {
            const double right = x + 0.5 - 0.5 * side, up = 0.5 * side - y - 0.5;
            const double share = share_at(std::hypot(right, up));
            const QRgb colour = share > 0.0 ? colour_at(right, up) : 0;
            row[x] = qPremultiply(qRgba(qRed(colour), qGreen(colour), qBlue(colour),
                                        static_cast<int>(std::lround(255.0 * share))));
        }
    }
    return image;
}

}  // namespace

QImage hue_ring(int side, double inner, double outer) {
    return round_picture(
        side, [&](double radius) { return covered(outer - radius) * covered(radius - inner); },
        [](double right, double up) { return ring_colour(core::degrees(std::atan2(up, right))); });
}

QImage hue_disc(int side, double radius, double lightness) {
    const MostChroma most(lightness);
    return round_picture(
        side, [&](double from_middle) { return covered(radius - from_middle); },
        [&](double right, double up) {
            const double hue_deg = tools::turned_deg(core::degrees(std::atan2(up, right)));
            const double chroma = std::min(std::hypot(right, up) / radius, 1.0) * most.at(hue_deg);
            return pixel(tools::colour_from(tools::ColourModel::Oklch, {lightness, chroma, hue_deg}));
        });
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
