#include "layers/turning.hpp"

#include "grid/turning.hpp"
#include "layers/cell_fields.hpp"

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

namespace pastoso::layers {
namespace {

using core::Orientation;
using grid::TileBlock;
using Velocities = grid::TiledField<float>;

/// The step of all tiles before that a tile has cells of, where they are in levels of one step.
std::optional<float> common_level_mm(const Heights& heights_mm, const grid::TilesBefore& before,
                                     int tile) {
    std::optional<float> level_mm;
    const bool differ = before.any_of(tile, [&](int source) {
        const film::TileHeights heights = heights_mm.read(source);
        if (heights.levels == nullptr) return true;
        return std::exchange(level_mm, heights.level_mm).value_or(heights.level_mm) != heights.level_mm;
    });
    return differ ? std::nullopt : level_mm;
}

film::HeightBlock turned_levels(const Heights& heights_mm, const grid::TilesBefore& before, int tile,
                                float level_mm) {
    auto levels = TileBlock<std::uint16_t>::filled(0);
    std::uint16_t* values = levels.write();
    before.for_each_cell(tile, [&](int cell, int source, int source_cell) {
        values[cell] = heights_mm.read(source).levels[source_cell];
    });
    return {std::move(levels), level_mm};
}

film::HeightBlock turned_floats(const Heights& heights_mm, const grid::TilesBefore& before, int tile) {
    auto floats = TileBlock<float>::filled(0.0F);
    float* values = floats.write();
    before.for_each_cell(tile, [&](int cell, int source, int source_cell) {
        values[cell] = heights_mm.read(source)[source_cell];
    });
    return floats;
}

/// The other way; nothing stays as it is.
float against(float velocity) {
    return velocity == 0.0F ? velocity : -velocity;
}

int around(int place, int count) {
    return (place + count) % count;
}

/// Velocities at the faces on that side of the cells, of those at the faces that lay there.
class FacesBefore {
  public:
    FacesBefore(const Velocities& field, const Orientation& turn, core::PlanePoint<int> step)
        : field_(field), before_(field.shape(), turn), step_(step) {}

    const grid::Shape& after() const { return before_.after(); }

    TileBlock<float> tile(int tile) const {
        auto block = TileBlock<float>::filled(0.0F);
        float* values = block.write();
        const grid::Rect now = after().tile_cells(tile);
        bool any = false;
        for (int y = now.y0; y < now.y1; ++y)
            for (int x = now.x0; x < now.x1; ++x) {
                const float velocity = at(x, y);
                values[grid::Shape::cell_in_tile(x, y)] = velocity;
                any = any || velocity != 0.0F || std::signbit(velocity);
            }
        return any ? block : TileBlock<float>{};
    }

  private:
    /// A face was kept with the cell before it, which the step to the next one may have led to.
    float at(int x, int y) const {
        const auto cell = before_.cells()(x, y);
        if (step_.x + step_.y > 0) return field_.at(cell.x, cell.y);
        const grid::Shape& shape = field_.shape();
        return against(
            field_.at(around(cell.x + step_.x, shape.width), around(cell.y + step_.y, shape.height)));
    }

    const Velocities& field_;
    grid::TilesBefore before_;
    core::PlanePoint<int> step_;
};

bool is_at_rest(const Velocities& field) {
    for (int tile = 0; tile < field.tile_count(); ++tile)
        if (!field.is_background(tile)) return false;
    return true;
}

void put_turned(const Velocities& field, const Orientation& turn, core::PlanePoint<int> step,
                Velocities& result, core::ThreadPool& pool) {
    if (is_at_rest(field)) return;
    const FacesBefore before(field, turn, step);
    pool.run(static_cast<std::size_t>(result.tile_count()), [&](std::size_t index, int) {
        const int tile = static_cast<int>(index);
        if (auto block = before.tile(tile)) result.replace(tile, std::move(block));
    });
}

void turn_velocities(const film::FilmState& layer, const Orientation& turn, film::FilmState& result,
                     core::ThreadPool& pool) {
    const core::CellsBefore cells(turn, layer.shape.width, layer.shape.height);
    const bool swapped = turn.swaps_sides();
    put_turned(swapped ? layer.velocity_y : layer.velocity_x, turn, cells.right(), result.velocity_x,
               pool);
    put_turned(swapped ? layer.velocity_x : layer.velocity_y, turn, cells.down(), result.velocity_y,
               pool);
}

void turn_media(const film::FilmState& layer, const Orientation& turn, film::FilmState& result,
                core::ThreadPool& pool) {
    result.media.numbers = layer.media.numbers;
    if (!layer.media.are_several()) return;
    MediaCells put(result.shape);
    grid::put_turned(told_media(layer), turn, put, pool);
    put_media(put, result);
}

}  // namespace

film::FilmState turned(const film::FilmState& layer, const Orientation& turn, core::ThreadPool& pool) {
    film::FilmState result(grid::turned(layer.shape, turn), layer.cell_mm);
    for_each_cell_field([&](const auto& field, auto& put) { grid::put_turned(field, turn, put, pool); },
                        layer, result);
    turn_velocities(layer, turn, result, pool);
    turn_media(layer, turn, result, pool);
    result.worked.is_followed = layer.worked.is_followed;
    result.consistencies = layer.consistencies;
    result.strata.fixed = layer.strata.fixed;
    result.strata.evaporated = layer.strata.evaporated;
    return result;
}

Heights turned(const Heights& heights_mm, const Orientation& turn, core::ThreadPool& pool) {
    const grid::TilesBefore before(heights_mm.shape(), turn);
    Heights result(before.after());
    pool.run(static_cast<std::size_t>(result.tile_count()), [&](std::size_t index, int) {
        const int tile = static_cast<int>(index);
        if (!before.any_of(tile, [&](int source) { return !heights_mm.is_background(source); })) return;
        const auto level_mm = common_level_mm(heights_mm, before, tile);
        result.replace(tile, level_mm ? turned_levels(heights_mm, before, tile, *level_mm)
                                      : turned_floats(heights_mm, before, tile));
    });
    return result;
}

Tracing turned(const Tracing& tracing, const Orientation& turn, double width_mm, double height_mm) {
    struct Rectangle {
        double x0, y0, x1, y1;
    };
    const PicturePlace& place = tracing.place;
    const Rectangle canvas = core::turned_rectangle(Rectangle{0.0, 0.0, width_mm, height_mm}, turn);
    const Rectangle picture = core::turned_rectangle(
        Rectangle{place.x_mm, place.y_mm, place.x_mm + place.width_mm, place.y_mm + place.height_mm},
        turn);
    const bool swapped = turn.swaps_sides();
    return {std::make_shared<const pigment::Picture>(pigment::turned(*tracing.picture, turn)),
            {picture.x0 - canvas.x0, picture.y0 - canvas.y0, swapped ? place.height_mm : place.width_mm,
             swapped ? place.width_mm : place.height_mm},
            tracing.opacity};
}

}  // namespace pastoso::layers
