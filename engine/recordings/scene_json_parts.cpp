// Paint and forces of a scene file, and numbers in their ranges.
#include "recordings/scene_json_parts.hpp"

#include "core/units.hpp"
#include "recordings/paint_json.hpp"

#include <cmath>

namespace pastoso::recordings {
namespace {

/// Constants per density and in millimetres become SI with the density of water.
film::Medium read_paint_in_cells(const files::JsonPlace& place) {
    place.allow_only({"viscosity_cells2_s", "tension_cells3_s2", "yield_cells2_s2", "alpha_min",
                      "alpha_max", "advancing_slope", "receding_slope", "slip_cells"});
    film::Medium medium;
    medium.name = "cell units";
    medium.density_kg_m3 = 1000.0;
    medium.viscosity_m2_s = 1e-6 * number_between(place.entry("viscosity_cells2_s"), 1e-6, 1e6);
    medium.surface_tension_N_m = 1e-6 * number_between_or(place, "tension_cells3_s2", 0.0, 1e6, 0.0);
    medium.yield_stress_Pa = 1e-3 * number_between_or(place, "yield_cells2_s2", 0.0, 1e6, 0.0);
    medium.alpha_max = number_between_or(place, "alpha_max", 0.4, 2.0, 1.0);
    medium.alpha_min = number_between_or(place, "alpha_min", 0.4, medium.alpha_max, medium.alpha_max);
    const double advancing = number_between_or(place, "advancing_slope", 0.0, 2.0, 0.0);
    const double receding = number_between_or(place, "receding_slope", 0.0, advancing, advancing);
    medium.advancing_angle_deg = core::degrees(std::atan(advancing));
    medium.receding_angle_deg = core::degrees(std::atan(receding));
    medium.slip_cells = number_between_or(place, "slip_cells", 0.0, 1.0, 0.0);
    return medium;
}

film::Medium find_medium(const files::JsonPlace& name) {
    film::Medium medium;
    name.guard([&] { medium = film::find_medium(name.text()); });
    return medium;
}

film::Gravity read_tilt(const files::JsonPlace& place, const SceneContext& context) {
    if (context.units.cells) place.fail("a tilt needs millimetres; in cells give \"gravity\".");
    place.allow_only({"tilt_deg", "direction_deg"});
    return film::tilted_gravity(number_between(place.entry("tilt_deg"), 0.0, 90.0),
                                number_between_or(place, "direction_deg", -360.0, 360.0, 90.0));
}

}  // namespace

double number_between(const files::JsonPlace& place, double least, double most) {
    const double number = place.number();
    if (!(number >= least && number <= most))
        place.fail("%1 is not between %2 and %3.", number, least, most);
    return number;
}

double number_between_or(const files::JsonPlace& parent, const std::string& key, double least,
                         double most, double otherwise) {
    const auto entry = parent.optional_entry(key.c_str());
    return entry ? number_between(*entry, least, most) : otherwise;
}

bool flag_or(const files::JsonPlace& parent, const char* key, bool otherwise) {
    const auto entry = parent.optional_entry(key);
    return entry ? entry->boolean() : otherwise;
}

film::Medium read_scene_paint(const files::JsonPlace& place, const SceneContext& context) {
    if (context.units.cells) return read_paint_in_cells(place);
    if (place.value().is_string()) return find_medium(place);
    film::Medium base;
    if (const auto like = place.optional_entry("like")) base = find_medium(*like);
    return read_medium_numbers(place, base, "like");
}

film::Gravity read_forces(const files::JsonPlace& scene, const SceneContext& context) {
    const auto tilt = scene.optional_entry("tilt");
    const auto gravity = scene.optional_entry("gravity");
    if (tilt && gravity) scene.fail("\"tilt\" and \"gravity\" say the same; give one of them.");
    if (tilt) return read_tilt(*tilt, context);
    if (!gravity) return context.units.cells ? film::Gravity{} : film::tilted_gravity(0.0);
    constexpr double kMost = 1e6;
    const std::string normal = context.units.acceleration("normal"), x = context.units.acceleration("x"),
                      y = context.units.acceleration("y");
    gravity->allow_only({normal, x, y});
    return {number_between_or(*gravity, normal, 0.0, kMost, 0.0),
            number_between_or(*gravity, x, -kMost, kMost, 0.0),
            number_between_or(*gravity, y, -kMost, kMost, 0.0)};
}

}  // namespace pastoso::recordings
