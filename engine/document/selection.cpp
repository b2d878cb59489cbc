#include "document/selection.hpp"

#include "grid/feathering.hpp"
#include "grid/mask_margins.hpp"
#include "grid/turning.hpp"
#include "layers/clipping.hpp"

#include <array>
#include <limits>
#include <utility>

namespace pastoso::document {
namespace {

Selection selection_of(grid::Mask mask) {
    if (grid::chosen_area(mask).empty()) return nullptr;
    return std::make_shared<const grid::Mask>(std::move(mask));
}

/// The cells whose `value_mm(tile, cell)` lies in a range.
template <class Value>
grid::Mask cells_within(grid::Shape shape, double least_mm, double most_mm, const Value& value_mm) {
    grid::MaskBuilder builder(shape);
    for (int tile = 0; tile < shape.tile_count(); ++tile) {
        std::array<std::uint8_t, grid::kTileCells> chosen;
        for (int cell = 0; cell < grid::kTileCells; ++cell) {
            const double value = value_mm(tile, cell);
            chosen[cell] = value >= least_mm && value <= most_mm ? grid::kWhole : 0;
        }
        builder.set_tile(tile, chosen.data());
    }
    return builder.take();
}

/// The cells whose paint, wet and dry, stands so high above what is given.
grid::Mask cells_of_height(const film::FilmState& film, const film::SupportHeights& above_mm,
                           double least_mm, double most_mm) {
    return cells_within(film.shape, least_mm, most_mm, [&](int tile, int cell) {
        return film.support_mm.read(tile)[cell] - above_mm.read(tile)[cell] +
               film::thickness_mm(film.thickness.read(tile)[cell]);
    });
}

}  // namespace

grid::Mask area_of(const SelectArea& select, const film::FilmState& film) {
    std::vector<grid::Point> outline;
    for (const CanvasPoint& point : select.outline)
        outline.push_back({point.x_mm / film.cell_mm, point.y_mm / film.cell_mm});
    return grid::polygon_mask(film.shape, outline);
}

grid::Mask area_of(const SelectByHeight& select, const film::FilmState& film,
                   const film::SupportHeights& bare_mm) {
    return cells_of_height(film, bare_mm, select.least_mm, select.most_mm);
}

grid::Mask area_of(const SelectPaint&, const film::FilmState& film,
                   const film::SupportHeights& base_mm) {
    return cells_of_height(film, base_mm, layers::kLeastPaint_mm,
                           std::numeric_limits<double>::infinity());
}

grid::Mask area_of(const SelectByWetness& select, const film::FilmState& film) {
    return cells_within(film.shape, select.least_mm, select.most_mm, [&](int tile, int cell) {
        return film::thickness_mm(film.thickness.read(tile)[cell]);
    });
}

Selection combined(const Selection& before, const grid::Mask& region, Combination how) {
    if (before) return selection_of(grid::combined(*before, region, how));
    return selection_of(how == Combination::Subtract ? grid::inverted(region) : region);
}

Selection inverted(const Selection& before) {
    return before ? selection_of(grid::inverted(*before)) : nullptr;
}

Selection changed_by(const GrowSelection& grow, const Selection& before, double cell_mm) {
    return before ? selection_of(grid::grown(*before, grow.width_mm / cell_mm)) : nullptr;
}

Selection changed_by(const ShrinkSelection& shrink, const Selection& before, double cell_mm) {
    return before ? selection_of(grid::shrunk(*before, shrink.width_mm / cell_mm)) : nullptr;
}

Selection changed_by(const BorderSelection& border, const Selection& before, double cell_mm) {
    return before ? selection_of(grid::along_outline(*before, 0.5 * border.width_mm / cell_mm))
                  : nullptr;
}

Selection changed_by(const FeatherSelection& feather, const Selection& before, double cell_mm) {
    return before ? selection_of(grid::feathered(*before, feather.radius_mm / cell_mm)) : nullptr;
}

Selection on_extent(const Selection& before, const grid::Extent& extent) {
    if (!before) return nullptr;
    grid::Mask mask(extent.shape);
    grid::put_on_extent(*before, extent, mask);
    return selection_of(std::move(mask));
}

Selection turned(const Selection& before, const core::Orientation& turn, core::ThreadPool& pool) {
    if (!before) return nullptr;
    grid::Mask mask(grid::turned(before->shape(), turn));
    grid::put_turned(*before, turn, mask, pool);
    return selection_of(std::move(mask));
}

Selection resampled(const Selection& before, const layers::Resampling& resampling) {
    return before ? selection_of(layers::resampled(*before, resampling)) : nullptr;
}

Selection transformed(const Selection& before, const layers::Projective& map_cells) {
    return before ? selection_of(layers::transformed(*before, map_cells)) : nullptr;
}

}  // namespace pastoso::document
