#include "core/error.hpp"
#include "document/actions/field_checks.hpp"
#include "liquid/tea/milk_surface.hpp"
#include "liquid/tea/milk_tea.hpp"
#include "liquid/vessel/cup_mesh.hpp"
#include "liquid_files/tea_json.hpp"
#include "liquid_files/tea_stats.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/meshes.hpp"
#include "python/pools.hpp"
#include "python/traced.hpp"
#include "python/turn.hpp"
#include "trace/tea_scene.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <pybind11/stl.h>

namespace pastoso::python {
namespace {

namespace py = pybind11;

struct TeaWork {
    TeaWork(std::shared_ptr<core::ThreadPool> threads, const liquid::TeaSettings& settings)
        : pool(std::move(threads)), tea(settings), surfaces(*pool) {}

    std::shared_ptr<core::ThreadPool> pool;
    liquid::MilkTea tea;
    liquid::MilkSurfaces surfaces;
    Turn turn;
};

std::unique_ptr<TeaWork> make_tea(const std::optional<std::string>& text, const std::string& name,
                                  int threads, std::optional<double> fps) {
    liquid::TeaSettings settings =
        text ? liquid_files::tea_from_json(*text, name) : liquid_files::read_tea(name);
    if (fps) {
        document::check_between("number of frames", "1/s", *fps, 0.1, 1000.0);
        settings = liquid_files::stepped_for(settings, *fps);
    }
    liquid::check_tea(settings);
    std::shared_ptr<core::ThreadPool> pool = pool_of(threads);
    const py::gil_scoped_release released;
    return std::make_unique<TeaWork>(std::move(pool), settings);
}

void step(TeaWork& work, int count) {
    document::check_between("number of steps", "", count, 0, 1e9);
    Interruption interruption;
    work.turn.take([&] {
        for (int i = 0; i < count && !interruption.wanted(); ++i)
            work.tea.step(*work.pool);
    });
    interruption.rethrow();
}

py::object read(TeaWork& work, const std::string& name) {
    liquid::VelocityField velocity;
    grid::BoxField field;
    if (name == "velocity") {
        work.turn.take([&] { velocity = work.tea.flow().velocity(); });
        return arrays_of(std::move(velocity));
    }
    if (name != "dissolved" && name != "coldness")
        throw core::InputError(
            "there is no field \"%1\" of a tea; the fields are dissolved, coldness and velocity.", name);
    work.turn.take([&] { field = name == "dissolved" ? work.tea.dissolved() : work.tea.coldness(); });
    return array_of(std::move(field));
}

py::array parcels(TeaWork& work) {
    using liquid::Parcel;
    auto owner = std::make_unique<std::vector<Parcel>>();
    work.turn.take([&] { *owner = work.tea.parcels(); });
    const py::dtype type = record_type({{"position_m", "3f4", offsetof(Parcel, position_m)},
                                        {"volume_m3", "f4", offsetof(Parcel, volume_m3)},
                                        {"coldness", "f4", offsetof(Parcel, coldness)},
                                        {"ball", "i4", offsetof(Parcel, ball)},
                                        {"shape", "6f4", offsetof(Parcel, shape)}},
                                       sizeof(Parcel));
    const auto count = static_cast<py::ssize_t>(owner->size());
    const void* first = owner->data();
    return py::array(type, Sizes{count}, first, keeper(std::move(owner)));
}

py::tuple surface(TeaWork& work, int parts) {
    document::check_between("number of parts", "", parts, 1, 8);
    liquid::MilkSurface surface;
    work.turn.take([&] {
        const liquid::TeaFrame frame = work.tea.frame();
        liquid::MilkSurfaceSettings settings;
        settings.parts = parts;
        surface = work.surfaces.make(frame.parcels, work.tea.cup(), frame.dissolved.shape(), settings);
    });
    return arrays_of(std::move(surface.mesh));
}

trace::MilkBody milk_body(const std::string& milk) {
    if (milk == "medium") return trace::MilkBody::Medium;
    if (milk == "surface") return trace::MilkBody::Surface;
    throw core::InputError("milk is drawn as medium or surface, not as \"%1\".", milk);
}

py::array render(TeaWork& work, int width, int height, int samples, bool denoise,
                 const py::object& dtype, const std::string& milk) {
    const TracedWish wish = traced_wish(width, height, samples, denoise, dtype);
    const trace::MilkBody body = milk_body(milk);
    Interruption interruption;
    RenderedPicture picture;
    work.turn.take([&] {
        const liquid::TeaFrame frame = work.tea.frame();
        picture = traced(trace::tea_scene(work.tea.settings(), frame.parcels, frame.dissolved,
                                          frame.pour, body, *work.pool),
                         wish, *work.pool, interruption);
    });
    interruption.rethrow();
    return array_of(std::move(picture));
}

py::dict cup(TeaWork& work) {
    liquid::CupMeshes meshes;
    work.turn.take([&] { meshes = liquid::cup_meshes(work.tea.cup()); });
    py::dict result;
    result["glass_air"] = arrays_of(std::move(meshes.glass_air));
    result["tea_glass"] = arrays_of(std::move(meshes.tea_glass));
    result["tea_air"] = arrays_of(std::move(meshes.tea_air));
    return result;
}

template <class Value>
auto seen(Value (*value)(const TeaWork&)) {
    return [value](TeaWork& work) { return work.turn.take([&] { return value(work); }); };
}

}  // namespace

void add_tea(py::module_& module) {
    py::class_<TeaWork>(module, "Tea", "What pastoso.Tea is made of.")
        .def(py::init(&make_tea), py::arg("text"), py::arg("name"), py::arg("threads"), py::arg("fps"))
        .def("step", &step, py::arg("count") = 1,
             "Takes so many steps of step_s. Python's other threads go on meanwhile; Ctrl+C stops "
             "between two steps.")
        .def("read", &read, py::arg("name"),
             "A field of the cells, float32 (z, y, x) with z up: \"dissolved\", the share of milk that "
             "has dissolved;\n"
             "\"coldness\", 0 as warm as the tea, 1 as cold as the milk was; \"velocity\", three arrays "
             "in m/s on the\n"
             "faces across x (z, y, x + 1), y and z. The engine's field is copied once, ghosts and all; "
             "the array is\n"
             "a view of that copy.")
        .def("parcels", &parcels,
             "Milk that has not dissolved, a structured array (count,): position_m (3), m; volume_m3, "
             "m3; coldness,\n"
             "no unit; ball (-1: none yet); shape (6: xx, yy, zz, xy, xz, yz of the covariance of its "
             "milk, 1 as poured).")
        .def("render", &render, py::arg("width") = 800, py::arg("height") = 800, py::kw_only(),
             py::arg("samples") = 48, py::arg("denoise") = true, py::arg("dtype") = "uint8",
             py::arg("milk") = "medium",
             "A path-traced picture of the glass, (height, width, 3), as `pastoso-cli tea` draws it.\n\n"
             "dtype: uint8, as a screen shall show it, sRGB; or float32, the radiance in linear light.\n"
             "samples: paths for a pixel; denoise: takes the noise of these out. milk: how milk is "
             "drawn\n"
             "that has not dissolved, \"medium\", as a share of the liquid, or \"surface\", as a body.\n"
             "Ctrl+C stops it.")
        .def("surface_arrays", &surface, py::arg("parts") = 2,
             "What surface() is made of, as in Mesh: m, float32 (vertices, 3); the same or None;\n"
             "uint32 (triangles, 3).")
        .def("cup_arrays", &cup,
             "What cup() is made of, by name, as in Mesh: m, float32 (vertices, 3); the same or None;\n"
             "uint32 (triangles, 3).")
        .def(
            "pour_by_hand",
            [](TeaWork& work, std::optional<std::array<float, 2>> at_m) {
                std::optional<glm::vec2> place;
                for (int axis = 0; at_m && axis < 2; ++axis)
                    document::check_between("place to pour at", "m", (*at_m)[axis], -10.0, 10.0);
                if (at_m) place = glm::vec2((*at_m)[0], (*at_m)[1]);
                work.turn.take([&] { work.tea.pour_by_hand(place); });
            },
            py::arg("at_m"),
            "Pours more milk at (x, y), m, as fast as the recipe pours its own, until told None.")
        .def("milk_m3", seen<double>([](const TeaWork& work) { return work.tea.milk_m3(*work.pool); }),
             "Milk in parcels and dissolved, m3.")
        .def("settings_json", seen<std::string>([](const TeaWork& work) {
                 return liquid_files::tea_to_json(work.tea.settings());
             }),
             "The settings as JSON.")
        .def_property_readonly("poured_m3",
                               seen<double>([](const TeaWork& work) { return work.tea.poured_m3(); }),
                               "Milk that has been poured, m3.")
        .def_property_readonly("time_s",
                               seen<double>([](const TeaWork& work) { return work.tea.time_s(); }),
                               "Seconds that have passed.")
        .def_property_readonly("steps", seen<int>([](const TeaWork& work) { return work.tea.steps(); }),
                               "Steps that have been taken.")
        .def_property_readonly(
            "step_s", seen<double>([](const TeaWork& work) { return work.tea.settings().step_s; }),
            "Length of a step, s.")
        .def_property_readonly(
            "state_hash",
            seen<std::uint64_t>([](const TeaWork& work) { return liquid_files::state_hash(work.tea); }),
            "A number that equal teas share, on every machine: that of `pastoso-cli tea --stats`.")
        .def_property_readonly(
            "threads", [](const TeaWork& work) { return work.pool->thread_count(); },
            "How many threads compute; the bits are the same with any number.");
}

}  // namespace pastoso::python
