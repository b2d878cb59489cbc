#include "film/laboratory/simulation.hpp"

#include "core/check.hpp"

namespace pastoso::film {

Simulation::Simulation(const Scene& scene, core::ThreadPool& pool)
    : scene_(scene), film_(make_film(scene)), solver_(film_, scene.medium, scene.solver, pool) {
    solver_.set_gravity(scene.gravity);
    // Only what forces and measures depend on is looked at from now on; images need memory.
    scene_.film.clear();
    scene_.support.clear();
}

void Simulation::advance_to(double time_s, const std::function<void()>& watch) {
    PASTOSO_CHECK_OP(time_s, >=, time_s_);
    const auto never = [&watch] {
        watch();
        return false;
    };
    report_.add(*solver_.advance_unless(never, time_s - time_s_));
    time_s_ = time_s;
}

bool Simulation::advance_to_unless(const std::function<bool()>& cancelled, double time_s) {
    PASTOSO_CHECK_OP(time_s, >=, time_s_);
    const std::optional<AdvanceReport> report = solver_.advance_unless(cancelled, time_s - time_s_);
    if (!report) return false;
    report_.add(*report);
    time_s_ = time_s;
    return true;
}

double Simulation::runoff_mm3() const {
    return volume_mm3(solver_.runoff().thickness, film_.cell_mm);
}

Measures Simulation::measures() const {
    return measure(film_, scene_.medium, scene_.gravity, scene_.solver);
}

std::optional<Front> Simulation::front() const {
    return front_of(film_, scene_.gravity);
}

std::vector<ProfilePoint> Simulation::profile(Axis axis, double at_mm) const {
    return profile_along(axis, at_mm, film_, scene_.solver);
}

}  // namespace pastoso::film
