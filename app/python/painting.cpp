#include "document/painting.hpp"

#include "core/error.hpp"
#include "document/actions/field_checks.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/painting_files.hpp"
#include "python/painting_view.hpp"
#include "python/painting_work.hpp"
#include "python/pools.hpp"
#include "recordings/recording_json.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace pastoso::python {
namespace {

namespace py = pybind11;

/// Columns of Python's samples: time, x, y, pressure, then what may be left out.
Stroke stroke_of(const py::array_t<double>& samples, const std::string& surface, bool flows) {
    if (samples.ndim() != 2 || samples.shape(1) < 4 || samples.shape(1) > 7)
        throw core::InputError(
            "samples are an array (count, 4 to 7) of time, x, y, pressure, tilt_x, tilt_y and rotation; "
            "here it is %1.",
            shape_text({samples.shape(), samples.shape() + samples.ndim()}));
    if (surface != "canvas" && surface != "well")
        throw core::InputError(
            "there is no surface \"%1\"; a stroke is on the \"canvas\" or the \"well\".", surface);
    Stroke stroke;
    stroke.surface = surface == "well" ? document::Surface::Well : document::Surface::Canvas;
    stroke.flows = flows;
    const auto numbers = samples.unchecked<2>();
    const auto number = [&](py::ssize_t row, py::ssize_t column) {
        return column < numbers.shape(1) ? numbers(row, column) : 0.0;
    };
    for (py::ssize_t i = 0; i < numbers.shape(0); ++i)
        stroke.samples.push_back({number(i, 0), number(i, 1), number(i, 2), number(i, 3), number(i, 4),
                                  number(i, 5), number(i, 6)});
    return stroke;
}

void paint_stroke(PaintingWork& work, const py::array_t<double>& samples, const std::string& surface,
                  bool flow) {
    Stroke stroke = stroke_of(samples, surface, flow);
    Interruption interruption;
    work.turn.take([&] { paint(std::move(stroke), interruption, work); });
    interruption.rethrow();
}

void advance(PaintingWork& work, double seconds) {
    Interruption interruption;
    work.turn.take([&] { pass_ticks(ticks_of(seconds), interruption, work); });
    interruption.rethrow();
}

std::unique_ptr<PaintingWork> from_recording(const std::optional<std::string>& text,
                                             const std::string& name, const std::string& folder,
                                             int threads) {
    std::shared_ptr<core::ThreadPool> pool = pool_of(threads);
    Interruption interruption;
    std::unique_ptr<PaintingWork> work;
    {
        const py::gil_scoped_release released;
        work = replayed(recording_of(text, name, folder), name, std::move(pool), interruption);
    }
    interruption.rethrow();
    return work;
}

std::unique_ptr<PaintingWork> from_project(const std::string& path, int threads) {
    std::shared_ptr<core::ThreadPool> pool = pool_of(threads);
    const py::gil_scoped_release released;
    return opened(path, std::move(pool));
}

void paint_picture(PaintingWork& work, const py::array_t<std::uint8_t, py::array::c_style>& pixels,
                   const std::string& name, const std::array<double, 4>& place_mm) {
    document::PaintPicture paint;
    paint.name = name;
    paint.place = {place_mm[0], place_mm[1], place_mm[2], place_mm[3]};
    paint.picture = picture_of(pixels);
    work.turn.take([&] { perform(paint, work); });
}

void set_undo_memory(PaintingWork& work, double mib) {
    document::check_between("memory for undo", "MiB", mib, 0.0, 1e6);
    work.turn.take([&] { work.painting->set_history_budget(static_cast<std::size_t>(mib * 0x1p20)); });
}

template <class Value>
auto seen(Value (*value)(const document::Painting&)) {
    return [value](PaintingWork& work) { return work.turn.take([&] { return value(*work.painting); }); };
}

}  // namespace

void add_painting(py::module_& module) {
    py::class_<PaintingWork>(module, "Painting", "What pastoso.Painting is made of.")
        .def(py::init(&from_recording), py::arg("text"), py::arg("name"), py::arg("folder"),
             py::arg("threads"))
        .def(py::init(&from_project), py::arg("path"), py::arg("threads"))
        .def(
            "apply_json",
            [](PaintingWork& work, const std::string& text) {
                work.turn.take([&] { perform(action_of(text), work); });
            },
            py::arg("text"), "What apply() does, of an action as JSON.")
        .def("stroke", &paint_stroke, py::arg("samples"), py::arg("surface") = "canvas",
             py::arg("flow") = true,
             "Paints a stroke: the pen comes down, moves and lifts.\n\n"
             "samples: an array (count, 4 to 7) of time s, x mm, y mm, pressure 0 to 1, and where given "
             "tilt_x and\n"
             "tilt_y in degrees (-90 to 90, to the right and down the canvas) and rotation in degrees "
             "(clockwise).\n"
             "float64 is read where it lies, whatever its strides; other numbers are converted first. x "
             "runs right\n"
             "and y down from the upper left corner. Times do not decrease; the first of them is now.\n"
             "surface: \"canvas\", or \"well\" for the mixing well.\n"
             "flow: whether paint time passes while the pen moves, as under a hand; otherwise the "
             "stroke takes none.\n"
             "Python's other threads go on meanwhile. InputError without a brush in hand, on a layer "
             "that is hidden\n"
             "or locked, and for a sample that cannot be, which it names; the painting is then as it "
             "was.")
        .def("advance", &advance, py::arg("seconds"),
             "Lets so many seconds of paint time pass, in whole ticks of 1/60 s: paint runs, settles "
             "and dries.\n\n"
             "Python's other threads go on meanwhile. Ctrl+C stops between two ticks.")
        .def("read", &read_painting, py::arg("name"), py::arg("out") = py::none(),
             py::arg("well") = false,
             "A field of what is visible, as an array of float32, from the top row of cells down.\n\n"
             "name: \"thickness\", \"support\" or \"surface\", (height, width), mm; \"velocity\", "
             "(height, width, 2),\n"
             "mm/s; \"pigment\", (height, width, 12), K h and S h of six bands, without a unit. Dried "
             "paint counts as\n"
             "support. out: an array to write into, float32, row by row, of that shape. well: of the "
             "mixing well.\n"
             "The engine counts paint in whole quanta, in tiles: this is the one conversion. Returns "
             "the array.")
        .def("render", &render_painting,
             "The painting under light, an array (height, width, 3) of uint8 (sRGB) or float32 (linear "
             "light).\n\n"
             "Keywords: scale, pixels per cell (1/64 to 64; default 1); cells, (left, top, right, "
             "bottom);\n"
             "dtype, \"uint8\" or \"float32\"; lit, False for the paint's colours without light and "
             "shade; light,\n"
             "\"D65\", \"D50\", \"A\", \"LED\" or the path of a spectrum; azimuth_deg, elevation_deg, "
             "ambient, specular,\n"
             "wet_roughness, dry_roughness; well, True for the mixing well.\n"
             "The array lies in the memory that the picture was rendered into.")
        .def("paint_picture", &paint_picture, py::arg("pixels"), py::arg("name"), py::arg("place_mm"),
             "Adds a layer that holds a picture as thin, dry paint, and makes it active.\n\n"
             "pixels: uint8 (height, width, 3 or 4), sRGB and coverage; place_mm: left, top, width and "
             "height on the\n"
             "canvas, mm.")
        .def(
            "save",
            [](PaintingWork& work, const std::filesystem::path& path) {
                work.turn.take([&] { save(path, work); });
            },
            py::arg("path"),
            "Writes the painting with its wet paint as a project, NAME.pastoso; its strokes, as a "
            "recording,\n"
            "NAME.json; or its picture, NAME.png and what else is known. The file is written aside and "
            "renamed.")
        .def("set_undo_memory", &set_undo_memory, py::arg("mib"),
             "How much memory, MiB, the states that undo() returns to may take; 512 at first, 0 for no "
             "undo.")
        .def(
            "recording_json",
            [](PaintingWork& work) {
                return recordings::recording_to_json(
                    work.turn.take([&] { return work.recorder.recording(); }));
            },
            "What recording() gives, as JSON.")
        .def("layers", &layers_of,
             "The layers from below, dicts: number, name, visible, locked, bare_locked, clipped, "
             "opacity, group (0: none), active.")
        .def("account", &account_of,
             "Where all paint is, mm3: taken_mm3 from the tubes = canvas + dried + brush + well + "
             "ledger (what was\n"
             "wiped off, ran off or evaporated); and by how much the sum is wrong, relative: "
             "volume_error_rel,\n"
             "pigment_error_rel.")
        .def_property_readonly("time_s", seen<double>([](const document::Painting& painting) {
                                   return static_cast<double>(painting.tick()) * document::kTick_s;
                               }),
                               "Seconds of paint time that have passed.")
        .def_property_readonly("tick", seen<std::int64_t>([](const document::Painting& painting) {
                                   return painting.tick();
                               }),
                               "Ticks of 1/60 s that have passed.")
        .def_property_readonly("state_hash", seen<std::uint64_t>([](const document::Painting& painting) {
                                   return painting.state_hash();
                               }),
                               "A number that equal paintings share, on every machine: that of "
                               "`pastoso-cli replay --stats`.")
        .def_property_readonly(
            "shape",
            [](PaintingWork& work) {
                const grid::Shape shape = work.turn.take([&] { return work.painting->film().shape; });
                return py::make_tuple(shape.height, shape.width);
            },
            "(height, width) in cells.")
        .def_property_readonly("cell_mm", seen<double>([](const document::Painting& painting) {
                                   return painting.film().cell_mm;
                               }),
                               "Side of a cell, mm.")
        .def_property_readonly(
            "undo_steps",
            [](PaintingWork& work) {
                return step_names(work.turn.take([&] { return work.painting->undo_steps(); }));
            },
            "What undo() would take back, the oldest first.")
        .def_property_readonly(
            "redo_steps",
            [](PaintingWork& work) {
                return step_names(work.turn.take([&] { return work.painting->redo_steps(); }));
            },
            "What redo() would do again, the next one last.")
        .def_property_readonly(
            "notes", [](const PaintingWork& work) { return work.notes; },
            "Sentences that opening the file has told.")
        .def_property_readonly(
            "threads", [](const PaintingWork& work) { return work.pool->thread_count(); },
            "How many threads compute; the bits are the same with any number.");
}

}  // namespace pastoso::python
