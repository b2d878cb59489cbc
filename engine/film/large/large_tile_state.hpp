// Where a tile stands in the large step under way.
#pragma once

namespace pastoso::film {

/// Six states that change apart from each other. A step begins with begin_step(), then repeats the loop
/// of a sweep until all errors are small; refine_all() and solve_within_supply() of the step change
/// equations between two sweeps.
///
///     a sweep
///       answer_pressure()    Change Moved, Beside --> New
///       enter_sweep()        Part Rests, Corrected --> Rests, Counts
///       choose_correction()  Part Counts --> Rests, Corrected; Cycles One --> Several
///       blend()              Change New, Known --> Known, Moved; Flow --> Stale where moved;
///                            Equations --> Same, Changed
///       join_moved()         Change Known --> Beside; Flow --> Stale
///
///     between sweeps
///       change_equations()   Change --> New; Equations --> Changed; Flow --> Stale
///       steady_drag()        Drag Unsteady --> Steady
///       unsettle_drag()      Drag --> Unsteady
///       note_flow()          Flow Stale --> Known
///
/// Another thread may read a tile's state while nobody calls what changes that tile.
class LargeTileState {
  public:
    /// d, the change of thickness that answers the pressure p.
    enum class Change {
        Known,   ///< d answers p, and the residuals around it are taken from it
        New,     ///< d answers p; the residuals around it are not taken from it yet
        Moved,   ///< the last sweep moved p
        Beside,  ///< it moved p of a tile that d depends on
    };
    /// What a tile does in the sweep under way, and did in the last one.
    enum class Part {
        Rests,      ///< its patch is not solved
        Counts,     ///< its error is of equations that changed, and will be judged
        Corrected,  ///< its patch is solved for a correction
    };
    /// Of its patch, as far as they lie in this tile.
    enum class Equations {
        Same,
        Changed,  ///< coefficients are new, or a correction too large to be trusted without another look
    };
    enum class Drag {
        Steady,
        Unsteady,  ///< that of the tile or of one beside it still changes with its flow
    };
    /// That its patch takes: several in a slow tile.
    enum class Cycles { One, Several };

    /// The velocities that p and the equations make.
    enum class Flow { Known, Stale };

    bool change_is_new() const { return change_ == Change::New; }
    bool change_is_stale() const { return change_ == Change::Moved || change_ == Change::Beside; }
    bool pressure_moved() const { return change_ == Change::Moved; }
    bool equations_changed() const { return equations_ == Equations::Changed; }
    bool is_corrected() const { return part_ == Part::Corrected; }
    bool is_slow() const { return cycles_ == Cycles::Several; }
    bool is_unsteady() const { return drag_ == Drag::Unsteady; }
    bool flow_is_stale() const { return flow_ == Flow::Stale; }
    /// Of thickness, relative: the one that the last sweep found in which the tile counted.
    float error() const { return error_; }

    /// It is assembled, with the changes that answer the pressure of the last step.
    void begin_step();
    /// Its coefficients have changed, and the changes answer the pressure with the new ones.
    void change_equations();

    /// The drag is taken from the pressure found.
    void steady_drag();
    /// A flux was wrong, here or beside.
    void unsettle_drag() { drag_ = Drag::Unsteady; }

    /// The velocities are those of the pressure found.
    void note_flow();

    /// The changes answer the pressure that the last sweep moved.
    void answer_pressure();
    /// `counts` where equations have changed in its patch.
    void enter_sweep(bool counts);
    /// The largest error of a residual that is new.
    void note_error(float error);
    /// Whether the patch of a tile that counts is to be solved: always, or where its error is above the
    /// tolerance or no number. One whose error the last correction hardly lowered becomes slow.
    bool choose_correction(bool always, float tolerance);
    /// After the sweep: whether a correction `moved` a pressure that its changes depend on, and whether
    /// one that reaches it is `rough`.
    void blend(bool moved, bool rough);
    /// Beside a tile whose pressure moved.
    void join_moved();

  private:
    Change change_ = Change::Known;
    Part part_ = Part::Rests;
    Equations equations_ = Equations::Same;
    Drag drag_ = Drag::Steady;
    Cycles cycles_ = Cycles::One;
    Flow flow_ = Flow::Stale;
    float error_ = 0.0F;
    float corrected_error_ = 0.0F;  ///< the one that the last correction was for, else the largest float
};

}  // namespace pastoso::film
