#include "screen/page_layout.hpp"

#include "core/check.hpp"

#include <algorithm>

namespace pastoso::screen {
namespace {

int rounded_up(int value, int by) {
    return (value + by - 1) / by;
}

}  // namespace

grid::Rect PageLayout::cells(int page) const {
    const int x = page % columns * width, y = page / columns * height;
    return {x - kLayerBorder, y - kLayerBorder, x + width + kLayerBorder, y + height + kLayerBorder};
}

std::vector<int> PageLayout::pages_of(const grid::Rect& part) const {
    std::vector<int> pages;
    for (int page = 0; page < count(); ++page)
        if (!grid::intersection(cells(page), part).empty()) pages.push_back(page);
    return pages;
}

PageLayout page_layout(const grid::Shape& canvas, int longest_side) {
    const int longest = longest_side - 2 * kLayerBorder;
    PASTOSO_CHECK_OP(longest, >, 0);
    const int columns = rounded_up(canvas.width, longest), rows = rounded_up(canvas.height, longest);
    return {columns, rows, rounded_up(canvas.width, columns), rounded_up(canvas.height, rows)};
}

}  // namespace pastoso::screen
