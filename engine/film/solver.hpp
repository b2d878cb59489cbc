// Moves wet paint: depth-averaged thin-film flow on an uneven, tilted support (docs/physics.md).
#pragma once

#include "core/thread_pool.hpp"
#include "film/air_jet.hpp"
#include "film/medium.hpp"
#include "film/state.hpp"
#include "grid/mask.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace pastoso::film {

enum class Edge {
    Periodic,  ///< what leaves on one side enters on the other
    Wall,      ///< nothing passes
    Open,      ///< paint runs off and is counted
};

/// How time is stepped.
enum class Scheme {
    Auto,       ///< whichever gets through the time with less work
    Explicit,   ///< forward-backward steps below the stability limit
    LargeStep,  ///< implicit surface response, a few steps a frame
};

/// Gravity as the canvas feels it. tilt 0 lies flat, 90 stands upright; `direction_deg` is where "down"
/// points on the canvas: 0 to the right, 90 to its lower edge.
struct Gravity {
    double normal_mm_s2 = 0.0;  ///< presses the paint onto the support, >= 0
    double x_mm_s2 = 0.0;
    double y_mm_s2 = 0.0;
    friend bool operator==(const Gravity&, const Gravity&) = default;
};
Gravity tilted_gravity(double tilt_deg, double direction_deg = 90.0);

struct SolverOptions {
    Edge edge_x = Edge::Open;
    Edge edge_y = Edge::Open;
    Scheme scheme = Scheme::Auto;
    bool inertia = true;              ///< advection of momentum
    bool lateral_drag = true;         ///< viscosity between neighbouring columns of paint
    double horizontal_tension = 0.0;  ///< weight chi of the paper's horizontal surface tension, 0 to 1
    /// Whether the range of alpha goes by the surface tension's direction in space, or by that in the
    /// canvas' plane, as if even level paint stood upright.
    bool tension_in_space = true;
    bool full_curvature = true;  ///< curvature of the surface with its slope, not for small slopes only
    bool sleeping = true;        ///< tiles at rest are left out until something wakes them
    double fixed_step_s = 0.0;   ///< 0: the step follows the stability limit
    /// How long paint that hardly moves may lag behind, to be brought up to date in one step: a tile
    /// waits while nothing seen in it would move by two fifths of a cell. 0: advance() brings all
    /// paint up to date.
    double longest_wait_s = 0.0;
};

struct SolverState;

/// What a call of advance() did.
struct AdvanceReport {
    std::int64_t steps = 0;
    std::int64_t cells_stepped = 0;
    std::int64_t large_steps = 0;  ///< how many of the steps were implicit
    /// Face speeds cut to half a cell a step, and fluxes cut to the capacity left of a cell that is
    /// almost full (kMaxThickness_mm): 0 in a healthy run.
    std::int64_t clamped_faces = 0;
    std::int64_t rejected_steps = 0;  ///< large steps that had to be tried again in halves
    std::int64_t limited_cells = 0;   ///< whose outflow a large step cut to what they held
    std::int64_t lagging_steps = 0;  ///< large steps in which paint went slower than it would (StepPlan)
    std::int64_t sweeps = 0;          ///< of the large steps' solver over its tiles
    double largest_residual = 0.0;    ///< of a large step's equations before the last sweep, relative
    double largest_speed_mm_s = 0.0;
    int awake_tiles = 0;  ///< after the call

    void add(const AdvanceReport& other);
};

/// Steps a FilmState that it does not own. The state may be changed between calls (by a brush); the
/// changed cells are then announced with wake().
class Solver {
  public:
    /// Throws InputError when this program cannot do `options.scheme`.
    Solver(FilmState& state, const Medium& medium, const SolverOptions& options, core::ThreadPool& pool);
    ~Solver();

    /// Wakes all paint. What is wet keeps the numbers of its own medium (cell/wet_media.hpp). Paint of
    /// another consistency keeps that: where the state names one, what each cell carries is looked at.
    void set_medium(const Medium& medium);
    const Consistency& consistency() const;    ///< of the medium
    void set_gravity(const Gravity& gravity);  ///< wakes all paint when it changes
    /// Lets these jets blow on the paint until they are set anew; wakes what they reach. None: still
    /// air.
    void set_air(const std::vector<AirJet>& jets);

    /// Lets no paint flow into the cells of the mask nor out of them; null: none. What may flow again is
    /// for the caller to wake. Ends with reshape().
    void set_cover(std::shared_ptr<const grid::Mask> cover);

    /// Announces changed cells: their tiles are stepped until they have come to rest again.
    void wake(const grid::Rect& cells);
    /// The state may have become another one, all of which moves.
    void wake_all();

    /// The tiles that have not come to rest, by their number.
    std::vector<bool> awake_tiles() const;
    /// The state has become another one, in which these tiles move and the others rest.
    void restart(const std::vector<bool>& awake);

    /// The state has got another shape: all its paint is woken, and what ran off stays counted.
    void reshape();

    /// Lets `seconds` of paint time pass in as many steps as stability asks for. The same state and
    /// calls give the same bits on any number of threads.
    AdvanceReport advance(double seconds);

    /// The same, but `cancelled` is asked before every step; once it is true, the state is restored as
    /// it was and nothing is returned. A pen thus never waits for the end of a long advance.
    std::optional<AdvanceReport> advance_unless(const std::function<bool()>& cancelled, double seconds);

    /// One step of the given length over all awake tiles, whatever the stability limit; implicit if the
    /// scheme is LargeStep.
    AdvanceReport step(double dt_s);

    /// The largest stable step for Newtonian paint of this thickness,
    ///     (l + sqrt(l^2 + 4 w^2)) / w^2,  l = k_d nu / h^2,  w^2 = h K (g + sigma/rho K),  K =
    ///     8/cell^2,
    /// with the smallest k_d of the alpha range: gravity and capillary waves of the shortest wavelength
    /// under implicit drag.
    double stable_step_s(double thickness_mm) const;

    /// Paint that ran off open edges since the start.
    const Totals& runoff() const;
    int awake_tile_count() const;

    /// What the next advance() depends on besides the film, the medium, gravity and the air. A solver of
    /// an equal film that is given it, all else being equal, goes on to the same bits. Tiles are those
    /// of the film, and no number is infinite.
    SolverState state() const;
    void restore(const SolverState& state);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace pastoso::film
