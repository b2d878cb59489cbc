#include "python/pictures.hpp"

#include "core/error.hpp"
#include "document/actions/field_checks.hpp"
#include "pigment/illuminant.hpp"
#include "python/arrays.hpp"
#include "recordings/surface_values.hpp"

#include <utility>

#include <pybind11/stl.h>

namespace pastoso::python {
namespace {

namespace py = pybind11;

/// A value of the lighting, by its key and range.
struct LightingNumber {
    const char* key;
    double shade::Lighting::*value;
    core::Pattern<0> name, unit;
    double low, high;
};

constexpr std::array kLightingNumbers = {
    LightingNumber{"azimuth_deg", &shade::Lighting::azimuth_deg, "direction of the light", "degrees",
                   -360.0, 360.0},
    LightingNumber{"elevation_deg", &shade::Lighting::elevation_deg, "height of the light", "degrees",
                   5.0, 90.0},
    LightingNumber{"ambient", &shade::Lighting::ambient, "share of the light that comes from the sky",
                   "", 0.0, 1.0},
    LightingNumber{"wet_roughness", &shade::Lighting::wet_roughness, "roughness of wet paint", "", 0.05,
                   1.0},
    LightingNumber{"dry_roughness", &shade::Lighting::dry_roughness, "roughness of dry paint", "", 0.05,
                   1.0}};

template <class T>
T value_of(const py::handle& value, const std::string& key, const char* kind) {
    try {
        return value.cast<T>();
    } catch (const py::cast_error&) {
        throw core::InputError("\"%1\" is %2, but must be %3.", key, std::string(py::repr(value)), kind);
    }
}

void set(const std::string& key, const py::handle& value, PictureWish& wish) {
    if (key == "scale")
        wish.scale = value_of<double>(value, key, "a number");
    else if (key == "cells")
        wish.cells =
            value_of<std::optional<std::array<int, 4>>>(value, key, "four whole numbers, or None");
    else if (key == "lit")
        wish.lit = value_of<bool>(value, key, "True or False");
    else if (key == "dtype")
        wish.linear = is_linear(py::reinterpret_borrow<py::object>(value));
    else if (key == "light")
        wish.light = value_of<std::string>(value, key, "a text");
    else if (key == "specular")
        wish.lighting.specular = value_of<bool>(value, key, "True or False");
    else
        throw core::InputError("a picture has no \"%1\"; there are %2.", key, kPictureArguments);
}

bool set_lighting(const std::string& key, const py::handle& value, shade::Lighting& lighting) {
    for (const LightingNumber& number : kLightingNumbers) {
        if (key != number.key) continue;
        lighting.*number.value = value_of<double>(value, key, "a number");
        document::check_between(number.name, number.unit, lighting.*number.value, number.low,
                                number.high);
        return true;
    }
    return false;
}

grid::Rect cells_of(const PictureWish& wish, const grid::Shape& shape) {
    if (!wish.cells) return shape.cells();
    const auto& [left, top, right, bottom] = *wish.cells;
    return {left, top, right, bottom};
}

}  // namespace

const char* const kPictureArguments =
    "scale, cells, lit, dtype, light, specular, azimuth_deg, elevation_deg, ambient, wet_roughness and "
    "dry_roughness";

bool is_linear(const py::object& dtype) {
    const std::string name = py::str(py::dtype::from_args(dtype));
    if (name != "uint8" && name != "float32")
        throw core::InputError("a picture is of uint8 or float32, not of \"%1\".", name);
    return name == "float32";
}

PictureWish picture_wish(const py::kwargs& wanted) {
    PictureWish wish;
    for (const auto& [key, value] : wanted) {
        const auto name = key.cast<std::string>();
        if (!set_lighting(name, value, wish.lighting)) set(name, value, wish);
    }
    return wish;
}

RenderedPicture rendered(const film::FilmState& film, const pigment::Bands& ground,
                         const PictureWish& wish, core::ThreadPool& pool) {
    shade::RenderSettings settings;
    settings.scale = wish.scale;
    settings.lighting = wish.lighting;
    settings.viewing = pigment::viewing_under(pigment::find_illuminant(wish.light));
    const shade::Lattice lattice =
        shade::picture_lattice(film.shape, cells_of(wish, film.shape), wish.scale);
    const shade::Renderer renderer(film, ground, lattice, settings, pool);
    const grid::Rect pixels{0, 0, lattice.width, lattice.height};
    RenderedPicture picture;
    if (wish.lit) {
        renderer.render(pixels, &picture.linear, nullptr);
    } else {
        shade::SurfaceSamples surface;
        renderer.render(pixels, nullptr, &surface);
        picture.linear = recordings::surface_colours(surface, settings.viewing.space);
    }
    if (!wish.linear) picture.encoded = pigment::encode_srgb8(picture.linear);
    return picture;
}

py::array array_of(RenderedPicture picture) {
    const Sizes shape = {picture.linear.height, picture.linear.width, 3};
    if (!picture.encoded.rgb.empty()) return array_of(std::move(picture.encoded.rgb), shape);
    return array_of(std::move(picture.linear.rgb), shape);
}

}  // namespace pastoso::python
