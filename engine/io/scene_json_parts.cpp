#include "io/scene_json_parts.hpp"

#include "core/units.hpp"
#include "document/action_checks.hpp"
#include "document/number_text.hpp"
#include "document/paint_mixing.hpp"
#include "io/image.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::io {
namespace {

using document::number_text;

constexpr double kMaxPosition_mm = 1e5;
constexpr double kShortest_mm = 1e-4;
constexpr double kMaxTurn_deg = 3600.0;

film::Point read_point(const JsonPlace& place) {
    if (place.size() != 2) place.fail("expected two numbers, [x, y].");
    return {number_between(place.element(0), -kMaxPosition_mm, kMaxPosition_mm),
            number_between(place.element(1), -kMaxPosition_mm, kMaxPosition_mm)};
}

film::Area read_area(const JsonPlace& place) {
    if (place.size() != 4) place.fail("expected four numbers, [left, top, right, bottom].");
    double sides[4];
    for (std::size_t i = 0; i < 4; ++i)
        sides[i] = number_between(place.element(i), -kMaxPosition_mm, kMaxPosition_mm);
    const film::Area area{sides[0], sides[1], sides[2], sides[3]};
    if (area.x1_mm <= area.x0_mm || area.y1_mm <= area.y0_mm) place.fail("the area is empty.");
    return area;
}

film::GreyMap read_map(const JsonPlace& file, const SceneContext& context) {
    film::GreyMap map;
    file.guard([&] {
        GreyImage image = read_grey_image(context.folder / file.text());
        map = {image.width, image.height, std::move(image.values)};
    });
    return map;
}

double read_length(const JsonPlace& parent, const std::string& key, double most = kMaxPosition_mm) {
    return number_between(parent.entry(key.c_str()), kShortest_mm, most);
}

film::Relief read_bundled_relief(const JsonPlace& place, const std::string& name,
                                 const SceneContext& context) {
    if (context.units.cells)
        place.fail("\"" + name + "\" is known in millimetres only; in cells describe a \"weave\".");
    if (!place.value().is_object()) return film::BundledRelief{name, 0.0};
    place.allow_only({"kind", "relief_mm"});
    return film::BundledRelief{name, number_between_or(place, "relief_mm", 0.0, 5.0, 0.0)};
}

film::Relief read_weave(const JsonPlace& place, const SceneContext& context) {
    const std::string pitch = context.units.length("thread_pitch");
    const std::string relief = context.units.length("relief");
    place.allow_only({"kind", pitch, relief, "irregularity", "thread_width", "pairing"});
    film::Weave weave;
    weave.thread_pitch_mm = number_between(place.entry(pitch.c_str()), 0.1, 50.0);
    weave.relief_mm = number_between(place.entry(relief.c_str()), 0.0, 5.0);
    weave.irregularity = number_between_or(place, "irregularity", 0.0, 2.0, weave.irregularity);
    weave.thread_width = number_between_or(place, "thread_width", 0.5, 1.2, weave.thread_width);
    weave.pairing = number_between_or(place, "pairing", 0.0, 0.2, weave.pairing);
    return weave;
}

film::Relief read_image_relief(const JsonPlace& place, const SceneContext& context) {
    const std::string low = context.units.length("low"), high = context.units.length("high");
    place.allow_only({"kind", "file", low, high});
    film::ImageRelief relief;
    relief.low_mm = number_between_or(place, low, 0.0, film::kMaxSupport_mm, 0.0);
    relief.high_mm = number_between(place.entry(high.c_str()), relief.low_mm, film::kMaxSupport_mm);
    relief.map = read_map(place.entry("file"), context);
    return relief;
}

film::Relief read_ramp(const JsonPlace& place) {
    place.allow_only({"kind", "slope", "direction_deg"});
    return film::Ramp{number_between(place.entry("slope"), 0.0, 10.0),
                      number_between_or(place, "direction_deg", -kMaxTurn_deg, kMaxTurn_deg, 0.0)};
}

film::Relief read_bump(const JsonPlace& place, const SceneContext& context) {
    const std::string at = context.units.length("at"), height = context.units.length("height"),
                      deviation = context.units.length("deviation");
    place.allow_only({"kind", at, height, deviation});
    return film::Bump{
        read_point(place.entry(at.c_str())),
        number_between(place.entry(height.c_str()), -film::kMaxSupport_mm, film::kMaxSupport_mm),
        read_length(place, deviation)};
}

void read_relief(const JsonPlace& place, const SceneContext& context,
                 std::vector<film::Relief>& reliefs) {
    const JsonPlace kind = place.value().is_object() ? place.entry("kind") : place;
    const std::string name = kind.text();
    if (name == "flat") {
        if (place.value().is_object()) place.allow_only({"kind"});
    } else if (name == "linen" || name == "cotton duck" || name == "panel") {
        reliefs.push_back(read_bundled_relief(place, name, context));
    } else if (name == "weave") {
        reliefs.push_back(read_weave(place, context));
    } else if (name == "image") {
        reliefs.push_back(read_image_relief(place, context));
    } else if (name == "ramp") {
        reliefs.push_back(read_ramp(place));
    } else if (name == "bump") {
        reliefs.push_back(read_bump(place, context));
    } else {
        kind.fail("there is no support \"" + name +
                  "\"; the supports are flat, linen, cotton duck, panel, weave, image, ramp and bump.");
    }
}

/// A form with its own keys; those that all primitives have are allowed beside them.
film::Form read_form(const JsonPlace& place, const SceneContext& context) {
    const SceneUnits& units = context.units;
    const std::string thickness = units.length("thickness"), at = units.length("at"),
                      radius = units.length("radius"), area = units.length("area"),
                      deviation = units.length("deviation"), wavelength = units.length("wavelength");
    const JsonPlace kind = place.entry("kind");
    const std::string name = kind.text();
    const auto allow = [&](const std::string& a, const std::string& b = "kind",
                           const std::string& c = "kind") {
        place.allow_only({"kind", thickness, "pigment", "strength", a, b, c});
    };
    if (name == "slab") {
        allow("kind");
        return film::Slab{};
    }
    if (name == "box") {
        allow(area);
        return film::Box{read_area(place.entry(area.c_str()))};
    }
    if (name == "disc" || name == "cap") {
        allow(at, radius);
        const film::Point centre = read_point(place.entry(at.c_str()));
        const double radius_mm = read_length(place, radius);
        if (name == "disc") return film::Disc{centre, radius_mm};
        return film::SphericalCap{centre, radius_mm};
    }
    if (name == "gaussian") {
        allow(at, deviation);
        return film::Gaussian{read_point(place.entry(at.c_str())), read_length(place, deviation)};
    }
    if (name == "cosine") {
        allow(wavelength, "direction_deg", "phase_deg");
        return film::Cosine{read_length(place, wavelength),
                            number_between_or(place, "direction_deg", -kMaxTurn_deg, kMaxTurn_deg, 0.0),
                            number_between_or(place, "phase_deg", -kMaxTurn_deg, kMaxTurn_deg, 0.0)};
    }
    if (name == "noise") {
        allow("seed");
        const auto seed = place.optional_entry("seed");
        return film::WhiteNoise{seed ? static_cast<std::uint32_t>(seed->integer(0, UINT32_MAX)) : 1U};
    }
    if (name == "image") {
        allow("file");
        return read_map(place.entry("file"), context);
    }
    kind.fail("there is no form \"" + name +
              "\"; the forms are slab, box, disc, cap, gaussian, cosine, noise and image.");
}

/// "PB29", or a mixture [["PB29", 1], ["PW6", 0.5]].
pigment::Coefficients read_pigment(const JsonPlace& primitive) {
    document::PaintRecipe recipe;
    recipe.strength = number_between_or(primitive, "strength", 1e-4, 1.0, 1.0);
    const auto pigment = primitive.optional_entry("pigment");
    if (!pigment) return {};
    if (pigment->value().is_string()) {
        recipe.ingredients.push_back({pigment->text(), 1.0});
    } else {
        for (std::size_t i = 0; i < pigment->size(); ++i) {
            const JsonPlace part = pigment->element(i);
            if (part.size() != 2)
                part.fail("expected a pigment and its parts, for example [\"PB29\", 1].");
            recipe.ingredients.push_back({part.element(0).text(), part.element(1).number()});
        }
    }
    pigment->guard([&] { document::check_paint(recipe); });
    return document::coefficients_of(recipe);
}

film::Primitive read_primitive(const JsonPlace& place, const SceneContext& context) {
    const std::string thickness = context.units.length("thickness");
    film::Primitive primitive;
    primitive.form = read_form(place, context);
    primitive.thickness_mm = number_between(place.entry(thickness.c_str()), 0.0, film::kMaxThickness_mm);
    primitive.pigment = read_pigment(place);
    if (const auto* cap = std::get_if<film::SphericalCap>(&primitive.form)) {
        if (primitive.thickness_mm <= 0.0 || primitive.thickness_mm > cap->radius_mm) {
            place.fail(
                "a cap is at most a half sphere: its thickness " + number_text(primitive.thickness_mm) +
                " must lie above 0 and not above its radius " + number_text(cap->radius_mm) + ".");
        }
    }
    return primitive;
}

/// Constants per density and in millimetres become SI with the density of water.
film::Medium read_paint_in_cells(const JsonPlace& place) {
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

film::Medium find_medium(const JsonPlace& name) {
    film::Medium medium;
    name.guard([&] { medium = film::find_medium(name.text()); });
    return medium;
}

film::Gravity read_tilt(const JsonPlace& place, const SceneContext& context) {
    if (context.units.cells) place.fail("a tilt needs millimetres; in cells give \"gravity\".");
    place.allow_only({"tilt_deg", "direction_deg"});
    return film::tilted_gravity(number_between(place.entry("tilt_deg"), 0.0, 90.0),
                                number_between_or(place, "direction_deg", -360.0, 360.0, 90.0));
}

}  // namespace

double number_between(const JsonPlace& place, double least, double most) {
    const double number = place.number();
    if (!(number >= least && number <= most)) {
        place.fail(number_text(number) + " is not between " + number_text(least) + " and " +
                   number_text(most) + ".");
    }
    return number;
}

double number_between_or(const JsonPlace& parent, const std::string& key, double least, double most,
                         double otherwise) {
    const auto entry = parent.optional_entry(key.c_str());
    return entry ? number_between(*entry, least, most) : otherwise;
}

bool flag_or(const JsonPlace& parent, const char* key, bool otherwise) {
    const auto entry = parent.optional_entry(key);
    return entry ? entry->boolean() : otherwise;
}

std::vector<film::Relief> read_support(const JsonPlace& place, const SceneContext& context) {
    std::vector<film::Relief> reliefs;
    if (!place.value().is_array()) {
        read_relief(place, context, reliefs);
        return reliefs;
    }
    for (std::size_t i = 0; i < place.size(); ++i)
        read_relief(place.element(i), context, reliefs);
    return reliefs;
}

std::vector<film::Primitive> read_film(const JsonPlace& place, const SceneContext& context) {
    std::vector<film::Primitive> primitives;
    for (std::size_t i = 0; i < place.size(); ++i)
        primitives.push_back(read_primitive(place.element(i), context));
    return primitives;
}

film::Medium read_scene_paint(const JsonPlace& place, const SceneContext& context) {
    if (context.units.cells) return read_paint_in_cells(place);
    if (place.value().is_string()) return find_medium(place);
    film::Medium base;
    if (const auto like = place.optional_entry("like")) base = find_medium(*like);
    Json numbers = Json::object();
    for (const auto& item : place.value().items()) {
        if (item.key() == "like") continue;
        place.entry(item.key().c_str()).number();
        numbers[item.key()] = item.value();
    }
    film::Medium medium;
    place.guard([&] { medium = film::parse_medium(numbers.dump(), "this paint", base); });
    return medium;
}

film::Gravity read_forces(const JsonPlace& scene, const SceneContext& context) {
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

}  // namespace pastoso::io
