#include "view/masking_skin.hpp"

#include "core/random.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pastoso::view {
namespace {

/// From the edge of fluid, over which it rounds off.
constexpr int kRim_px = 4;
/// How long a fibre of tape is; it is one pixel thick.
constexpr int kFibre_px = 24;
constexpr std::uint32_t kFibreSeed = 87;

/// The colours, and how far light and fibres change them, of 255.
constexpr int kFluid[3] = {124, 138, 160}, kTape[3] = {206, 178, 122};
constexpr int kShine = 90, kFibreDepth = 26, kEdgeDepth = 60;
constexpr int kAlpha = 128;

enum class Skin : std::uint8_t { None, Fluid, Tape };

/// Some of a picture's pixels and how far each lies from the next pixel of another skin.
struct SkinMap {
    int width, height;
    std::vector<Skin> skin;
    std::vector<std::uint8_t> depth_px;  ///< 0 without a skin, 1 at its edge, kRim_px at most

    std::size_t place(int x, int y) const { return static_cast<std::size_t>(y) * width + x; }
    /// Beyond the picture the skin goes on.
    int depth_at(int x, int y) const {
        return depth_px[place(std::clamp(x, 0, width - 1), std::clamp(y, 0, height - 1))];
    }
};

SkinMap map_of(const document::Masking& masking, int block) {
    const grid::Shape shape = masking.cells->shape();
    SkinMap map{(shape.width + block - 1) / block, (shape.height + block - 1) / block, {}, {}};
    map.skin.reserve(static_cast<std::size_t>(map.width) * map.height);
    for (int y = 0; y < map.height; ++y) {
        for (int x = 0; x < map.width; ++x) {
            const bool masked = masking.cells->at(x * block, y * block) != 0;
            const bool tape = masking.tape && masking.tape->at(x * block, y * block) != 0;
            map.skin.push_back(!masked ? Skin::None : tape ? Skin::Tape : Skin::Fluid);
        }
    }
    return map;
}

/// Rim by rim: a pixel lies one deeper than its least deep neighbour of the four, as far as they have
/// the same skin.
void find_depths(SkinMap& map) {
    map.depth_px.assign(map.skin.size(), 0);
    for (std::size_t i = 0; i < map.skin.size(); ++i)
        if (map.skin[i] != Skin::None) map.depth_px[i] = kRim_px;
    const auto pass = [&](int x, int y, int step) {
        std::uint8_t& depth = map.depth_px[map.place(x, y)];
        const auto shorten = [&](int x2, int y2) {
            if (x2 < 0 || y2 < 0 || x2 >= map.width || y2 >= map.height) return;
            const bool same = map.skin[map.place(x, y)] == map.skin[map.place(x2, y2)];
            const int next = same ? map.depth_px[map.place(x2, y2)] + 1 : 1;
            depth = static_cast<std::uint8_t>(std::min<int>(depth, next));
        };
        if (depth == 0) return;
        shorten(x - step, y);
        shorten(x, y - step);
    };
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
            pass(x, y, 1);
    for (int y = map.height - 1; y >= 0; --y)
        for (int x = map.width - 1; x >= 0; --x)
            pass(x, y, -1);
}

QRgb premultiplied(const int (&colour)[3], int lighter, int alpha) {
    const auto channel = [&](int k) { return std::clamp(colour[k] + lighter, 0, 255) * alpha / 255; };
    return qRgba(channel(0), channel(1), channel(2), alpha);
}

/// Its rim rises as a quarter of a circle, thin where it ends.
QRgb fluid_at(const SkinMap& map, int x, int y) {
    const double left = 1.0 - static_cast<double>(map.depth_at(x, y)) / kRim_px;
    const int rise = map.depth_at(x + 1, y + 1) - map.depth_at(x - 1, y - 1);
    const int alpha = static_cast<int>(kAlpha * (0.4 + 0.6 * std::sqrt(1.0 - left * left)));
    return premultiplied(kFluid, kShine * rise / kRim_px, alpha);
}

QRgb tape_at(const SkinMap& map, int x, int y) {
    const int offset = static_cast<int>(core::scramble(static_cast<std::uint32_t>(y)) % kFibre_px);
    const auto fibre =
        static_cast<std::uint32_t>((x + offset) / kFibre_px + y * MaskingSkin::kMostSide_px);
    const float tone = core::uniform_noise(fibre, kFibreSeed) - 0.5F;
    const int edge = map.depth_at(x, y) == 1 ? -kEdgeDepth : 0;
    return premultiplied(kTape, static_cast<int>(kFibreDepth * tone) + edge, kAlpha);
}

QImage skin_of(const document::Masking& masking) {
    const grid::Shape shape = masking.cells->shape();
    const int side = std::max(shape.width, shape.height);
    SkinMap map = map_of(masking, (side + MaskingSkin::kMostSide_px - 1) / MaskingSkin::kMostSide_px);
    find_depths(map);
    QImage picture(map.width, map.height, QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    for (int y = 0; y < map.height; ++y) {
        auto* row = reinterpret_cast<QRgb*>(picture.scanLine(y));
        for (int x = 0; x < map.width; ++x) {
            const Skin skin = map.skin[map.place(x, y)];
            if (skin == Skin::Fluid) row[x] = fluid_at(map, x, y);
            if (skin == Skin::Tape) row[x] = tape_at(map, x, y);
        }
    }
    return picture;
}

}  // namespace

const QImage& MaskingSkin::picture(const document::Masking& masking) {
    if (masking == masking_) return picture_;
    masking_ = masking;
    picture_ = masking.cells ? skin_of(masking) : QImage();
    return picture_;
}

}  // namespace pastoso::view
