#include "trace/tea_scene.hpp"

#include "liquid/tea/milk_jug.hpp"

#include <utility>

namespace pastoso::trace {

Scene TeaScenes::make(const liquid::TeaFrame& frame, const liquid::TeaSettings& settings,
                      MilkBody body) {
    Scene scene;
    scene.cup = settings.cup;
    if (body == MilkBody::Medium) {
        const liquid::MilkDensitySettings density =
            liquid::even_density(liquid::milk_per_parcel_m3(settings), settings.box_m);
        scene.milk_share = densities_.make(frame.parcels, frame.dissolved, settings.cup, density);
    } else {
        scene.milk = surfaces_.make(frame.parcels, settings.cup, frame.dissolved.shape()).mesh;
        scene.milk_share = grid::BlockField(frame.dissolved);
    }
    return scene;
}

}  // namespace pastoso::trace
