// One movement of the hand and the strokes of all its copies.
#pragma once

#include "brush/guide_choice.hpp"
#include "brush/stroke.hpp"
#include "brush/symmetry.hpp"

#include <deque>
#include <vector>

namespace pastoso::brush {

/// Paints with the brush in hand and, under a symmetry, with a brush of the same kind for every other
/// copy. These hold at first what the brush in hand holds, that much more paint, and live as long as the
/// group. Sample by sample the copies paint in turn, in the order of placements(), as soon as
/// GuideChoice knows where. When the pen lifts the hairs of the brush are worn by the way. Otherwise
/// like Stroke.
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
    void follow(const std::vector<PenSample>& samples);
    void begin_strokes(const PenSample& sample);
    void add_to_strokes(const PenSample& sample);

    PenGuide guide_;
    GuideChoice choice_;
    bool begun_ = false;  ///< the strokes are, the pen may be down before
    PenSample last_;
    double travel_mm_ = 0.0;
    Brush& brush_;
    std::deque<Brush> copies_;
    std::deque<Stroke> strokes_;  ///< the first with the brush in hand
};

}  // namespace pastoso::brush
