#include "liquid_files/shape_json.hpp"

#include "liquid_files/cup_json.hpp"

#include <charconv>

namespace pastoso::liquid_files {
namespace {

using tank::Combination;
using tank::Combined;
using tank::Shape;

float read_float(const files::JsonPlace& place) {
    return static_cast<float>(place.number());
}

Shape read_sphere(const files::JsonPlace& place, const MeshOfFile&) {
    place.allow_only({"centre_m", "radius_m"});
    return {tank::Sphere{read_vector(place.entry("centre_m")), read_float(place.entry("radius_m"))}};
}

Shape read_block(const files::JsonPlace& place, const MeshOfFile&) {
    place.allow_only({"low_m", "high_m"});
    return {tank::Block{read_vector(place.entry("low_m")), read_vector(place.entry("high_m"))}};
}

Shape read_cylinder(const files::JsonPlace& place, const MeshOfFile&) {
    place.allow_only({"from_m", "to_m", "radius_m"});
    return {tank::Cylinder{read_vector(place.entry("from_m")), read_vector(place.entry("to_m")),
                           read_float(place.entry("radius_m"))}};
}

Shape read_torus(const files::JsonPlace& place, const MeshOfFile&) {
    place.allow_only({"centre_m", "axis", "ring_radius_m", "tube_radius_m"});
    tank::Torus torus;
    torus.centre_m = read_vector(place.entry("centre_m"));
    if (const auto axis = place.optional_entry("axis")) torus.axis = read_vector(*axis);
    torus.ring_radius_m = read_float(place.entry("ring_radius_m"));
    torus.tube_radius_m = read_float(place.entry("tube_radius_m"));
    return {torus};
}

Shape read_glass(const files::JsonPlace& place, const MeshOfFile&) {
    return {tank::CupGlass{read_cup(place)}};
}

Shape read_mesh(const files::JsonPlace& place, const MeshOfFile& mesh_of) {
    place.allow_only({"file", "position_m", "scale"});
    tank::MeshBody body;
    const files::JsonPlace file = place.entry("file");
    body.file = file.text();
    file.guard([&] { body.mesh = mesh_of(body.file); });
    if (const auto position = place.optional_entry("position_m"))
        body.position_m = read_vector(*position);
    if (const auto scale = place.optional_entry("scale")) body.scale = read_float(*scale);
    return {body};
}

template <Combination rule>
Shape read_parts(const files::JsonPlace& place, const MeshOfFile& mesh_of) {
    Combined combined{rule, {}};
    if (place.size() == 0) place.fail("a combination has no parts.");
    for (std::size_t i = 0; i < place.size(); ++i)
        combined.parts.push_back(read_shape(place.element(i), mesh_of));
    return {combined};
}

struct Form {
    const char* key;
    Shape (*read)(const files::JsonPlace& place, const MeshOfFile& mesh_of);
};
constexpr Form kForms[] = {{"sphere", read_sphere},
                           {"block", read_block},
                           {"cylinder", read_cylinder},
                           {"torus", read_torus},
                           {"cup", read_glass},
                           {"mesh", read_mesh},
                           {"union", read_parts<Combination::Union>},
                           {"intersection", read_parts<Combination::Intersection>},
                           {"difference", read_parts<Combination::Difference>}};

std::string names_of_forms() {
    std::string names;
    for (const Form& form : kForms)
        names += (names.empty() ? "" : ", ") + std::string(form.key);
    return names;
}

files::Json json_of(const tank::Sphere& sphere) {
    return {
        {"sphere",
         {{"centre_m", vector_to_json(sphere.centre_m)}, {"radius_m", float_to_json(sphere.radius_m)}}}};
}

files::Json json_of(const tank::Block& block) {
    return {
        {"block", {{"low_m", vector_to_json(block.low_m)}, {"high_m", vector_to_json(block.high_m)}}}};
}

files::Json json_of(const tank::Cylinder& cylinder) {
    return {{"cylinder",
             {{"from_m", vector_to_json(cylinder.from_m)},
              {"to_m", vector_to_json(cylinder.to_m)},
              {"radius_m", float_to_json(cylinder.radius_m)}}}};
}

files::Json json_of(const tank::Torus& torus) {
    return {{"torus",
             {{"centre_m", vector_to_json(torus.centre_m)},
              {"axis", vector_to_json(torus.axis)},
              {"ring_radius_m", float_to_json(torus.ring_radius_m)},
              {"tube_radius_m", float_to_json(torus.tube_radius_m)}}}};
}

files::Json json_of(const tank::CupGlass& glass) {
    files::Json cup = cup_to_json(glass.cup);
    for (files::Json& number : cup)
        number = float_to_json(number.get<float>());
    return {{"cup", cup}};
}

files::Json json_of(const tank::MeshBody& body) {
    return {{"mesh",
             {{"file", body.file},
              {"position_m", vector_to_json(body.position_m)},
              {"scale", float_to_json(body.scale)}}}};
}

const char* name_of(Combination rule) {
    switch (rule) {
        case Combination::Union:
            return "union";
        case Combination::Intersection:
            return "intersection";
        case Combination::Difference:
            return "difference";
    }
    return "";
}

files::Json json_of(const Combined& combined) {
    files::Json parts = files::Json::array();
    for (const Shape& part : combined.parts)
        parts.push_back(shape_to_json(part));
    return {{name_of(combined.rule), parts}};
}

}  // namespace

Shape read_shape(const files::JsonPlace& place, const MeshOfFile& mesh_of) {
    const files::Json& value = place.value();
    if (!value.is_object() || value.size() != 1) {
        place.fail("a shape is an object with one entry, its form, which is one of %1.",
                   names_of_forms());
    }
    const std::string key = value.begin().key();
    for (const Form& form : kForms) {
        if (key != form.key) continue;
        Shape shape = form.read(place.entry(form.key), mesh_of);
        // Parts have been checked each in its place.
        if (!std::holds_alternative<Combined>(shape.form))
            place.guard([&] { tank::check_shape(shape); });
        return shape;
    }
    place.fail("\"%1\" is no form of a shape; there are %2.", key, names_of_forms());
}

files::Json shape_to_json(const Shape& shape) {
    return std::visit([](const auto& form) { return json_of(form); }, shape.form);
}

glm::vec3 read_vector(const files::JsonPlace& place) {
    if (place.size() != 3) place.fail("expected three numbers, found %1.", place.size());
    glm::vec3 vector;
    for (const int axis : {0, 1, 2})
        vector[axis] = read_float(place.element(static_cast<std::size_t>(axis)));
    return vector;
}

files::Json vector_to_json(const glm::vec3& vector) {
    return {float_to_json(vector.x), float_to_json(vector.y), float_to_json(vector.z)};
}

files::Json float_to_json(float value) {
    char digits[32];
    const auto written = std::to_chars(digits, digits + sizeof digits, value);
    double shortest = 0.0;
    std::from_chars(digits, written.ptr, shortest);
    // Twice rounded, it might be the float's neighbour.
    return static_cast<float>(shortest) == value ? shortest : static_cast<double>(value);
}

}  // namespace pastoso::liquid_files
