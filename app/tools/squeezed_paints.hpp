// The paints on the mixing well, to be squeezed out again beside the next painting.
#pragma once

#include "document/events.hpp"

#include <cstddef>
#include <vector>

namespace pastoso::tools {

class SqueezedPaints {
  public:
    static constexpr std::size_t kMost = 64;

    /// One was squeezed out. The first kMost count, each once.
    void note(const document::PaintRecipe& paint);

    /// The well is bare.
    void wipe() { here_.clear(); }

    /// Another painting, with another well.
    void begin();

    /// Of the painting before, or of an earlier one where none was squeezed out beside that.
    const std::vector<document::PaintRecipe>& last() const { return last_; }
    void set_last(std::vector<document::PaintRecipe> paints);

    /// What last() will be beside the next painting.
    const std::vector<document::PaintRecipe>& latest() const { return here_.empty() ? last_ : here_; }

  private:
    std::vector<document::PaintRecipe> here_, last_;
};

}  // namespace pastoso::tools
