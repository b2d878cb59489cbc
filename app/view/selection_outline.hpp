// The outline of a selection, as lines to be drawn.
#pragma once

#include "document/selection.hpp"

#include <cstddef>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

namespace pastoso::view {

/// A part of a canvas, and how finely it is looked at.
struct MaskWindow {
    grid::Rect cells;  ///< on the canvas; what lies beside it is left out
    int block = 1;     ///< cells along a side, 1, 2, 4 ... 64: all of a block count as chosen if one is
};

/// The borders between cells that are chosen by half or more and others, those beside the canvas being
/// others. Every two points
/// are a line, in millimetres: level or upright, each as long as it goes on. Nothing where these are
/// more than `most_lines`.
std::optional<std::vector<glm::vec2>> mask_borders_mm(const grid::Mask& mask, double cell_mm,
                                                      const MaskWindow& window, std::size_t most_lines);

/// Keeps the outline of a selection for as long as it can be shown as it is. One of too many lines, of
/// speckles that is, is made of what is seen alone, and as coarsely as it takes.
class SelectionOutline {
  public:
    /// More are not told apart, and take longer to draw than a frame may.
    static constexpr std::size_t kMostLines = 12000;

    /// Of a selection that is none: no lines. `seen` are the cells in the window.
    const std::vector<glm::vec2>& lines_mm(const document::Selection& selection, double cell_mm,
                                           const grid::Rect& seen);

  private:
    void make_whole();
    void make_seen(const grid::Rect& cells);

    document::Selection selection_;
    double cell_mm_ = 0.0;
    bool whole_ = true;  ///< the lines are those of the whole canvas, exactly
    grid::Rect made_for_;
    std::vector<glm::vec2> lines_mm_;
};

}  // namespace pastoso::view
