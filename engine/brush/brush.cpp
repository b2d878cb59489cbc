#include "brush/brush.hpp"

#include "core/check.hpp"
#include "core/random.hpp"
#include "film/support/smooth_noise.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace pastoso::brush {
namespace {

/// Random streams of half-mixed paint, apart from those that made the tip.
constexpr std::uint32_t kMixStream = 9001;

/// The share of the second paint in one bristle of a half-mixed load: streaks about a sixth and a
/// twelfth of the width wide, and some difference between neighbours.
double mixed_share(const MixedLoad& paint, const Tip& tip, std::uint32_t index) {
    const double u = tip.bristles[index].root_x_mm / tip.half_width_mm;
    const std::uint32_t stream = tip.dip_seed + kMixStream;
    if (paint.side_by_side) return u < 0.0 ? 0.0 : 1.0;
    const double broad = film::smooth_noise(3.0 * u, stream);
    const double narrow = film::smooth_noise(6.0 * u, stream + 1);
    const double own = core::uniform_noise(index, stream + 2);
    const double deviation = 0.45 * broad + 0.3 * narrow + 0.25 * own - 0.5;
    return std::clamp(paint.second_share + 2.0 * paint.share_variation * deviation, 0.0, 1.0);
}

bool takes_second(const MixedLoad& paint) {
    return paint.second_share > 0.0 || paint.share_variation > 0.0 || paint.side_by_side;
}

/// How high a hair ends above the palette when the brush leans by 45 degrees over one side.
float end_height_mm(const Bristle& bristle) {
    return bristle.deficit_mm + bristle.root_y_mm;
}

/// The height below which the ends of the deepest hairs lie.
float dipped_to_mm(const Tip& tip) {
    constexpr double kDippedShare = 0.4;
    std::vector<float> heights_mm;
    for (const Bristle& bristle : tip.bristles)
        heights_mm.push_back(end_height_mm(bristle));
    const auto last =
        static_cast<std::size_t>(kDippedShare * static_cast<double>(heights_mm.size() - 1));
    std::nth_element(heights_mm.begin(), heights_mm.begin() + static_cast<std::ptrdiff_t>(last),
                     heights_mm.end());
    return heights_mm[last];
}

void check_paint(const film::PaintCoefficients& paint) {
    for (const float coefficient : paint) {
        PASTOSO_CHECK(coefficient >= 0.0F && coefficient <= kStrongestPaint_per_mm);
    }
}

Contents scaled(Contents contents, double factor) {
    contents.volume_mm3 *= factor;
    for (double& amount : contents.paint)
        amount *= factor;
    return contents;
}

Contents paint_of(const MixedLoad& paint, double second_share, double volume_mm3) {
    Contents result;
    result.volume_mm3 = volume_mm3;
    for (int k = 0; k < film::kPaintChannels; ++k) {
        result.paint[k] =
            volume_mm3 * (paint.first[k] * (1.0 - second_share) + paint.second[k] * second_share);
    }
    return result;
}

void add(const film::FilmNumbers& medium, double volume_mm3, HeldMedia& media) {
    const auto found = std::find(media.numbers.begin(), media.numbers.end(), medium);
    const auto place = static_cast<std::size_t>(found - media.numbers.begin());
    if (found == media.numbers.end()) {
        media.numbers.push_back(medium);
        media.volume_mm3.push_back(0.0);
    }
    media.volume_mm3[place] += volume_mm3;
}

}  // namespace

Brush::Brush(const Preset& kind, double width_mm, std::uint32_t seed)
    : preset(resized(kind, width_mm)),
      piece(seed),
      tip(make_tip(preset, piece)),
      held(tip.bristles.size()) {}

Contents Brush::load(const film::PaintCoefficients& paint, double fill) {
    return load(MixedLoad{.first = paint}, fill);
}

Contents Brush::load(const MixedLoad& paint, double fill) {
    PASTOSO_CHECK(fill >= 0.0);
    check_paint(paint.first);
    check_paint(paint.second);
    Contents taken;
    if (preset.exchange.absorbs) return taken;
    gather_hairs();
    if (!holds_paint()) {
        consistencies = {};
        media = {};
    }
    consistencies.add(film::consistency_of(paint.first));
    if (takes_second(paint)) consistencies.add(film::consistency_of(paint.second));
    const float deepest_mm = paint.tip_only ? dipped_to_mm(tip) : std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < held.size(); ++i) {
        const Bristle& bristle = tip.bristles[i];
        if (end_height_mm(bristle) > deepest_mm) continue;
        const double wanted_mm3 =
            tip.capacity_mm3 * std::min(fill * bristle.full_dip, preset.exchange.overflow);
        const double missing_mm3 = std::max(0.0, wanted_mm3 - held[i].volume_mm3);
        const double share = mixed_share(paint, tip, static_cast<std::uint32_t>(i));
        const Contents dip = paint_of(paint, share, missing_mm3);
        held[i] += dip;
        taken += dip;
    }
    if (paint.medium) add(*paint.medium, taken.volume_mm3, media);
    return taken;
}

double Brush::full_dip_mm3(std::size_t bristle) const {
    return tip.capacity_mm3 * std::min(tip.bristles[bristle].full_dip, preset.exchange.overflow);
}

Contents Brush::clean(double share) {
    PASTOSO_CHECK(share >= 0.0 && share <= 1.0);
    const Contents before = contents();
    if (share > 0.0 && share < 1.0) gather_hairs();
    for (Contents& bristle : held)
        bristle = share < 1.0 ? scaled(bristle, 1.0 - share) : Contents{};
    for (double& volume_mm3 : media.volume_mm3)
        volume_mm3 *= 1.0 - share;
    Contents taken = before;
    taken -= contents();
    return taken;
}

void Brush::gather_hairs() {
    gathering = {gathering.number + 1, 0.0};
    shape_tip();
}

void Brush::wear(double travel_mm) {
    gathering.worn_mm += travel_mm;
    shape_tip();
}

void Brush::shape_tip() {
    if (preset.paint.gather > 0.0 && gathering.number > 0) tip = make_tip(preset, piece, gathering);
}

Contents Brush::take_thrown_away() {
    return std::exchange(thrown_away, {});
}

Contents Brush::contents() const {
    Contents sum;
    for (const Contents& bristle : held)
        sum += bristle;
    return sum;
}

}  // namespace pastoso::brush
