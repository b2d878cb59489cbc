#include "film/state.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace pastoso::film {
namespace {

/// Calls visit(values, count) for every run of cells of a tile that lie side by side on the canvas.
template <class T, class Visit>
void for_each_tile_row(const grid::TiledField<T>& field, int tile, const Visit& visit) {
    const grid::Rect cells = field.shape().tile_cells(tile);
    const T* values = field.read(tile);
    for (int row = 0; row < cells.height(); ++row) {
        visit(values + static_cast<std::size_t>(row) * grid::kTileSize, cells.width());
    }
}

void add_thickness(const FilmState& state, int tile, Totals& sums) {
    if (state.thickness.is_background(tile)) return;
    for_each_tile_row(state.thickness, tile, [&](const std::int32_t* h, int count) {
        for (int x = 0; x < count; ++x)
            sums.thickness += h[x];
    });
}

void add_pigment(const FilmState& state, int tile, Totals& sums) {
    if (state.paint.is_background(tile)) return;
    for_each_tile_row(state.paint, tile, [&](const PaintCell* cells, int count) {
        for (int x = 0; x < count; ++x) {
            for (int channel = 0; channel < kPaintChannels; ++channel) {
                sums.paint[channel] += cells[x][channel];
            }
        }
    });
}

template <class T>
void add_tile(const grid::TiledField<T>& field, int tile, core::Hash64& hash) {
    for_each_tile_row(field, tile, [&](const T* values, int count) {
        hash.add(std::span<const T>(values, static_cast<std::size_t>(count)));
    });
}

template <class T>
void add_field(const grid::TiledField<T>& field, core::Hash64& hash) {
    for (int tile = 0; tile < field.tile_count(); ++tile)
        add_tile(field, tile, hash);
}

/// Tiles without one add nothing.
void add_lower(const LowerStratum& lower, core::Hash64& hash) {
    for (int tile = 0; tile < lower.thickness.tile_count(); ++tile) {
        if (!lower.holds_any(tile)) continue;
        hash.add_value(tile);
        add_tile(lower.thickness, tile, hash);
        add_tile(lower.paint, tile, hash);
    }
}

void add_worked(const WorkedPaint& worked, core::Hash64& hash) {
    for (int tile = 0; tile < worked.thickness.tile_count(); ++tile) {
        if (!worked.holds_any(tile)) continue;
        hash.add_value(tile);
        add_tile(worked.thickness, tile, hash);
    }
}

/// How much of each there is in a cell, however the tile tells it. Paint of one medium adds nothing.
void add_media(const FilmState& state, core::Hash64& hash) {
    const WetMedia& media = state.media;
    if (!media.are_several()) return;
    hash.add(std::span<const FilmNumbers>(media.numbers));
    for (int tile = 0; tile < state.shape.tile_count(); ++tile) {
        if (state.thickness.is_background(tile)) continue;
        const grid::Rect cells = state.shape.tile_cells(tile);
        for (int y = cells.y0; y < cells.y1; ++y)
            for (int x = cells.x0; x < cells.x1; ++x)
                if (state.thickness.at(x, y) > 0)
                    hash.add_value(media_in(state, tile, grid::Shape::cell_in_tile(x, y)));
    }
}

void add_heights(const SupportHeights& field, core::Hash64& hash) {
    std::array<float, grid::kTileSize> row;
    for (int tile = 0; tile < field.tile_count(); ++tile) {
        const grid::Rect cells = field.shape().tile_cells(tile);
        for (int y = 0; y < cells.height(); ++y) {
            field.read(tile).copy(y * grid::kTileSize, cells.width(), row.data());
            hash.add(std::span<const float>(row.data(), static_cast<std::size_t>(cells.width())));
        }
    }
}

}  // namespace

Totals totals(const FilmState& state) {
    Totals sums;
    for (int tile = 0; tile < state.shape.tile_count(); ++tile) {
        add_thickness(state, tile, sums);
        add_pigment(state, tile, sums);
    }
    return sums;
}

bool has_wet_paint(const FilmState& state) {
    for (int tile = 0; tile < state.shape.tile_count(); ++tile)
        if (!state.thickness.is_background(tile)) return true;
    return false;
}

Consistencies wet_consistencies(const FilmState& state) {
    const bool none_left = state.consistencies.uniform() && !has_wet_paint(state);
    return none_left ? Consistencies{} : state.consistencies;
}

double volume_mm3(std::int64_t thickness_quanta, double cell_mm) {
    return static_cast<double>(thickness_quanta) * kThicknessQuantum_mm * cell_mm * cell_mm;
}

std::int64_t wet_cell_count(const FilmState& state) {
    const double negligible_quanta = 1e-4 * state.cell_mm / kThicknessQuantum_mm;
    const auto negligible = static_cast<std::int32_t>(std::floor(negligible_quanta));
    std::int64_t wet = 0;
    for (int tile = 0; tile < state.shape.tile_count(); ++tile) {
        if (state.thickness.is_background(tile)) continue;
        for_each_tile_row(state.thickness, tile, [&](const std::int32_t* h, int count) {
            wet += std::count_if(h, h + count,
                                 [negligible](std::int32_t quanta) { return quanta > negligible; });
        });
    }
    return wet;
}

std::uint64_t state_hash(const FilmState& state) {
    core::Hash64 hash;
    hash.add_value(state.shape.width);
    hash.add_value(state.shape.height);
    hash.add_value(state.cell_mm);
    add_field(state.thickness, hash);
    add_field(state.paint, hash);
    add_lower(state.lower, hash);
    add_worked(state.worked, hash);
    add_media(state, hash);
    add_field(state.velocity_x, hash);
    add_field(state.velocity_y, hash);
    add_heights(state.support_mm, hash);
    add_field(state.strata.soluble_thickness, hash);
    add_field(state.strata.soluble_pigment, hash);
    add_field(state.strata.optics, hash);
    add_field(state.strata.uppermost, hash);
    hash.add_value(state.strata.fixed);
    hash.add_value(state.strata.evaporated);
    hash.add_value(state.consistencies.are_several());  // which one it is, the cells tell
    return hash.value();
}

}  // namespace pastoso::film
