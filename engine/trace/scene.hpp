// What a picture of a liquid shows, as plain data: a vessel of clear glass on a table, what is in it,
// the light and the camera. Metres, z up; colours are linear sRGB.
#pragma once

#include "grid/block_field.hpp"
#include "liquid/surface/triangle_mesh.hpp"
#include "liquid/vessel/cup.hpp"

#include <optional>
#include <vector>

#include <glm/vec3.hpp>

namespace pastoso::trace {

/// An upright box of glass plates, open at the top.
struct Tank {
    glm::vec3 inner_low_m{0.0F};   ///< the lowest corner of what it holds
    glm::vec3 inner_high_m{0.1F};  ///< its highest; the plates end at that height
    float wall_m = 0.002F;         ///< thickness of walls and floor, > 0
    friend bool operator==(const Tank&, const Tank&) = default;
};

/// Coefficients are natural, per metre of way; 0 and more.
struct Optics {
    glm::vec3 tea_absorption_per_m{4.5F, 17.0F, 48.0F};  ///< of the liquid, in cup and tank
    glm::vec3 glass_absorption_per_m{2.2F, 0.9F, 1.4F};  ///< soda-lime glass is a little green
    /// Reduced scattering of undiluted milk (Jensen et al. 2001, whole milk: 2550 to 3770). Milk of
    /// volume fraction c scatters c times as much, alike in all directions.
    float milk_scattering_per_m = 3000.0F;
    glm::vec3 milk_albedo{0.9996F, 0.999F, 0.995F};    ///< share that one scattering leaves, 0 to 1
    glm::vec3 milk_reflectance{0.97F, 0.94F, 0.86F};   ///< of its surface, 0 to 1
    glm::vec3 solid_reflectance{0.70F, 0.32F, 0.20F};  ///< of solids, 0 to 1
    float glass_ior = 1.5F, liquid_ior = 1.335F;       ///< refractive indices, 1 to 4
};

struct Camera {
    glm::vec3 eye_m{0.13F, -0.30F, 0.15F};
    glm::vec3 target_m{0.05F, 0.05F, 0.045F};  ///< in the middle of the picture, and sharp
    float field_of_view_deg = 24.0F;           ///< from the upper to the lower edge, 1 to 120
    float lens_radius_m = 0.0008F;             ///< 0: everything is sharp
};

/// A dull round table of boards, whose colour fades with the distance from the vessel as lamplight does.
struct Table {
    float height_m = -0.002F;
    float radius_m = 1.2F;  ///< around the vessel's middle
    glm::vec3 reflectance{0.50F, 0.40F, 0.30F};
    bool is_wood = true;         ///< otherwise it is even
    float fading_per_m2 = 9.0F;  ///< of the squared distance, until fading_to of the colour is left
    float fading_to = 0.55F;
};

/// A far, round, even lamp.
struct Lamp {
    glm::vec3 towards{-0.55F, -0.5F, 0.85F};  ///< where it stands; any length
    float radius_deg = 7.0F;                  ///< as seen from here, 0.1 to 80
    glm::vec3 radiance{91.0F, 86.2F, 78.9F};
};

/// What is seen where nothing else is: a gradient from below to above, and a soft window in it.
struct Sky {
    glm::vec3 below{0.44F, 0.456F, 0.496F}, above{0.76F, 0.784F, 0.84F};
    glm::vec3 window_towards{0.9F, -0.3F, 0.25F};
    float window_radius_deg = 25.8F;  ///< its edge is soft over a quarter of that
    glm::vec3 window_radiance{1.28F};
};

/// A hollow of the cup's level: depth exp(-(r / radius)^2) deep at the distance r from its middle.
struct LevelDent {
    glm::vec2 at_m{0.0F};
    float depth_m = 0.0F;    ///< 0 up to the radius
    float radius_m = 0.01F;  ///< > 0
};

struct Scene {
    std::optional<liquid::Cup> cup = liquid::Cup{};  ///< with tea up to its level
    std::vector<LevelDent> dents;                    ///< of that level
    std::optional<Tank> tank;                        ///< empty but for clear_liquid
    liquid::TriangleMesh milk;                       ///< a dull body; closed, not within glass
    /// The surface of a clear liquid, closed. Where it touches glass it shall reach into it: within
    /// glass there is glass, whatever else is said to be there.
    liquid::TriangleMesh clear_liquid;
    /// Dull bodies that no light gets through, closed. They count before all else: where they stand at
    /// glass they may reach into it, and the liquid's surface into them.
    liquid::TriangleMesh solids;
    /// Volume fraction of milk in the liquid in the cells of a box that begins at the origin, between 0
    /// and 1 (values beyond are clamped); empty: none.
    grid::BlockField milk_share;
    Optics optics;
    Camera camera;
    std::optional<Table> table = Table{};
    std::optional<Lamp> lamp = Lamp{};
    Sky sky;
};

/// Throws InputError, naming the value, when a number of the scene is not finite or outside its range,
/// when camera and target coincide, or when a mesh has a triangle of vertices that do not exist or fewer
/// normals than positions.
void check_scene(const Scene& scene);

}  // namespace pastoso::trace
