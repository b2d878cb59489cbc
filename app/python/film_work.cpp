#include "python/film_work.hpp"

#include "core/error.hpp"
#include "core/naming.hpp"
#include "core/text.hpp"
#include "document/actions/field_checks.hpp"
#include "recordings/scene_stops.hpp"

namespace pastoso::python {
namespace {

constexpr double kLatest_s = 1e6;

/// Forms stand in the scene as slabs and reliefs as ramps that are flat: what their entries say else has
/// been read.
void put(const SceneArray& array, film::Scene& scene) {
    if (array.of_support)
        scene.support.at(array.place) = film::CellHeights{{array.values}};
    else
        scene.film.at(array.place).form = film::CellValues{array.values};
}

}  // namespace

recordings::SceneRun find_run(const recordings::SceneFile& file, const std::string& name,
                              const std::string& run) {
    if (run.empty() && file.runs.size() == 1) return file.runs.front();
    std::vector<std::string> names;
    for (const recordings::SceneRun& known : file.runs) {
        if (!run.empty() && known.name == run) return known;
        names.push_back(known.name);
    }
    if (file.runs.size() == 1 && names.front().empty())
        throw core::InputError("%1: has a single run, which has no name.", name);
    if (run.empty())
        throw core::InputError("%1: one of its runs has to be chosen; the runs are %2.", name,
                               core::listed(names));
    throw core::InputError("%1: there is no run \"%2\"; the runs are %3.", name, run,
                           core::listed(names));
}

void make_film(const std::string& name, const std::vector<SceneArray>& arrays, FilmWork& work) {
    const std::string label = work.run.name.empty() ? name : name + ", run \"" + work.run.name + "\"";
    film::Scene scene = work.run.scene;
    for (const SceneArray& array : arrays)
        put(array, scene);
    core::naming(label, [&] { work.simulation.emplace(scene, *work.pool); });
    work.stops_s = recordings::stops_of(work.run);
}

bool advance_to(double time_s, Interruption& interruption, FilmWork& work) {
    document::check_between("time", "s", time_s, work.simulation->time_s(), kLatest_s);
    return work.simulation->advance_to_unless([&] { return interruption.wanted(); }, time_s);
}

}  // namespace pastoso::python
