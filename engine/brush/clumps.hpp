// The clumps that bristles stand in on the canvas. Between two clumps no footprint reaches, so that
// their outermost bristles have nobody to cover what cells make of their footprints beyond their own
// edge; within, neighbours do.
#pragma once

#include "brush/bristle_motion.hpp"

#include <vector>

namespace pastoso::brush {

class Clumps {
  public:
    /// Finds those of the bristles that are down, with footprints of `radius_mm`.
    void find(const std::vector<BristlePose>& poses, const HandPose& hand, double radius_mm);

    /// From the middle of a bristle to that of the outermost one of its clump, on the nearer side of
    /// the travel. 0 for one that stands alone.
    double to_edge_mm(int bristle) const { return to_edge_mm_[static_cast<std::size_t>(bristle)]; }

  private:
    struct Place {
        double side_mm;
        int bristle;
    };
    void sort_by_side(const std::vector<BristlePose>& poses, const HandPose& hand);

    std::vector<Place> places_;  ///< from one side to the other, kept: they change little in a step
    std::vector<double> to_edge_mm_;
};

}  // namespace pastoso::brush
