// A scene of the laboratory on its way through time, for Python.
#pragma once

#include "core/thread_pool.hpp"
#include "film/laboratory/simulation.hpp"
#include "python/turn.hpp"
#include "recordings/scene_json.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pastoso::python {

/// Arrays of a scene given by Python: one of the forms or reliefs of a run, whose values they are.
struct SceneArray {
    bool of_support = false;
    std::size_t place = 0;  ///< in the scene's list
    std::span<const float> values;
};

struct FilmWork {
    std::shared_ptr<core::ThreadPool> pool;
    std::string title;
    bool cell_units = false;
    recordings::SceneRun run;
    std::vector<double> stops_s;
    std::optional<film::Simulation> simulation;  ///< there is one from the beginning
    Turn turn;

    const film::FilmState& film() const { return simulation->film(); }
};

/// The run of that name; "" of the only one. Throws InputError that lists the names there are.
recordings::SceneRun find_run(const recordings::SceneFile& file, const std::string& name,
                              const std::string& run);

/// Makes the film of a run. `name` stands for the scene in sentences. Throws InputError where the film
/// cannot be made.
void make_film(const std::string& name, const std::vector<SceneArray>& arrays, FilmWork& work);

/// Lets paint time pass. False where `interruption` says so: the film is then as it was.
bool advance_to(double time_s, Interruption& interruption, FilmWork& work);

}  // namespace pastoso::python
