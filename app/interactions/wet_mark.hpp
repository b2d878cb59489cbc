// The wet mark: the brush's tip along the part of a stroke that the screen does not show yet, in the
// colour of its paint, so that paint is under the pen at once.
#pragma once

#include "document/events.hpp"
#include "interactions/brush_outline.hpp"
#include "interactions/stroke_ahead.hpp"
#include "tools/hand.hpp"
#include "tools/swatch.hpp"
#include "view/interaction.hpp"

#include <cstdint>
#include <optional>

namespace pastoso::document {
struct Snapshot;
}

namespace pastoso::interactions {

/// What a brush would lay; none where that is nothing.
struct PaintInHand {
    std::optional<tools::WetColour> held{};    ///< at present
    std::optional<tools::WetColour> dipped{};  ///< where it is dipped at every touch: then
    friend bool operator==(const PaintInHand&, const PaintInHand&) = default;
};

/// On the canvas alone.
class WetMark {
  public:
    void set_paint(const PaintInHand& paint) { paint_ = paint; }

    /// What has been posted for `hand`, and under which number.
    void note(const document::Action& action, std::uint64_t number, const tools::Hand& hand,
              const BrushOutline& outline);

    /// Another painting comes, with other numbers.
    void clear() { ahead_ = {}; }

    /// False: it stays as it is.
    bool rest() { return ahead_.rest(); }

    /// Over a frame that shows this. False: nothing is ahead of it, or it is not marked.
    bool draw(const document::Snapshot& shown, const view::Overlay& overlay,
              const BrushOutline& outline);

  private:
    void begin(const document::PenDown& down, std::uint64_t number, const tools::Hand& hand,
               const BrushOutline& outline);

    PaintInHand paint_;
    StrokeAhead ahead_;
    std::vector<brush::Placement> copies_;
};

}  // namespace pastoso::interactions
