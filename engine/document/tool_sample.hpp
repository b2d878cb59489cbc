// The mark that shows a tool best, painted by the engine itself on a board of its own.
#pragma once

#include "brush/preset.hpp"
#include "document/sample_board.hpp"

#include <functional>

namespace pastoso::document {

/// What a tool is shown with.
enum class ToolMark {
    Wave,
    OverWet,  ///< the same over two bands of wet paint
    OverDry,  ///< the same over the weave of canvas that dry paint covers
    OnWeave,  ///< the same on bare canvas
    Dabs,
    Lines,
    Drops,
    Stream,  ///< of drops, along the wave
    Blow     ///< of air, into wet paint
};

/// The mark that shows the tool best: knives and tools that are not dipped go over wet paint, a brush
/// that leaves a thin film over dry paint, a stick goes over the bare weave, one whose load lasts a
/// short way dabs, a fine one draws lines.
ToolMark mark_of(const brush::Preset& preset);

/// How wide the tool's mark is, about: its tip, what a line swings over, or what drops spread to.
double mark_width_mm(const brush::Preset& preset);

/// How wide a board of that form is for a mark to fill two thirds of its height and a quarter of its
/// width at most; a narrow one, less.
double sample_width_mm(double mark_mm, int width_px, int height_px);

/// That mark of the tool on a board of that size, in blue, pressed hardest in its middle; a tool too
/// wide for the pixels is painted as a narrower one on a smaller board. Always the same for the same
/// preset. Empty once `cancelled` says true. Throws core::InputError for a preset that is out of its
/// ranges.
pigment::Image8 tool_sample(const brush::Preset& preset, ToolMark mark, const SampleBoard::Size& size,
                            core::ThreadPool& pool, const std::function<bool()>& cancelled = {});

}  // namespace pastoso::document
