// One movement of the hand and the strokes of all its copies.
#pragma once

#include "brush/stroke.hpp"
#include "brush/symmetry.hpp"

#include <deque>
#include <vector>

namespace pastoso::brush {

/// Paints with the brush in hand and, under a symmetry, with a brush of the same kind for every other
/// copy. These hold at first what the brush in hand holds, that much more paint, and live as long as the
/// group. Sample by sample the copies paint in turn, in the order of placements(). A straight line is
/// painted when the pen lifts; then the hairs of the brush are worn by the way. Otherwise like Stroke.
class StrokeGroup {
  public:
    StrokeGroup(Brush& brush, film::FilmState& film, const HandAids& aids, const Symmetry& symmetry,
                const grid::Mask* limit = nullptr, core::ThreadPool* pool = nullptr);

    void begin(const PenSample& sample);
    void add(const PenSample& sample);
    void end();

    void pass_time(double seconds);

    /// What tools of air blow on the film at this moment.
    std::vector<film::AirJet> air_jets() const;

    /// Hands over what absorbing tools have thrown away since the last call.
    Contents take_thrown_away();

    /// What the brushes hold besides the one in hand.
    Contents copied_paint() const;

    /// A rectangle for every copy around all cells changed since the last call.
    std::vector<grid::Rect> take_changed_cells();

  private:
    bool waits_for_line() const { return std::holds_alternative<StraightLine>(aids_.guide.form); }
    void begin_strokes(const PenSample& sample);
    void add_to_strokes(const PenSample& sample);

    HandAids aids_;
    std::vector<PenSample> line_;  ///< of a straight line that is not painted yet
    PenSample last_;
    double travel_mm_ = 0.0;
    Brush& brush_;
    std::deque<Brush> copies_;
    std::deque<Stroke> strokes_;  ///< the first with the brush in hand
};

}  // namespace pastoso::brush
