// A scene on its way through time.
#pragma once

#include "core/thread_pool.hpp"
#include "film/laboratory/front.hpp"
#include "film/laboratory/measures.hpp"
#include "film/laboratory/scene.hpp"

#include <functional>
#include <optional>

namespace pastoso::film {

class Simulation {
  public:
    /// Throws InputError where make_film() or Solver() do.
    Simulation(const Scene& scene, core::ThreadPool& pool);

    /// Lets paint time pass until `time_s`, which is not earlier than now. A fixed step is shortened to
    /// divide that stretch evenly. `watch` is called before every step and may throw to stop.
    void advance_to(
        double time_s, const std::function<void()>& watch = [] {});

    /// The same, but `cancelled` is asked before every step; once it says true the film is put back as
    /// it was and false is returned.
    bool advance_to_unless(const std::function<bool()>& cancelled, double time_s);

    double time_s() const { return time_s_; }
    const FilmState& film() const { return film_; }
    const AdvanceReport& report() const { return report_; }  ///< summed from the start
    double runoff_mm3() const;                               ///< what ran off open edges from the start

    Measures measures() const;
    std::optional<Front> front() const;
    std::vector<ProfilePoint> profile(Axis axis, double at_mm) const;

  private:
    Scene scene_;
    FilmState film_;
    Solver solver_;
    AdvanceReport report_;
    double time_s_ = 0.0;
};

}  // namespace pastoso::film
