// Where in a canvas its outlines are: what is far from them is drawn without them.
#pragma once

#include "screen/canvas_outlines.hpp"

#include <vector>

#include <QRect>

namespace pastoso::screen {

/// Knows it square by square, as far as it has been told.
class OutlineSquares {
  public:
    /// Nothing is known of a canvas.
    void reset(const grid::Shape& shape);

    /// The paint of these tiles is another.
    void forget(const std::vector<int>& tiles);

    void note(const OutlinePatch& patch);

    /// Where in a rectangle samples may be near an outline: runs of squares of several cells, which
    /// reach half a cell farther than is said.
    std::vector<QRect> cells_near(const grid::Rect& cells) const;

  private:
    char& square(int x, int y);  ///< that of the samples that begin at this cell
    void clear(const grid::Rect& cells);
    int squares_x() const;

    grid::Shape shape_;
    std::vector<char> near_;
};

}  // namespace pastoso::screen
