// The numbers of the guides that lie on the canvas, as the panel shows them.
#pragma once

#include "tools/laid_guide.hpp"

#include <initializer_list>
#include <span>

namespace pastoso::panels {

enum class GuideUnit { Millimetres, Degrees };

/// One number of guides of some kinds.
struct GuideNumber {
    const char* name;   ///< of its box
    const char* words;  ///< context "pastoso::panels"
    GuideUnit unit;
    double least, most;
    std::initializer_list<tools::GuideKind> kinds;
    double (*get)(const brush::PenGuide& guide);  ///< of a guide of one of the kinds
    void (*set)(brush::PenGuide& guide, double value);
};

/// All of them, in the order of the panel.
std::span<const GuideNumber> guide_numbers();

}  // namespace pastoso::panels
