#include "brush/laid_film.hpp"

#include "brush/droplets.hpp"

#include <algorithm>

namespace pastoso::brush {
namespace {

/// The thickest film of a knife, in widths of its blade.
constexpr double kThickest_widths = 0.125;

double mean_drop_mm(const DropletPreset& drops) {
    return 0.5 * drops.steepness * cap_radius_mm(drops.drop_mm3, drops.steepness);
}

}  // namespace

double full_film_mm(const Preset& preset) {
    const double film_mm = preset.paint.film_mm;
    return preset.tip.shape == TipShape::Knife
               ? std::min(film_mm, kThickest_widths * preset.tip.width_mm)
               : film_mm;
}

double laid_film_mm(const Preset& preset, double fill) {
    switch (preset.kind) {
        case ToolKind::Contact: {
            const double share = saturation(static_cast<float>(fill));
            return full_film_mm(preset) * share * share;
        }
        case ToolKind::Droplets:
            return mean_drop_mm(preset.droplets);
        case ToolKind::Air:
            break;
    }
    return 0.0;
}

}  // namespace pastoso::brush
