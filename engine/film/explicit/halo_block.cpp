#include "film/explicit/halo_block.hpp"

#include "core/check.hpp"

#include <algorithm>

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

/// One row of a field, seen through the tiles of that row.
template <class T>
class FieldRow {
  public:
    FieldRow(const grid::TiledField<T>& field, const HaloSource& row)
        : field_(field),
          first_tile_(row.tile * field.shape().tiles_x()),
          offset_(row.cell * kTileSize) {}
    const T* tile(int tile_x) const { return field_.read(first_tile_ + tile_x) + offset_; }
    T at(const HaloSource& column) const { return tile(column.tile)[column.cell]; }

  private:
    const grid::TiledField<T>& field_;
    int first_tile_;
    int offset_;
};

/// Calls visit(x) for the margin columns on both sides of the tile's cells.
template <class Visit>
void for_each_margin_column(int extent, const Visit& visit) {
    for (int x = -kHalo; x < 0; ++x)
        visit(x);
    for (int x = extent; x < extent + kHalo; ++x)
        visit(x);
}

template <class T>
void gather_cells(const grid::TiledField<T>& field, const HaloMap& columns, const HaloSource& row,
                  int tile_x, T* out) {
    const FieldRow<T> source(field, row);
    std::copy_n(source.tile(tile_x), columns.extent, out + kHalo);
    for_each_margin_column(columns.extent, [&](int x) {
        const HaloSource& column = columns.cells[x + kHalo];
        out[x + kHalo] = column.outside ? T{} : source.at(column);
    });
}

void gather_heights(const SupportHeights& field, const HaloMap& columns, const HaloSource& row,
                    int tile_x, float* out) {
    const int first_tile = row.tile * field.shape().tiles_x(), first_cell = row.cell * kTileSize;
    field.read(first_tile + tile_x).copy(first_cell, columns.extent, out + kHalo);
    for_each_margin_column(columns.extent, [&](int x) {
        const HaloSource& column = columns.cells[x + kHalo];
        out[x + kHalo] = field.read(first_tile + column.tile)[first_cell + column.cell];
    });
}

float velocity_at(const FieldRow<float>& source, const HaloSource& column, bool mirrors) {
    if (column.outside) return 0.0F;
    const float velocity = source.at(column);
    return mirrors && column.mirrored ? -velocity : velocity;
}

/// `columns` and `row` are faces along the component's own axis and cells along the other.
void gather_velocity(const grid::TiledField<float>& field,
                     const std::array<HaloSource, kBlockRows>& columns, int extent,
                     const HaloSource& row, int tile_x, bool x_component, float* out) {
    if (row.outside) {
        std::fill_n(out, extent + 2 * kHalo, 0.0F);
        return;
    }
    const FieldRow<float> source(field, row);
    const float sign = !x_component && row.mirrored ? -1.0F : 1.0F;
    const float* values = source.tile(tile_x);
    for (int x = 0; x < extent; ++x)
        out[x + kHalo] = sign * values[x];
    for_each_margin_column(extent, [&](int x) {
        out[x + kHalo] = sign * velocity_at(source, columns[x + kHalo], x_component);
    });
    if (x_component && columns[extent - 1 + kHalo].outside) out[extent - 1 + kHalo] = 0.0F;
}

void gather_quanta_row(const grid::TiledField<std::int32_t>& thickness, const HaloMap& columns,
                       const HaloSource& row, int tile_x, std::int32_t* out) {
    if (row.outside)
        std::fill_n(out, columns.extent + 2 * kHalo, 0);
    else
        gather_cells(thickness, columns, row, tile_x, out);
}

void derive_surface(HaloBlock& block, int row_start, int width) {
    for (int i = row_start; i < row_start + width; ++i) {
        block.thickness[i] = thickness_mm(block.quanta[i]);
        block.eta[i] = block.thickness[i] + block.support[i];
    }
}

void clear_beyond(HaloBlock& block, int row_start, int width) {
    for (int i = row_start + width; i < row_start + kBlockStride; ++i) {
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
    const int width = columns.extent + 2 * kHalo;
    for (int y = -kHalo; y < kTileSize + kHalo; ++y) {
        const int start = block_index(-kHalo, y);
        if (y >= rows.extent + kHalo) {
            clear_row(block, start);
            continue;
        }
        const HaloSource& row = rows.cells[y + kHalo];
        gather_quanta_row(state.thickness, columns, row, tile_x, &block.quanta[start]);
        gather_heights(state.support_mm, columns, row, tile_x, &block.support[start]);
        gather_velocity(state.velocity_x, columns.faces, columns.extent, row, tile_x, true,
                        &block.velocity_x[start]);
        gather_velocity(state.velocity_y, columns.cells, columns.extent, rows.faces[y + kHalo], tile_x,
                        false, &block.velocity_y[start]);
        derive_surface(block, start, width);
        clear_beyond(block, start, width);
        note_wet_row(block, y, start, width, wet_mm);
    }
}

void gather_covered(const grid::Mask* cover, const HaloMap& columns, const HaloMap& rows, int tile_x,
                    HaloBlock& block) {
    block.any_covered = false;
    if (cover == nullptr) return;
    for (int y = -1; y <= rows.extent; ++y) {
        std::uint8_t* out = &block.covered[block_index(-kHalo, y)];
        const HaloSource& row = rows.cells[y + kHalo];
        std::fill_n(out, kBlockStride, std::uint8_t{0});
        if (row.outside) continue;
        gather_cells(*cover, columns, row, tile_x, out);
        block.any_covered = block.any_covered || std::any_of(out, out + kBlockStride,
                                                             [](std::uint8_t is) { return is != 0; });
    }
}

void gather_quanta(const grid::TiledField<std::int32_t>& thickness, const HaloMap& columns,
                   const HaloMap& rows, int tile_x, BlockArray<std::int32_t>& quanta) {
    for (int y = -kHalo; y < kTileSize + kHalo; ++y) {
        std::int32_t* out = &quanta[block_index(-kHalo, y)];
        const bool reached = y < rows.extent + kHalo;
        if (reached) gather_quanta_row(thickness, columns, rows.cells[y + kHalo], tile_x, out);
        const int filled = reached ? columns.extent + 2 * kHalo : 0;
        std::fill(out + filled, out + kBlockStride, 0);
    }
}

}  // namespace pastoso::film
