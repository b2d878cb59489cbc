#include "brush/load_profile.hpp"

#include "brush/brush.hpp"

#include <algorithm>

namespace pastoso::brush {
namespace {

/// Bristles of a stripe, gathered.
struct Gathered {
    Contents contents;
    double full_mm3 = 0.0;
};

std::size_t stripe_of(const Bristle& bristle, const Tip& tip) {
    const double share = 0.5 + 0.5 * bristle.root_x_mm / tip.half_width_mm;
    const int stripe = static_cast<int>(share * LoadProfile::kStripes);
    return static_cast<std::size_t>(std::clamp(stripe, 0, LoadProfile::kStripes - 1));
}

LoadProfile::Stripe stripe_from(const Gathered& gathered) {
    LoadProfile::Stripe stripe;
    const double volume_mm3 = gathered.contents.volume_mm3;
    if (volume_mm3 <= 0.0) return stripe;
    stripe.fill = volume_mm3 / gathered.full_mm3;
    for (std::size_t k = 0; k < stripe.paint.size(); ++k)
        stripe.paint[k] = static_cast<float>(gathered.contents.paint[k] / volume_mm3);
    return stripe;
}

/// What lies between two bristles that hold paint belongs to the nearer one: a fine tip has fewer
/// bristles than there are stripes.
void fill_gaps(std::array<Gathered, LoadProfile::kStripes>& stripes) {
    const auto before = stripes;
    for (int i = 0; i < LoadProfile::kStripes; ++i) {
        for (int away = 0; away < LoadProfile::kStripes; ++away) {
            const int left = std::max(0, i - away),
                      right = std::min(i + away, LoadProfile::kStripes - 1);
            const auto& found = before[left].full_mm3 > 0.0 ? before[left] : before[right];
            if (found.full_mm3 == 0.0) continue;
            stripes[i] = found;
            break;
        }
    }
}

}  // namespace

LoadProfile load_profile(const Brush& brush) {
    std::array<Gathered, LoadProfile::kStripes> gathered;
    Gathered whole;
    for (std::size_t i = 0; i < brush.held.size(); ++i) {
        Gathered& stripe = gathered[stripe_of(brush.tip.bristles[i], brush.tip)];
        for (Gathered* sum : {&stripe, &whole}) {
            sum->contents += brush.held[i];
            sum->full_mm3 += brush.full_dip_mm3(i);
        }
    }
    fill_gaps(gathered);
    LoadProfile profile;
    std::transform(gathered.begin(), gathered.end(), profile.stripes.begin(), stripe_from);
    profile.fill = stripe_from(whole).fill;
    return profile;
}

}  // namespace pastoso::brush
