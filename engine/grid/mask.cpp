#include "grid/mask.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace pastoso::grid {
namespace {

using TileMask = std::array<std::uint8_t, kTileCells>;

/// Where an outline crosses the middle of a row of cells, downwards (1) or upwards (-1).
struct Crossing {
    double x;
    int turn;
};

/// The same whichever way an edge runs.
double crossing_x(const Point& upper, const Point& lower, double middle_y) {
    return upper.x + (middle_y - upper.y) / (lower.y - upper.y) * (lower.x - upper.x);
}

/// Sorted from left to right. An end on the middle itself counts as below it.
std::vector<Crossing> crossings(const std::vector<Point>& outline, double middle_y) {
    std::vector<Crossing> found;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point& a = outline[i];
        const Point& b = outline[(i + 1) % outline.size()];
        if ((a.y < middle_y) == (b.y < middle_y)) continue;
        found.push_back(
            {crossing_x(a.y < b.y ? a : b, a.y < b.y ? b : a, middle_y), a.y < b.y ? 1 : -1});
    }
    std::sort(found.begin(), found.end(),
              [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
    return found;
}

/// The first cell whose centre is not left of x.
int first_cell_from(double x, int width) {
    return static_cast<int>(std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(width)));
}

/// Chooses the cells of a row between crossings where the outline winds around them.
void fill_row(const std::vector<Crossing>& row, int width, std::vector<std::uint8_t>& chosen) {
    int winding = 0;
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
        winding += row[i].turn;
        if (winding == 0) continue;
        const int begin = first_cell_from(row[i].x, width), end = first_cell_from(row[i + 1].x, width);
        std::fill(chosen.begin() + begin, chosen.begin() + end, kWhole);
    }
}

bool is_all(const std::uint8_t* chosen, std::uint8_t value) {
    return chosen[0] == value && std::memcmp(chosen, chosen + 1, kTileCells - 1) == 0;
}

std::uint8_t combined(std::uint8_t before, std::uint8_t region, Combination how) {
    switch (how) {
        case Combination::Replace:
            return region;
        case Combination::Add:
            return std::max(before, region);
        case Combination::Subtract:
            return static_cast<std::uint8_t>(before - std::min(before, region));
        case Combination::Intersect:
            return std::min(before, region);
    }
    return region;
}

/// The cells of the canvas in tiles where some are chosen, one after the other, with their shares.
template <class Visit>
void for_shares(const Mask& mask, const Visit& visit) {
    for (int tile = 0; tile < mask.tile_count(); ++tile) {
        if (chooses_none(mask, tile)) continue;
        const Rect cells = mask.shape().tile_cells(tile);
        const std::uint8_t* shares = mask.read(tile);
        for (int y = cells.y0; y < cells.y1; ++y)
            for (int x = cells.x0; x < cells.x1; ++x)
                visit(x, y, shares[Shape::cell_in_tile(x, y)]);
    }
}

/// The mask with something else for every share.
template <class Change>
Mask with_shares(const Mask& mask, const Change& change) {
    MaskBuilder builder(mask.shape());
    for (int tile = 0; tile < mask.tile_count(); ++tile) {
        TileMask shares;
        std::transform(mask.read(tile), mask.read(tile) + kTileCells, shares.begin(), change);
        builder.set_tile(tile, shares.data());
    }
    return builder.take();
}

}  // namespace

void MaskBuilder::set_tile(int tile, const std::uint8_t* chosen) {
    if (is_all(chosen, 0))
        mask_.reset(tile);
    else
        mask_.replace(tile, is_all(chosen, kWhole) ? all_ : TileBlock<std::uint8_t>::copy_of(chosen));
}

Mask mask_by_rows(Shape shape,
                  const std::function<void(int y, std::vector<std::uint8_t>& chosen)>& choose_row) {
    MaskBuilder builder(shape);
    std::vector<std::vector<std::uint8_t>> rows(kTileSize);
    for (int tile_y = 0; tile_y < shape.tiles_y(); ++tile_y) {
        for (int y = 0; y < kTileSize; ++y) {
            rows[y].assign(static_cast<std::size_t>(shape.width), 0);
            if (tile_y * kTileSize + y < shape.height) choose_row(tile_y * kTileSize + y, rows[y]);
            rows[y].resize(static_cast<std::size_t>(shape.tiles_x()) * kTileSize);
        }
        for (int tile_x = 0; tile_x < shape.tiles_x(); ++tile_x) {
            TileMask chosen;
            for (int y = 0; y < kTileSize; ++y)
                std::copy_n(&rows[y][tile_x * kTileSize], kTileSize, &chosen[y * kTileSize]);
            builder.set_tile(tile_y * shape.tiles_x() + tile_x, chosen.data());
        }
    }
    return builder.take();
}

Mask polygon_mask(Shape shape, const std::vector<Point>& outline) {
    return mask_by_rows(shape, [&](int y, std::vector<std::uint8_t>& chosen) {
        fill_row(crossings(outline, y + 0.5), shape.width, chosen);
    });
}

Mask combined(const Mask& before, const Mask& region, Combination how) {
    PASTOSO_CHECK(before.shape() == region.shape());
    MaskBuilder builder(before.shape());
    for (int tile = 0; tile < before.tile_count(); ++tile) {
        TileMask chosen;
        for (int cell = 0; cell < kTileCells; ++cell)
            chosen[cell] = combined(before.read(tile)[cell], region.read(tile)[cell], how);
        builder.set_tile(tile, chosen.data());
    }
    return builder.take();
}

Mask inverted(const Mask& mask) {
    return with_shares(mask,
                       [](std::uint8_t share) { return static_cast<std::uint8_t>(kWhole - share); });
}

Mask hardened(const Mask& mask) {
    return with_shares(mask,
                       [](std::uint8_t share) { return is_chosen(share) ? kWhole : std::uint8_t{0}; });
}

std::int64_t chosen_cells(const Mask& mask) {
    std::int64_t count = 0;
    for_shares(mask, [&](int, int, std::uint8_t share) { count += is_chosen(share) ? 1 : 0; });
    return count;
}

Rect chosen_area(const Mask& mask) {
    Rect area;
    for_shares(mask, [&](int x, int y, std::uint8_t share) {
        if (share != 0) area = bounding_box(area, {x, y, x + 1, y + 1});
    });
    return area;
}

bool is_soft(const Mask& mask) {
    bool soft = false;
    for_shares(mask,
               [&](int, int, std::uint8_t share) { soft = soft || (share != 0 && share != kWhole); });
    return soft;
}

std::size_t bytes_in_part(const Mask& mask) {
    std::size_t count = 0;
    for (int tile = 0; tile < mask.tile_count(); ++tile)
        if (!chooses_none(mask, tile) && !chooses_all(mask, tile)) ++count;
    return count * kTileCells;
}

bool chooses_none(const Mask& mask, int tile) {
    return mask.is_background(tile);
}

bool chooses_all(const Mask& mask, int tile) {
    return is_all(mask.read(tile), kWhole);
}

}  // namespace pastoso::grid
