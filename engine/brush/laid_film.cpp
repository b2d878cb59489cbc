#include "brush/laid_film.hpp"

#include "brush/droplets.hpp"

namespace pastoso::brush {
namespace {

double mean_drop_mm(const DropletPreset& drops) {
    return 0.5 * drops.steepness * cap_radius_mm(drops.drop_mm3, drops.steepness);
}

}  // namespace

double laid_film_mm(const Preset& preset, double fill) {
    switch (preset.kind) {
        case ToolKind::Contact: {
            const double share = saturation(static_cast<float>(fill));
            return preset.paint.film_mm * share * share;
        }
        case ToolKind::Droplets:
            return mean_drop_mm(preset.droplets);
        case ToolKind::Air:
            break;
    }
    return 0.0;
}

}  // namespace pastoso::brush
