// What the dry paint of a layer looks like, and would look like after it is adjusted.
#pragma once

#include "document/painting.hpp"
#include "layers/adjusting.hpp"
#include "layers/dry_cells.hpp"
#include "shade/spot.hpp"

namespace pastoso::tools {

struct AdjustedColours {
    pigment::Srgb8 before{}, after{};
    friend bool operator==(const AdjustedColours&, const AdjustedColours&) = default;
};

/// The dry paint of a painting's active layer, where it is selected and not masked.
class DryColours {
  public:
    explicit DryColours(const document::Snapshot& painting);

    bool any() const { return sample_.count > 0; }

    /// The mean colours of its cells (layers::dry_sample()) on the spot's ground and in its light, as if
    /// nothing wet lay on them: as they are, and adjusted with that paint. There are some. Without
    /// layers::can_lie_dry(), both are the same.
    AdjustedColours adjusted(const film::PaintCoefficients& paint, const layers::Adjustment& adjustment,
                             const shade::Spot& spot) const;

  private:
    layers::DrySample sample_;
};

}  // namespace pastoso::tools
