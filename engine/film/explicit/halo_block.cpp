#include "film/explicit/halo_block.hpp"

#include "core/check.hpp"

#include <algorithm>
#include <utility>

namespace pastoso::film {
namespace {

using grid::kTileSize;

HaloSource source_of(int position) {
    return {.tile = position / kTileSize, .cell = position % kTileSize};
}

int wrapped(int position, int count) {
    return ((position % count) + count) % count;
}

/// Cell -1 mirrors cell 0, cell n mirrors cell n - 1.
int mirrored_cell(int cell, int count) {
    const int reflected = cell < 0 ? -1 - cell : 2 * count - 1 - cell;
    return std::clamp(reflected, 0, count - 1);
}

HaloSource cell_source(int cell, int count, Edge edge) {
    if (cell >= 0 && cell < count) return source_of(cell);
    if (edge == Edge::Periodic) return source_of(wrapped(cell, count));
    HaloSource source = source_of(mirrored_cell(cell, count));
    source.outside = edge == Edge::Open;
    return source;
}

/// Face -1 is the edge on the low side, face n - 1 the one on the high side; the edges themselves are
/// closed or hold no momentum of their own, so they count as outside.
HaloSource face_source(int face, int count, Edge edge) {
    if (edge == Edge::Periodic) return source_of(wrapped(face, count));
    if (face >= 0 && face < count - 1) return source_of(face);
    HaloSource source = source_of(std::clamp(face < 0 ? -2 - face : 2 * count - 2 - face, 0, count - 1));
    source.outside = edge == Edge::Open || face == -1 || face == count - 1;
    source.mirrored = true;
    return source;
}

/// A column beside the tile's cells: its place in a row of a block, and where it comes from.
struct MarginColumn {
    int place = 0;
    HaloSource source;
};

void copy_cells(const TileHeights& tile, int first, int count, float* out) {
    tile.copy(first, count, out);
}
template <class T>
void copy_cells(const T* tile, int first, int count, T* out) {
    std::copy_n(tile + first, count, out);
}

/// Rows of a field as a block has them, seen through the tiles of one row of tiles.
template <class Field>
class FieldRows {
  public:
    FieldRows(const Field& field, const std::array<HaloSource, kBlockRows>& columns, int extent,
              int tile_x)
        : field_(field), extent_(extent), tile_x_(tile_x) {
        for (int k = 0; k < 2 * kHalo; ++k) {
            const int place = k < kHalo ? k : extent + k;
            margin_[k] = {place, columns[place]};
        }
    }

    /// Writes the row: of the margin margin_value(value, source of the column).
    template <class T, class MarginValue>
    void copy(const HaloSource& row, T* out, const MarginValue& margin_value) {
        if (row.tile != tile_row_) look_at(row.tile);
        const int first_cell = row.cell * kTileSize;
        copy_cells(own_, first_cell, extent_, out + kHalo);
        for (int k = 0; k < 2 * kHalo; ++k) {
            const MarginColumn& column = margin_[k];
            out[column.place] = margin_value(beside_[k][first_cell + column.source.cell], column.source);
        }
    }

  private:
    using Tile = decltype(std::declval<const Field&>().read(0));

    void look_at(int tile_row) {
        const int first_tile = tile_row * field_.shape().tiles_x();
        own_ = field_.read(first_tile + tile_x_);
        for (int k = 0; k < 2 * kHalo; ++k)
            beside_[k] = field_.read(first_tile + margin_[k].source.tile);
        tile_row_ = tile_row;
    }

    const Field& field_;
    int extent_, tile_x_;
    std::array<MarginColumn, 2 * kHalo> margin_;
    int tile_row_ = -1;
    Tile own_{};
    std::array<Tile, 2 * kHalo> beside_{};
};

using QuantaRows = FieldRows<grid::TiledField<std::int32_t>>;
using HeightRows = FieldRows<SupportHeights>;
using VelocityRows = FieldRows<grid::TiledField<float>>;

void gather_velocity_x(VelocityRows& rows, const HaloSource& row, int extent, float* out) {
    if (row.outside) {
        std::fill_n(out, extent + 2 * kHalo, 0.0F);
        return;
    }
    rows.copy(row, out, [](float velocity, const HaloSource& column) {
        if (column.outside) return 0.0F;
        return column.mirrored ? -velocity : velocity;
    });
}

void gather_velocity_y(VelocityRows& rows, const HaloSource& row, int extent, float* out) {
    const int width = extent + 2 * kHalo;
    if (row.outside) {
        std::fill_n(out, width, 0.0F);
        return;
    }
    rows.copy(row, out,
              [](float velocity, const HaloSource& column) { return column.outside ? 0.0F : velocity; });
    if (!row.mirrored) return;
    for (int x = 0; x < width; ++x)
        out[x] = -out[x];
}

void gather_quanta_row(QuantaRows& rows, const HaloSource& row, int extent, std::int32_t* out) {
    if (row.outside) {
        std::fill_n(out, extent + 2 * kHalo, 0);
        return;
    }
    rows.copy(row, out,
              [](std::int32_t quanta, const HaloSource& column) { return column.outside ? 0 : quanta; });
}

void derive_surface(HaloBlock& block, int row_start, int width) {
    for (int i = row_start; i < row_start + width; ++i) {
        block.thickness[i] = thickness_mm(block.quanta[i]);
        block.eta[i] = block.thickness[i] + block.support[i];
    }
}

void clear_beyond(HaloBlock& block, int row_start, int width) {
    for (int i = row_start + width; i < row_start + kBlockRows; ++i) {
        block.quanta[i] = 0;
        block.thickness[i] = block.support[i] = block.eta[i] = 0.0F;
        block.velocity_x[i] = block.velocity_y[i] = 0.0F;
    }
}

void clear_row(HaloBlock& block, int row_start) {
    clear_beyond(block, row_start, 0);
}

void note_wet_row(HaloBlock& block, int y, int row_start, int width, float wet_mm) {
    const float* row = block.thickness.data() + row_start;
    if (!std::any_of(row, row + width, [&](float h) { return h > wet_mm; })) return;
    if (block.last_wet_row < block.first_wet_row) block.first_wet_row = y;
    block.last_wet_row = y;
}

}  // namespace

HaloMap make_halo_map(int tile_index, int canvas_cells, Edge edge) {
    PASTOSO_CHECK_OP(canvas_cells, >, 0);
    HaloMap map;
    const int first = tile_index * kTileSize;
    map.extent = std::min(kTileSize, canvas_cells - first);
    for (int k = 0; k < kBlockRows; ++k) {
        map.cells[k] = cell_source(first + k - kHalo, canvas_cells, edge);
        map.faces[k] = face_source(first + k - kHalo, canvas_cells, edge);
    }
    return map;
}

void gather(const FilmState& state, const HaloMap& columns, const HaloMap& rows, int tile_x,
            float wet_mm, HaloBlock& block) {
    block.first_wet_row = 0;
    block.last_wet_row = -1;
    const int extent = columns.extent, width = extent + 2 * kHalo;
    const bool at_edge = columns.faces[extent - 1 + kHalo].outside;
    QuantaRows quanta(state.thickness, columns.cells, extent, tile_x);
    HeightRows support(state.support_mm, columns.cells, extent, tile_x);
    VelocityRows velocity_x(state.velocity_x, columns.faces, extent, tile_x);
    VelocityRows velocity_y(state.velocity_y, columns.cells, extent, tile_x);
    for (int y = -kHalo; y < kTileSize + kHalo; ++y) {
        const int start = block_index(-kHalo, y);
        if (y >= rows.extent + kHalo) {
            clear_row(block, start);
            continue;
        }
        const HaloSource& row = rows.cells[y + kHalo];
        gather_quanta_row(quanta, row, extent, &block.quanta[start]);
        support.copy(row, &block.support[start], [](float height, const HaloSource&) { return height; });
        gather_velocity_x(velocity_x, row, extent, &block.velocity_x[start]);
        if (at_edge) block.velocity_x[block_index(extent - 1, y)] = 0.0F;
        gather_velocity_y(velocity_y, rows.faces[y + kHalo], extent, &block.velocity_y[start]);
        derive_surface(block, start, width);
        clear_beyond(block, start, width);
        note_wet_row(block, y, start, width, wet_mm);
    }
}

void gather_quanta(const grid::TiledField<std::int32_t>& thickness, const HaloMap& columns,
                   const HaloMap& rows, int tile_x, BlockArray<std::int32_t>& quanta) {
    QuantaRows from(thickness, columns.cells, columns.extent, tile_x);
    for (int y = -kHalo; y < kTileSize + kHalo; ++y) {
        std::int32_t* out = &quanta[block_index(-kHalo, y)];
        const bool reached = y < rows.extent + kHalo;
        if (reached) gather_quanta_row(from, rows.cells[y + kHalo], columns.extent, out);
        const int filled = reached ? columns.extent + 2 * kHalo : 0;
        std::fill(out + filled, out + kBlockStride, 0);
    }
}

}  // namespace pastoso::film
