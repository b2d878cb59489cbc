#include "trace/tea_scene.hpp"

#include <utility>

namespace pastoso::trace {

Scene tea_scene(const liquid::Cup& cup, grid::BlockField milk_share, liquid::TriangleMesh milk) {
    Scene scene;
    scene.cup = cup;
    scene.milk = std::move(milk);
    scene.milk_share = std::move(milk_share);
    return scene;
}

}  // namespace pastoso::trace
