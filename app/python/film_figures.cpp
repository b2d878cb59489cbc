#include "python/film_figures.hpp"

#include "core/error.hpp"
#include "document/actions/field_checks.hpp"
#include "python/arrays.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace pastoso::python {

namespace py = pybind11;

py::dict measures_of(FilmWork& work) {
    film::Measures seen;
    double runoff_mm3 = 0.0;
    work.turn.take([&] {
        seen = work.simulation->measures();
        runoff_mm3 = work.simulation->runoff_mm3();
    });
    py::dict result;
    result["volume_mm3"] = seen.volume_mm3;
    result["max_thickness_mm"] = seen.max_h_mm;
    result["centroid_mm"] = py::make_tuple(seen.centroid.x_mm, seen.centroid.y_mm);
    result["wet_box_mm"] =
        py::make_tuple(seen.wet_box.x0_mm, seen.wet_box.y0_mm, seen.wet_box.x1_mm, seen.wet_box.y1_mm);
    result["kinetic_energy_J"] = seen.kinetic_energy_J;
    result["gravity_energy_J"] = seen.gravity_energy_J;
    result["surface_energy_J"] = seen.surface_energy_J;
    result["runoff_mm3"] = runoff_mm3;
    return result;
}

py::object front_of(FilmWork& work) {
    std::optional<film::Front> seen;
    work.turn.take([&] { seen = work.simulation->front(); });
    if (!seen) return py::none();
    py::dict result;
    result["tip_mm"] = seen->tip_mm;
    result["width_mm"] = seen->width_mm;
    result["radius_mm"] = seen->radius_mm;
    result["roundness"] = seen->roundness;
    result["fullness"] = seen->fullness;
    result["thickness_mm"] = seen->thickness_mm;
    return result;
}

py::array_t<double> profile_of(FilmWork& work, const std::string& along, double at_mm) {
    if (along != "x" && along != "y")
        throw core::InputError("a profile goes along \"x\" or \"y\", not along \"%1\".", along);
    const film::Axis axis = along == "x" ? film::Axis::X : film::Axis::Y;
    const film::Scene& scene = work.run.scene;
    document::check_between("place of the profile", "mm", at_mm, 0.0,
                            scene.cell_mm * (along == "x" ? scene.shape.height : scene.shape.width));
    std::vector<double> numbers;
    work.turn.take([&] {
        for (const film::ProfilePoint& point : work.simulation->profile(axis, at_mm))
            numbers.insert(numbers.end(), {point.along_mm, point.support_mm, point.thickness_mm,
                                           point.velocity_x_mm_s, point.velocity_y_mm_s});
    });
    const auto count = static_cast<py::ssize_t>(numbers.size() / 5);
    return array_of(std::move(numbers), {count, 5});
}

py::dict report_of(FilmWork& work) {
    film::AdvanceReport seen;
    work.turn.take([&] { seen = work.simulation->report(); });
    py::dict result;
    result["steps"] = seen.steps;
    result["clamped_faces"] = seen.clamped_faces;
    result["rejected_steps"] = seen.rejected_steps;
    result["lagging_steps"] = seen.lagging_steps;
    return result;
}

}  // namespace pastoso::python
