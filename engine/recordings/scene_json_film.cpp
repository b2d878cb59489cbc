// Support and film of a scene file.
#include "core/text.hpp"
#include "document/actions/actions.hpp"
#include "document/paint_mixing.hpp"
#include "files/image.hpp"
#include "film/support/support.hpp"
#include "recordings/scene_json_parts.hpp"

#include <algorithm>

namespace pastoso::recordings {
namespace {

constexpr double kMaxPosition_mm = 1e5;
constexpr double kShortest_mm = 1e-4;
constexpr double kMaxTurn_deg = 3600.0;

film::Point read_point(const files::JsonPlace& place) {
    if (place.size() != 2) place.fail("expected two numbers, [x, y].");
    return {number_between(place.element(0), -kMaxPosition_mm, kMaxPosition_mm),
            number_between(place.element(1), -kMaxPosition_mm, kMaxPosition_mm)};
}

film::Area read_area(const files::JsonPlace& place) {
    if (place.size() != 4) place.fail("expected four numbers, [left, top, right, bottom].");
    double sides[4];
    for (std::size_t i = 0; i < 4; ++i)
        sides[i] = number_between(place.element(i), -kMaxPosition_mm, kMaxPosition_mm);
    const film::Area area{sides[0], sides[1], sides[2], sides[3]};
    if (area.x1_mm <= area.x0_mm || area.y1_mm <= area.y0_mm) place.fail("the area is empty.");
    return area;
}

film::GreyMap read_map(const files::JsonPlace& file, const SceneContext& context) {
    film::GreyMap map;
    file.guard([&] {
        files::GreyImage image = files::read_grey_image(context.folder / file.text());
        map = {image.width, image.height, std::move(image.values)};
    });
    return map;
}

double read_length(const files::JsonPlace& parent, const std::string& key,
                   double most = kMaxPosition_mm) {
    return number_between(parent.entry(key.c_str()), kShortest_mm, most);
}

film::Relief read_bundled_relief(const files::JsonPlace& place, const std::string& name,
                                 const SceneContext& context) {
    if (context.units.cells)
        place.fail("\"%1\" is known in millimetres only; in cells describe a \"weave\".", name);
    if (!place.value().is_object()) return film::BundledRelief{name, 0.0};
    place.allow_only({"kind", "relief_mm"});
    return film::BundledRelief{name, number_between_or(place, "relief_mm", 0.0, 5.0, 0.0)};
}

film::Relief read_weave(const files::JsonPlace& place, const SceneContext& context) {
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

film::Relief read_image_relief(const files::JsonPlace& place, const SceneContext& context) {
    const std::string low = context.units.length("low"), high = context.units.length("high");
    place.allow_only({"kind", "file", low, high});
    film::ImageRelief relief;
    relief.low_mm = number_between_or(place, low, 0.0, film::kMaxSupport_mm, 0.0);
    relief.high_mm = number_between(place.entry(high.c_str()), relief.low_mm, film::kMaxSupport_mm);
    relief.map = read_map(place.entry("file"), context);
    return relief;
}

film::Relief read_ramp(const files::JsonPlace& place) {
    place.allow_only({"kind", "slope", "direction_deg"});
    return film::Ramp{number_between(place.entry("slope"), 0.0, 10.0),
                      number_between_or(place, "direction_deg", -kMaxTurn_deg, kMaxTurn_deg, 0.0)};
}

film::Relief read_bump(const files::JsonPlace& place, const SceneContext& context) {
    const std::string at = context.units.length("at"), height = context.units.length("height"),
                      deviation = context.units.length("deviation");
    place.allow_only({"kind", at, height, deviation});
    return film::Bump{
        read_point(place.entry(at.c_str())),
        number_between(place.entry(height.c_str()), -film::kMaxSupport_mm, film::kMaxSupport_mm),
        read_length(place, deviation)};
}

bool is_named_support(const std::string& name) {
    return std::ranges::count(film::support_names(), name) > 0;
}

void read_relief(const files::JsonPlace& place, const SceneContext& context,
                 std::vector<film::Relief>& reliefs) {
    const files::JsonPlace kind = place.value().is_object() ? place.entry("kind") : place;
    const std::string name = kind.text();
    if (name == "flat") {
        if (place.value().is_object()) place.allow_only({"kind"});
    } else if (is_named_support(name)) {
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
        kind.fail("there is no support \"%1\"; the supports are flat, %2, weave, image, ramp and bump.",
                  name, core::listed(film::support_names()));
    }
}

/// A form with its own keys; those that all primitives have are allowed beside them.
film::Form read_form(const files::JsonPlace& place, const SceneContext& context) {
    const SceneUnits& units = context.units;
    const std::string thickness = units.length("thickness"), at = units.length("at"),
                      radius = units.length("radius"), area = units.length("area"),
                      deviation = units.length("deviation"), wavelength = units.length("wavelength");
    const files::JsonPlace kind = place.entry("kind");
    const std::string name = kind.text();
    const auto allow = [&](const std::string& a, const std::string& b = "kind",
                           const std::string& c = "kind") {
        place.allow_only({"kind", thickness, "pigment", "strength", "paint", a, b, c});
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
    kind.fail(
        "there is no form \"%1\"; the forms are slab, box, disc, cap, gaussian, cosine, noise and "
        "image.",
        name);
}

/// "PB29", or a mixture [["PB29", 1], ["PW6", 0.5]].
pigment::Coefficients read_pigment(const files::JsonPlace& primitive) {
    document::PaintRecipe recipe;
    recipe.strength = number_between_or(primitive, "strength", 1e-4, 1.0, 1.0);
    const auto pigment = primitive.optional_entry("pigment");
    if (!pigment) return {};
    if (pigment->value().is_string()) {
        recipe.ingredients.push_back({pigment->text(), 1.0});
    } else {
        for (std::size_t i = 0; i < pigment->size(); ++i) {
            const files::JsonPlace part = pigment->element(i);
            if (part.size() != 2)
                part.fail("expected a pigment and its parts, for example [\"PB29\", 1].");
            recipe.ingredients.push_back({part.element(0).text(), part.element(1).number()});
        }
    }
    pigment->guard([&] { document::check_paint(recipe); });
    const film::PaintCoefficients paint = document::mixed_paint(recipe, film::Medium{});
    pigment::Coefficients colour;
    std::copy_n(paint.begin(), colour.size(), colour.begin());
    return colour;
}

film::Primitive read_primitive(const files::JsonPlace& place, const SceneContext& context) {
    const std::string thickness = context.units.length("thickness");
    film::Primitive primitive;
    primitive.form = read_form(place, context);
    primitive.thickness_mm = number_between(place.entry(thickness.c_str()), 0.0, film::kMaxThickness_mm);
    primitive.pigment = read_pigment(place);
    if (const auto paint = place.optional_entry("paint"))
        primitive.medium = read_scene_paint(*paint, context);
    if (const auto* cap = std::get_if<film::SphericalCap>(&primitive.form)) {
        if (primitive.thickness_mm <= 0.0 || primitive.thickness_mm > cap->radius_mm) {
            place.fail(
                "a cap is at most a half sphere: its thickness %1 must lie above 0 and not above its "
                "radius %2.",
                primitive.thickness_mm, cap->radius_mm);
        }
    }
    return primitive;
}

}  // namespace

std::vector<film::Relief> read_support(const files::JsonPlace& place, const SceneContext& context) {
    std::vector<film::Relief> reliefs;
    if (!place.value().is_array()) {
        read_relief(place, context, reliefs);
        return reliefs;
    }
    for (std::size_t i = 0; i < place.size(); ++i)
        read_relief(place.element(i), context, reliefs);
    return reliefs;
}

std::vector<film::Primitive> read_film(const files::JsonPlace& place, const SceneContext& context) {
    std::vector<film::Primitive> primitives;
    for (std::size_t i = 0; i < place.size(); ++i)
        primitives.push_back(read_primitive(place.element(i), context));
    return primitives;
}

}  // namespace pastoso::recordings
