#include "trace/tea_scene.hpp"

#include <utility>

namespace pastoso::trace {

Scene tea_scene(const liquid::Cup& cup, const liquid::TeaFrame& frame, liquid::TriangleMesh milk) {
    Scene scene;
    scene.cup = cup;
    scene.milk = std::move(milk);
    scene.dissolved = frame.dissolved;
    return scene;
}

}  // namespace pastoso::trace
