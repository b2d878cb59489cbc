#include "core/check.hpp"
#include "document/painting.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/film_fields.hpp"
#include "python/film_figures.hpp"
#include "python/film_work.hpp"
#include "python/pictures.hpp"
#include "python/pools.hpp"

#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

namespace pastoso::python {
namespace {

namespace py = pybind11;

/// An array that Python gives for a scene: whether it is the support's, where it stands, and the
/// heights.
using GivenArray = std::tuple<bool, std::size_t, py::array>;

std::vector<SceneArray> scene_arrays(const std::vector<GivenArray>& given, const grid::Shape& shape) {
    std::vector<SceneArray> arrays;
    for (const auto& [of_support, place, values] : given) {
        const std::string name = (of_support ? "support[" : "film[") + std::to_string(place) + "]";
        arrays.push_back({of_support, place, floats_of(values, {shape.height, shape.width}, name)});
    }
    return arrays;
}

/// Of a text, or where there is none of the file or bundled scene that `name` is.
std::unique_ptr<FilmWork> make_work(const std::optional<std::string>& text, const std::string& name,
                                    const std::string& folder, const std::string& run,
                                    std::optional<int> threads, const std::vector<GivenArray>& given) {
    recordings::SceneFile file =
        text ? recordings::scene_from_json(*text, name, folder) : recordings::read_scene(name);
    auto work = std::make_unique<FilmWork>();
    work->run = find_run(file, name, run);
    work->title = file.title;
    work->cell_units = file.cell_units;
    work->pool = pool_of(threads.value_or(file.threads));
    const std::vector<SceneArray> arrays = scene_arrays(given, work->run.scene.shape);
    work->turn.take([&] { make_film(name, arrays, *work); });
    return work;
}

void advance(FilmWork& work, double seconds, bool until) {
    Interruption interruption;
    work.turn.take(
        [&] { advance_to(until ? seconds : work.simulation->time_s() + seconds, interruption, work); });
    interruption.rethrow();
}

py::array read(FilmWork& work, const std::string& name, const py::object& out) {
    const FilmField& field = find_field(name);
    const grid::Shape shape = work.run.scene.shape;
    Sizes sizes = {shape.height, shape.width};
    if (field.channels > 1) sizes.push_back(field.channels);
    py::array array = output_array(out, sizes);
    auto* values = static_cast<float*>(array.mutable_data());
    work.turn.take([&] { read_field(work.film(), field, *work.pool, values); });
    return array;
}

py::array render(FilmWork& work, const py::kwargs& wanted) {
    PictureWish wish = picture_wish(wanted);
    RenderedPicture picture;
    // Of the tiles that the film had at the moment: it may go on meanwhile.
    film::FilmState film;
    work.turn.take([&] { film = work.film(); });
    {
        const py::gil_scoped_release released;
        picture = rendered(film, document::kPrimedGround, wish, *work.pool);
        film = {};
    }
    return array_of(std::move(picture));
}

/// For those who test what comes of it.
void break_invariant(FilmWork& work) {
    work.turn.take([&] { PASTOSO_CHECK_OP(work.film().cell_mm, <, 0.0); });
}

template <class Value>
auto seen(Value (*value)(const FilmWork&)) {
    return [value](FilmWork& work) { return work.turn.take([&] { return value(work); }); };
}

}  // namespace

void add_film(py::module_& module) {
    py::class_<FilmWork>(module, "Film", "What pastoso.Film is made of.")
        .def(py::init(&make_work), py::arg("text"), py::arg("name"), py::arg("folder"), py::arg("run"),
             py::arg("threads"), py::arg("arrays"))
        .def(
            "advance", [](FilmWork& work, double seconds) { advance(work, seconds, false); },
            py::arg("seconds"),
            "Lets so many seconds of paint time pass, in as many steps as stability asks for.\n\n"
            "A fixed step (\"step_s\" of the scene) is shortened to divide them evenly, so that the "
            "bits depend on\n"
            "where the time is cut; run() cuts it as the command line does. Python's other threads go "
            "on. Ctrl+C\n"
            "puts the film back to where it was. InputError for less than 0 s, and beyond 1e6 s in all.")
        .def(
            "advance_to", [](FilmWork& work, double time_s) { advance(work, time_s, true); },
            py::arg("time_s"),
            "advance() until `time_s`, in seconds since the scene began, not earlier than now.")
        .def(
            "read", &read, py::arg("name"), py::arg("out") = py::none(),
            "A field as an array of float32, one row of numbers for each row of cells, from the top.\n\n"
            "name: \"thickness\", \"support\" or \"surface\", (height, width), mm; \"velocity\", "
            "(height, width, 2),\n"
            "mm/s; \"pigment\", (height, width, 12), K h and S h of six bands, without a unit.\n"
            "out: an array to write into, float32, row by row, of that shape; otherwise a new one is "
            "made.\n"
            "The engine counts paint in whole quanta, in tiles: this is the one conversion. Returns the "
            "array.")
        .def("measures", &measures_of,
             "Sums and extremes, as a dict: volume_mm3, max_thickness_mm, centroid_mm (x, y), "
             "wet_box_mm (left, top,\n"
             "right, bottom), kinetic_energy_J, gravity_energy_J, surface_energy_J, and runoff_mm3, "
             "what has run off\n"
             "open edges. nan where a dry canvas has none.")
        .def("front", &front_of,
             "Of paint that runs along a force: tip_mm, the foremost point along it, width_mm, "
             "radius_mm, roundness,\n"
             "fullness and thickness_mm, as a dict; None without paint or force, and for a front of "
             "less than 8 cells.")
        .def("profile", &profile_of, py::arg("along"), py::arg("at_mm"),
             "The line y = at_mm (along \"x\") or x = at_mm (along \"y\"), an array of float64 (cells, "
             "5): place mm,\n"
             "support mm, thickness mm, velocity along x and along y in mm/s.")
        .def("_break_invariant", &break_invariant)
        .def("report", &report_of,
             "What stepping has taken so far, as a dict: steps; clamped_faces, whose speed was cut; "
             "rejected_steps,\n"
             "tried again in halves; lagging_steps, in which paint went slower than it would.")
        .def("render", &render,
             "The film under light, an array (height, width, 3) of uint8 (sRGB) or float32 (linear "
             "light).\n\n"
             "Keywords: scale, pixels per cell (1/64 to 64; default 1); cells, (left, top, right, "
             "bottom);\n"
             "dtype, \"uint8\" or \"float32\"; lit, False for the paint's colours without light and "
             "shade; light,\n"
             "\"D65\", \"D50\", \"A\", \"LED\" or the path of a spectrum; azimuth_deg, elevation_deg, "
             "ambient, specular,\n"
             "wet_roughness, dry_roughness.")
        .def_property_readonly(
            "time_s", seen<double>([](const FilmWork& work) { return work.simulation->time_s(); }),
            "Seconds of paint time that have passed.")
        .def_property_readonly("state_hash", seen<std::uint64_t>([](const FilmWork& work) {
                                   return film::state_hash(work.film());
                               }),
                               "A number that equal films share, on every machine.")
        .def_property_readonly(
            "shape",
            [](const FilmWork& work) {
                return py::make_tuple(work.run.scene.shape.height, work.run.scene.shape.width);
            },
            "(height, width) in cells.")
        .def_property_readonly(
            "cell_mm", [](const FilmWork& work) { return work.run.scene.cell_mm; },
            "Side of a cell, mm; in scenes of cells a cell counts as one.")
        .def_property_readonly(
            "duration_s", [](const FilmWork& work) { return work.run.scene.duration_s; },
            "How long the scene lasts, s.")
        .def_property_readonly(
            "title", [](const FilmWork& work) { return work.title; }, "What the scene is called.")
        .def_property_readonly(
            "stops_s", [](const FilmWork& work) { return work.stops_s; },
            "Times, s, at which the command line looks at the film, from 0 to the duration.")
        .def_property_readonly(
            "threads", [](const FilmWork& work) { return work.pool->thread_count(); },
            "How many threads compute; the bits are the same with any number.");
    module.def(
        "scene_runs",
        [](const std::optional<std::string>& text, const std::string& name, const std::string& folder) {
            const recordings::SceneFile file =
                text ? recordings::scene_from_json(*text, name, folder) : recordings::read_scene(name);
            std::vector<std::string> names;
            for (const recordings::SceneRun& run : file.runs)
                if (!run.name.empty()) names.push_back(run.name);
            return names;
        },
        py::arg("text"), py::arg("name"), py::arg("folder"),
        "The names of a scene's runs; none of a single one.");
}

}  // namespace pastoso::python
