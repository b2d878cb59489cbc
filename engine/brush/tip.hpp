// The tip of a brush: where its bristles are and how they differ from each other. It follows from a
// preset, a seed and how the hairs were gathered, and never changes during a stroke. A knife or a comb
// is a row of stiff elements along its edge, a pad a disc or oval of soft ones without hairs.
#pragma once

#include "brush/preset.hpp"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace pastoso::brush {

struct Bristle {
    float root_x_mm = 0.0F;     ///< in the ferrule's frame, along the width
    float root_y_mm = 0.0F;     ///< along the thickness
    float per_distance = 0.0F;  ///< 1 / distance of the root from the middle, 1/mm
    float deficit_mm = 0.0F;    ///< how much shorter than the longest, >= 0
    float stiffness = 1.0F;     ///< 0.8 to 1.2
    float body = 1.0F;          ///< film it leaves against the preset's film, 0.03 to 1.4
    double full_dip = 1.0;      ///< what it takes up in a full dip, of the capacity
};

/// How paint drew the hairs of a piece together.
struct Gathering {
    std::uint32_t number = 0;  ///< of dips and wipes so far; 0: the hairs lie as they are made
    double worn_mm = 0.0;      ///< that the hand has travelled since the latest of them
    friend bool operator==(const Gathering&, const Gathering&) = default;
};

struct Tip {
    std::vector<Bristle> bristles;
    std::vector<float> hairs;  ///< hair_count() heights per bristle, -0.5 to 0.5
    /// Pairs of bristles close enough to pass paint on, first < second.
    std::vector<std::pair<int, int>> neighbours;
    std::uint32_t seed = 0;  ///< of everything random about this piece
    std::uint32_t dip_seed = 0;  ///< of its latest gathering; the piece's where none shows
    int hairs_per_bristle = 16;
    bool rigid = false;           ///< the edge of a knife or a comb
    bool mirrored = false;        ///< seen in a mirror: what leans left leans right
    double half_width_mm = 10.0;  ///< of the tip
    double area_mm2 = 0.3;        ///< of the tip, per bristle
    double capacity_mm3 = 2.0;    ///< a full bristle's load
    double radius_mm = 0.4;       ///< of a bristle's footprint; half the edge's thickness of a knife
    double lane_mm = 0.0;         ///< half width of a knife's elements or a comb's teeth, 0 for bristles

    /// A bristle's hairs reach from one side of its footprint to the other, both ends included.
    int hair_count() const { return hairs_per_bristle + 1; }
    const float* hairs_of(int bristle) const {
        return &hairs[static_cast<std::size_t>(bristle) * static_cast<std::size_t>(hair_count())];
    }
};

/// Tools that do not touch the canvas have a single element, the bottle.
///
/// Bristles fill the tip's outline evenly (R2 low-discrepancy sequence, M. Roberts 2018); about two
/// thirds of their differences run smoothly across the width, as clumps do, the rest is each bristle's
/// own.
///
/// Each dip gathers the hairs anew, as far as g = gather e^(-worn / 2 run) says, with the preset's
/// numbers of these names: noises are the tip's own with the share 1 - g of their variance, the dip's
/// with g; bristles move by up to 0.42 g mm into clumps with gaps between them, and what a clump takes
/// up differs by up to 0.3 g; all of them take up the same in each dip. The elements of a row stay where
/// they are: it is how paint lies on them that differs.
Tip make_tip(const Preset& preset, std::uint32_t seed, const Gathering& gathering = {});

}  // namespace pastoso::brush
