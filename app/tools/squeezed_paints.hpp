// The paints on the mixing well, to be squeezed out again beside the next painting.
#pragma once

#include "document/events.hpp"
#include "document/puddles.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace pastoso::tools {

/// What lay on a well.
struct WellPalette {
    std::vector<document::PaintRecipe> squeezed;  ///< as it came out, each once
    std::vector<document::Puddle> puddles;        ///< what was mixed of it
    bool empty() const { return squeezed.empty() && puddles.empty(); }
    friend bool operator==(const WellPalette&, const WellPalette&) = default;
};

class SqueezedPaints {
  public:
    static constexpr std::size_t kMost = 64;

    /// One was squeezed out. The first kMost count, each once.
    void note(const document::PaintRecipe& paint);

    /// The well is bare.
    void wipe() { here_.clear(); }

    /// Another painting, with another well; these mixtures lie on the one that goes.
    void begin(const std::vector<document::Puddle>& puddles);

    /// Of the painting before, or of an earlier one where nothing was squeezed out or mixed beside that.
    const WellPalette& last() const { return last_; }
    void set_last(WellPalette palette) { last_ = std::move(palette); }

    /// What last() will be beside the next painting: with these mixtures, which lie on the well now, but
    /// without those that were squeezed out as they are.
    WellPalette latest(const std::vector<document::Puddle>& puddles) const;

  private:
    std::vector<document::PaintRecipe> here_;
    WellPalette last_;
};

}  // namespace pastoso::tools
