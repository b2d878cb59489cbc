#include "project/open_raster.hpp"

#include "core/units.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::project {
namespace {

/// The pixels of one axis that a smaller pixel covers, the first and last by a part.
struct Cover {
    int first, last;
    double first_share, last_share;
};

Cover cover_of(int small, int small_count, int count) {
    const double scale = static_cast<double>(count) / small_count;
    const double begin = small * scale, end = std::min<double>(count, (small + 1) * scale);
    Cover cover{static_cast<int>(begin), std::min(count - 1, static_cast<int>(end)), 1.0, 1.0};
    cover.first_share = cover.first + 1 - begin;
    cover.last_share = end - cover.last;
    if (cover.first == cover.last) cover.first_share = end - begin;
    return cover;
}

double share_of(const Cover& cover, int at) {
    if (at == cover.first) return cover.first_share;
    return at == cover.last ? cover.last_share : 1.0;
}

void average(const pigment::LinearImage& picture, const Cover& columns, const Cover& rows, float* rgb) {
    double sums[3] = {0.0, 0.0, 0.0}, area = 0.0;
    for (int y = rows.first; y <= rows.last; ++y) {
        for (int x = columns.first; x <= columns.last; ++x) {
            const double share = share_of(columns, x) * share_of(rows, y);
            const float* pixel = &picture.rgb[3 * (static_cast<std::size_t>(y) * picture.width + x)];
            for (int k = 0; k < 3; ++k)
                sums[k] += share * static_cast<double>(pixel[k]);
            area += share;
        }
    }
    for (int k = 0; k < 3; ++k)
        rgb[k] = static_cast<float>(sums[k] / area);
}

/// Names are written by this program; those of layers are a painter's.
std::string xml_text(const std::string& text) {
    std::string escaped;
    for (const char letter : text) {
        switch (letter) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            default:
                escaped += letter;
        }
    }
    return escaped;
}

}  // namespace

pigment::LinearImage thumbnail_of(const pigment::LinearImage& picture, int longest_px) {
    const double scale =
        std::min(1.0, static_cast<double>(longest_px) / std::max(picture.width, picture.height));
    pigment::LinearImage small;
    small.width = std::max(1, static_cast<int>(std::lround(scale * picture.width)));
    small.height = std::max(1, static_cast<int>(std::lround(scale * picture.height)));
    small.space = picture.space;
    small.rgb.resize(std::size_t{3} * small.width * small.height);
    for (int y = 0; y < small.height; ++y) {
        const Cover rows = cover_of(y, small.height, picture.height);
        for (int x = 0; x < small.width; ++x)
            average(picture, cover_of(x, small.width, picture.width), rows,
                    &small.rgb[3 * (static_cast<std::size_t>(y) * small.width + x)]);
    }
    return small;
}

std::string stack_xml(int width_px, int height_px, double px_per_mm,
                      const std::vector<StackLayer>& layers) {
    const auto density = std::to_string(std::max(1L, std::lround(px_per_mm * core::kInch_mm)));
    std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<image version=\"0.0.3\" w=\"" +
                      std::to_string(width_px) + "\" h=\"" + std::to_string(height_px) + "\" xres=\"" +
                      density + "\" yres=\"" + density + "\">\n <stack>\n";
    for (const StackLayer& layer : layers) {
        xml += "  <layer name=\"" + xml_text(layer.name) + "\" src=\"" + layer.source +
               "\" x=\"0\" y=\"0\" opacity=\"1.0\" visibility=\"" +
               (layer.visible ? "visible" : "hidden") + "\" composite-op=\"svg:src-over\"/>\n";
    }
    return xml + " </stack>\n</image>\n";
}

}  // namespace pastoso::project
