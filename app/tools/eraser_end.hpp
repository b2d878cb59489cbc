// The other end of a pen: it takes a tool that wipes paint away while it is used.
#pragma once

#include "tools/easel.hpp"

#include <string>

namespace pastoso::tools {

class EraserEnd {
  public:
    /// Takes the bundled tool of that name in place of the one in hand, as wide as it was in this hand
    /// before. Does nothing where it is taken already, and for an empty name. True: the hand has
    /// changed.
    bool turn_over(const std::string& tool, Easel& easel);

    /// Gives back what was in hand, with the paint that it held; a tool that the painter has taken since
    /// stays. True: the hand has changed.
    bool turn_back(Easel& easel);

    bool in_use() const { return in_use_; }

  private:
    bool in_use_ = false;
    std::string tool_;
    double width_mm_ = 0.0;  ///< of that tool when it was last given back
};

}  // namespace pastoso::tools
