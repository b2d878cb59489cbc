#include "core/error.hpp"
#include "core/progress.hpp"
#include "document/actions/field_checks.hpp"
#include "liquid_files/tank_json.hpp"
#include "liquid_files/tank_stats.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/meshes.hpp"
#include "python/pools.hpp"
#include "python/traced.hpp"
#include "python/turn.hpp"
#include "tank/liquid_tank.hpp"
#include "tank/solid_mesh.hpp"
#include "tank/tank_surface.hpp"
#include "trace/tank_scene.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <pybind11/stl.h>

namespace pastoso::python {
namespace {

namespace py = pybind11;

struct TankWork {
    TankWork(std::shared_ptr<core::ThreadPool> threads, const tank::TankScene& scene)
        : pool(std::move(threads)), tank(scene), surfaces(tank.domain(), *pool) {}

    std::shared_ptr<core::ThreadPool> pool;
    tank::LiquidTank tank;
    tank::TankSurfaces surfaces;
    Turn turn;
};

std::unique_ptr<TankWork> make_tank(const std::optional<std::string>& text, const std::string& name,
                                    const std::string& folder, int threads) {
    const tank::TankScene scene =
        text ? liquid_files::tank_from_json(*text, name, liquid_files::meshes_in(folder))
             : liquid_files::read_tank(name);
    std::shared_ptr<core::ThreadPool> pool = pool_of(threads);
    const py::gil_scoped_release released;
    return std::make_unique<TankWork>(std::move(pool), scene);
}

/// The time at which it stops lies between two steps, wherever that is.
void advance_to(TankWork& work, double time_s) {
    Interruption interruption;
    work.turn.take([&] {
        document::check_between("time", "s", time_s, work.tank.time_s(), tank::kLastTime_s);
        try {
            work.tank.advance_to(time_s, *work.pool, [&](const tank::TankStep&) {
                if (interruption.wanted()) throw core::GivenUp{};
            });
        } catch (const core::GivenUp&) {
        }
    });
    interruption.rethrow();
}

py::object read(TankWork& work, const std::string& name, int parts) {
    if (name == "velocity") {
        liquid::VelocityField velocity;
        work.turn.take([&] { velocity = work.tank.velocity(); });
        return arrays_of(std::move(velocity));
    }
    if (name != "level" && name != "milk")
        throw core::InputError(
            "there is no field \"%1\" of a tank; the fields are level, milk and velocity.", name);
    document::check_between("number of parts", "", parts, 1, 4);
    tank::TankFrame frame;
    work.turn.take([&] { frame = work.tank.frame(parts, *work.pool); });
    if (name == "milk") return array_of(std::move(frame.milk));
    return array_of(std::move(frame.level_m));
}

py::array particles(TankWork& work) {
    using tank::Particle;
    auto owner = std::make_unique<std::vector<Particle>>();
    work.turn.take([&] { owner->assign(work.tank.particles().begin(), work.tank.particles().end()); });
    const py::dtype type = record_type({{"position_m", "3f4", offsetof(Particle, position_m)},
                                        {"milk", "f4", offsetof(Particle, milk)},
                                        {"velocity_m_s", "3f4", offsetof(Particle, velocity_m_s)}},
                                       sizeof(Particle));
    const auto count = static_cast<py::ssize_t>(owner->size());
    const void* first = owner->data();
    return py::array(type, Sizes{count}, first, keeper(std::move(owner)));
}

py::tuple surface(TankWork& work, int parts) {
    document::check_between("number of parts", "", parts, 1, 4);
    liquid::TriangleMesh mesh;
    work.turn.take([&] { work.surfaces.make(work.tank.frame(parts, *work.pool), 0.0F, mesh); });
    return arrays_of(std::move(mesh));
}

py::tuple solids(TankWork& work, int parts) {
    document::check_between("number of parts", "", parts, 1, 8);
    liquid::TriangleMesh mesh;
    work.turn.take([&] { mesh = tank::solid_mesh(work.tank.scene(), parts, *work.pool); });
    return arrays_of(std::move(mesh));
}

/// As fine as pictures of the command line have them: points along a cell.
constexpr int kPictureParts = 2, kPictureSolidParts = 3;

trace::Scene scene_of(TankWork& work, float aspect) {
    const tank::TankFrame frame = work.tank.frame(kPictureParts, *work.pool);
    liquid::TriangleMesh surface;
    work.surfaces.make(frame, trace::kTankOverlap_cells * work.tank.shape().cell_m, surface);
    return trace::tank_scene(frame.milk, std::move(surface),
                             tank::solid_mesh(work.tank.scene(), kPictureSolidParts, *work.pool),
                             aspect);
}

py::array render(TankWork& work, int width, int height, int samples, bool denoise,
                 const py::object& dtype) {
    const TracedWish wish = traced_wish(width, height, samples, denoise, dtype);
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    Interruption interruption;
    RenderedPicture picture;
    work.turn.take([&] { picture = traced(scene_of(work, aspect), wish, *work.pool, interruption); });
    interruption.rethrow();
    return array_of(std::move(picture));
}

template <class Value>
auto seen(Value (*value)(const TankWork&)) {
    return [value](TankWork& work) { return work.turn.take([&] { return value(work); }); };
}

}  // namespace

void add_tank(py::module_& module) {
    py::class_<TankWork>(module, "Tank", "What pastoso.Tank is made of.")
        .def(py::init(&make_tank), py::arg("text"), py::arg("name"), py::arg("folder"),
             py::arg("threads"))
        .def("advance_to", &advance_to, py::arg("time_s"),
             "Lets time pass until `time_s`, not earlier than now, in steps as long as the Courant "
             "number allows.\n\n"
             "The last step ends there, so that the bits depend on where the time is cut: the command "
             "line cuts it at\n"
             "n / fps. Python's other threads go on meanwhile; Ctrl+C stops between two steps.")
        .def("read", &read, py::arg("name"), py::arg("parts") = 2,
             "A field, float32 (z, y, x) with z up: \"level\", the signed distance from the surface in "
             "m, negative in\n"
             "the liquid, at `parts` (1 to 4) points along a cell and a cell more on every side; "
             "\"milk\", its share in\n"
             "cells that have liquid or lie beside it; \"velocity\", three arrays in m/s on the faces "
             "across x\n"
             "(z, y, x + 1), y and z. The engine fills or copies it once; the array is a view of that.")
        .def("particles", &particles,
             "What carries the liquid, a structured array (count,): position_m (3), m; milk, its share; "
             "velocity_m_s\n"
             "(3), m/s. Empty for methods without particles.")
        .def("render", &render, py::arg("width") = 800, py::arg("height") = 800, py::kw_only(),
             py::arg("samples") = 48, py::arg("denoise") = true, py::arg("dtype") = "uint8",
             "A path-traced picture of the whole tank, (height, width, 3), as `pastoso-cli tank` draws "
             "it.\n\n"
             "dtype: uint8, as a screen shall show it, sRGB; or float32, the radiance in linear light.\n"
             "samples: paths for a pixel; denoise: takes the noise of these out. Ctrl+C stops it.")
        .def("surface_arrays", &surface, py::arg("parts") = 2,
             "What surface() is made of, as in Mesh: m, float32 (vertices, 3); the same or None;\n"
             "uint32 (triangles, 3).")
        .def("solid_arrays", &solids, py::arg("parts") = 3,
             "What solids() is made of, as in Mesh: m, float32 (vertices, 3); the same or None;\n"
             "uint32 (triangles, 3).")
        .def(
            "open_drains",
            [](TankWork& work, bool open) { work.turn.take([&] { work.tank.open_drains(open); }); },
            py::arg("open"), "Whether drains drain, at the times of the scene.")
        .def("volume_m3",
             seen<double>([](const TankWork& work) { return work.tank.volume_m3(*work.pool); }),
             "Volume of the liquid, m3.")
        .def("scene_json", seen<std::string>([](const TankWork& work) {
                 return liquid_files::tank_to_json(work.tank.scene());
             }),
             "The scene as JSON.")
        .def_property_readonly("time_s",
                               seen<double>([](const TankWork& work) { return work.tank.time_s(); }),
                               "Seconds that have passed.")
        .def_property_readonly("steps",
                               seen<int>([](const TankWork& work) { return work.tank.steps(); }),
                               "Steps that have been taken.")
        .def_property_readonly("brought_m3",
                               seen<double>([](const TankWork& work) { return work.tank.brought_m3(); }),
                               "What jets brought less what drains took, m3.")
        .def_property_readonly("fastest_m_s", seen<double>([](const TankWork& work) {
                                   return static_cast<double>(work.tank.fastest_m_s());
                               }),
                               "The largest component of the velocity, m/s.")
        .def_property_readonly(
            "state_hash", seen<std::uint64_t>([](const TankWork& work) {
                return liquid_files::state_hash(work.tank.state());
            }),
            "A number that equal tanks share, on every machine: that of `pastoso-cli tank --stats`.")
        .def_property_readonly(
            "threads", [](const TankWork& work) { return work.pool->thread_count(); },
            "How many threads compute; the bits are the same with any number.");
}

}  // namespace pastoso::python
