// Scenes of a glass tank of any text: refused in a sentence, or read to what is written and read again
// alike, with distances that are numbers.
#include "core/check.hpp"
#include "core/error.hpp"
#include "liquid_files/tank_json.hpp"
#include "tank/meshes.hpp"

#include <cmath>
#include <cstdint>
#include <string_view>

namespace pastoso {
namespace {

/// No file of the machine is opened.
std::shared_ptr<const liquid::TriangleMesh> any_mesh(const std::string& file) {
    if (file.size() > 20) throw core::InputError("there is no such mesh.");
    static const auto mesh = std::make_shared<const liquid::TriangleMesh>(tank::test::octahedron());
    return mesh;
}

void try_shape(const tank::Shape& shape) {
    const tank::ShapeDistance distance(shape);
    for (const glm::vec3& point : {glm::vec3(0.0F), glm::vec3(0.1F, 0.2F, 0.3F), glm::vec3(-9.0F)}) {
        const float whole = distance(point), near = distance(point, 0.25F);
        PASTOSO_CHECK(std::isfinite(whole));
        PASTOSO_CHECK(std::abs(whole) < 0.25F ? near == whole : std::abs(near) >= 0.25F);
    }
}

void try_scene(std::string_view text) {
    const tank::TankScene scene = liquid_files::tank_from_json(text, "file", any_mesh);
    PASTOSO_CHECK(liquid_files::tank_from_json(liquid_files::tank_to_json(scene), "written", any_mesh) ==
                  scene);
    for (const tank::Shape& solid : scene.solids)
        try_shape(solid);
}

}  // namespace
}  // namespace pastoso

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace pastoso;
    try {
        try_scene({reinterpret_cast<const char*>(data), size});
    } catch (const core::InputError& error) {
        PASTOSO_CHECK(std::string_view(error.what()).starts_with("file"));
    }
    return 0;
}
