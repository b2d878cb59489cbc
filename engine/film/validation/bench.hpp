// A film with a solver on a small canvas, in the units of the analytic solutions: millimetres and
// seconds, with one-millimetre cells unless a case refines them.
#pragma once

#include "core/thread_pool.hpp"
#include "film/solver.hpp"
#include "film/state.hpp"

#include <functional>
#include <memory>

namespace pastoso::film::validation {

struct Setup {
    int width = 32, height = 32;  ///< cells
    double cell_mm = 1.0;
    double gravity = 0.0;                 ///< g, mm/s2, normal to the canvas
    double force_x = 0.0, force_y = 0.0;  ///< mm/s2
    double viscosity = 1.0;               ///< nu, mm2/s
    double tension = 0.0;                 ///< sigma/rho, mm3/s2
    double yield = 0.0;                   ///< tau_y/rho, mm2/s2
    double alpha_min = 1.0, alpha_max = 1.0;
    double tan_advancing = 0.0, tan_receding = 0.0;
    double slip_cells = 0.0;
    double horizontal_tension = 0.0;  ///< chi
    double flow_index = 1.0;
    double structure_share = 0.0, recovery_s = 10.0, breakdown_strain = 10.0;
    Edge edge_x = Edge::Periodic, edge_y = Edge::Periodic;
    bool inertia = true, lateral = true, full_curvature = false, sleeping = false;
    int threads = 1;
    SolverOptions solver = {};  ///< what the fields above do not say, the scheme above all
    std::function<void()> watch = [] {};  ///< called by Bench::pass() at every tick; may throw to stop
};

/// The paint of a setup, of density 1000 kg/m3.
Medium medium_of(const Setup& setup);

class Bench {
  public:
    explicit Bench(const Setup& setup);

    /// Sets h (mm) in every cell, rounded to whole quanta.
    void fill(const std::function<double(int x, int y)>& thickness_mm);
    void set_support(const std::function<double(int x, int y)>& height_mm);
    /// Makes a share of every cell's paint paint of another medium.
    void mix_in(const Medium& other, const std::function<double(int x, int y)>& share);

    double h(int x, int y) const { return thickness_mm(state.thickness.at(x, y)); }
    double u(int x, int y) const { return state.velocity_x.at(x, y); }
    double v(int x, int y) const { return state.velocity_y.at(x, y); }
    double volume() const;  ///< sum of h, mm; times the cell area in mm3
    double max_h() const;

    /// Steps of dt until `seconds` have passed; returns what happened.
    AdvanceReport run(double dt_s, double seconds);

    /// Lets `seconds` pass as a painting does, in ticks of 1/60 s, the last of which may be shorter,
    /// with steps of the solver's own length.
    void pass(double seconds);

    Setup setup;
    core::ThreadPool pool;
    FilmState state;
    std::unique_ptr<Solver> solver;
    double passed_s = 0.0;  ///< by pass()
};

}  // namespace pastoso::film::validation
