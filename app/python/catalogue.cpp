#include "brush/preset.hpp"
#include "film/medium.hpp"
#include "film/support/support.hpp"
#include "liquid_files/tank_json.hpp"
#include "liquid_files/tea_json.hpp"
#include "pigment/illuminant.hpp"
#include "pigment/palette.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "recordings/scene_json.hpp"

#include <string>
#include <vector>

#include <pybind11/stl.h>

namespace pastoso::python {
namespace {

namespace py = pybind11;

py::dict media() {
    py::dict result;
    for (const film::Medium& medium : film::bundled_media()) {
        py::dict numbers;
        numbers["description"] = medium.description;
        for (const film::MediumNumber& number : film::medium_numbers())
            numbers[number.key] = medium.*number.member;
        result[py::str(medium.name)] = numbers;
    }
    return result;
}

py::dict pigments() {
    py::dict result;
    for (const pigment::Pigment& pigment : pigment::bundled_palette()) {
        py::dict entry;
        entry["name"] = pigment.name;
        const auto bands = static_cast<py::ssize_t>(pigment::kBands);
        const std::vector<float> values(pigment.coefficients.begin(), pigment.coefficients.end());
        entry["coefficients_per_mm"] = array_of(values, {2, bands});
        result[py::str(pigment.ci_name)] = entry;
    }
    return result;
}

py::dict brushes() {
    py::dict result;
    for (const brush::Preset& preset : brush::bundled_presets())
        result[py::str(preset.name)] = preset.tip.width_mm;
    return result;
}

std::vector<std::string> lights() {
    return {pigment::kBundledIlluminants.begin(), pigment::kBundledIlluminants.end()};
}

}  // namespace

void add_catalogue(py::module_& module) {
    module.def("media", &media,
               "The media by name: dicts of their numbers, in SI units, and a description.");
    module.def("pigments", &pigments,
               "The pigments by Colour Index name: dicts of the painters' name and coefficients_per_mm, "
               "float32 (2, 6),\n"
               "K and S in six bands of light from violet to red.");
    module.def("brushes", &brushes, "The tools by name, with the width of their tips in mm.");
    module.def(
        "supports", [] { return film::support_names(); }, "The names of supports.");
    module.def("lights", &lights, "The names of lights.");
    module.def(
        "scenes", [] { return recordings::bundled_scene_names(); },
        "Scenes of films that come along, by name.");
    module.def(
        "teas", [] { return liquid_files::bundled_tea_names(); }, "Teas that come along, by name.");
    module.def(
        "tanks", [] { return liquid_files::bundled_tank_names(); }, "Tanks that come along, by name.");
}

}  // namespace pastoso::python
