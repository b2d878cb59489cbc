#include "trace/tea_scene.hpp"

#include <utility>

namespace pastoso::trace {

Scene tea_scene(const liquid::Cup& cup, grid::BoxField dissolved, liquid::TriangleMesh milk) {
    Scene scene;
    scene.cup = cup;
    scene.milk = std::move(milk);
    scene.dissolved = std::move(dissolved);
    return scene;
}

}  // namespace pastoso::trace
