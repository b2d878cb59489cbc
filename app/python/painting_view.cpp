#include "python/painting_view.hpp"

#include "document/well.hpp"
#include "python/arrays.hpp"
#include "python/film_fields.hpp"
#include "python/pictures.hpp"

#include <utility>

namespace pastoso::python {
namespace {

namespace py = pybind11;

document::Snapshot snapshot_of(PaintingWork& work) {
    return work.turn.take([&] { return work.painting->snapshot(); });
}

/// What is visible of the canvas, or the mixing well.
film::FilmState film_of(PaintingWork& work, bool well) {
    document::Snapshot snapshot = snapshot_of(work);
    return well ? snapshot.well.value_or(document::bare_well()) : std::move(snapshot.film);
}

}  // namespace

py::array read_painting(PaintingWork& work, const std::string& name, const py::object& out, bool well) {
    const FilmField& field = find_field(name);
    const film::FilmState film = film_of(work, well);
    Sizes sizes = {film.shape.height, film.shape.width};
    if (field.channels > 1) sizes.push_back(field.channels);
    py::array array = output_array(out, sizes);
    auto* values = static_cast<float*>(array.mutable_data());
    const py::gil_scoped_release released;
    read_field(film, field, *work.pool, values);
    return array;
}

py::array render_painting(PaintingWork& work, const py::kwargs& wanted) {
    const bool well = wanted.contains("well") && wanted["well"].cast<bool>();
    const py::kwargs others(py::reinterpret_steal<py::dict>(PyDict_Copy(wanted.ptr())));
    if (others.contains("well")) PyDict_DelItemString(others.ptr(), "well");
    const PictureWish wish = picture_wish(others);
    // Of the tiles that there were at the moment: the painting may go on meanwhile.
    const film::FilmState film = film_of(work, well);
    RenderedPicture picture;
    {
        const py::gil_scoped_release released;
        picture = rendered(film, document::kPrimedGround, wish, *work.pool);
    }
    return array_of(std::move(picture));
}

py::list layers_of(PaintingWork& work) {
    const document::Snapshot snapshot = snapshot_of(work);
    py::list list;
    for (std::size_t i = 0; i < snapshot.layers->layers.size(); ++i) {
        const document::Layer& layer = snapshot.layers->layers[i];
        py::dict entry;
        entry["number"] = layer.id;
        entry["name"] = layer.look.name;
        entry["visible"] = layer.look.visible;
        entry["locked"] = layer.look.locked;
        entry["bare_locked"] = layer.look.bare_locked;
        entry["clipped"] = layer.look.clipped;
        entry["opacity"] = layer.look.opacity;
        entry["group"] = layer.group;
        entry["active"] = i == snapshot.layers->active;
        list.append(entry);
    }
    return list;
}

py::dict account_of(PaintingWork& work) {
    const document::Account account = work.turn.take([&] { return work.painting->account(); });
    py::dict result;
    result["taken_mm3"] = account.taken.volume_mm3;
    result["canvas_mm3"] = account.canvas.volume_mm3;
    result["dried_mm3"] = account.dried.volume_mm3;
    result["brush_mm3"] = account.brush.volume_mm3;
    result["well_mm3"] = account.well.volume_mm3;
    result["ledger_mm3"] = account.ledger.volume_mm3;
    result["volume_error_rel"] = account.volume_error_rel();
    result["pigment_error_rel"] = account.pigment_error_rel();
    return result;
}

py::list step_names(const std::vector<document::KeptStep>& kept) {
    py::list names;
    for (const document::KeptStep& step : kept)
        names.append(std::string(step.step.name));
    return names;
}

}  // namespace pastoso::python
