// A canvas of 4096 x 4096 cells that is painted all over: real strokes of many colours on a piece of it,
// repeated at other thicknesses, so that no copy compresses with the help of another.
#pragma once

#include "document/painting.hpp"
#include "document/painting_state.hpp"

#include <cmath>

namespace pastoso::bench {

inline constexpr int kCells = 4096, kPiece = 1024;
inline constexpr double kPxPerMm = 8.0;

inline document::CanvasSettings square(int cells) {
    document::CanvasSettings settings;
    settings.width_mm = settings.height_mm = cells / kPxPerMm;
    settings.px_per_mm = kPxPerMm;
    return settings;
}

inline void paint_stroke(document::Painting& painting, double start_s, double y_mm, bool leftwards) {
    constexpr int kSamples = 100;
    for (int i = 0; i <= kSamples; ++i) {
        const double u = static_cast<double>(i) / kSamples;
        const double x_mm = -5.0 + 138.0 * (leftwards ? 1.0 - u : u);
        const brush::PenSample sample{.time_s = start_s + u,
                                      .x_mm = x_mm,
                                      .y_mm = y_mm + 2.0 * std::sin(9.0 * u + y_mm),
                                      .pressure = 0.6 + 0.3 * std::sin(5.0 * u),
                                      .rotation_deg = 90.0};
        if (i == 0)
            painting.apply(document::PenDown{sample});
        else
            painting.apply(document::PenMove{sample});
    }
    painting.apply(document::PenUp{});
}

/// Two layers of strokes wet in wet, all over the piece.
inline film::FilmState painted_piece(const char* medium, core::ThreadPool& pool) {
    static constexpr const char* kPaints[] = {"PB29", "PW6", "PY35", "PR108", "PG18", "PBr7-BU"};
    document::Painting painting(square(kPiece), pool);
    painting.set_history_budget(0);
    painting.apply(document::UseMedium{medium});
    painting.apply(document::TakeBrush{"flat", 20.0, 1});
    int stroke = 0;
    for (const double first_mm : {4.0, 9.0})
        for (double y_mm = first_mm; y_mm < 132.0; y_mm += 10.0, ++stroke) {
            document::LoadPaint load;
            load.paint.ingredients = {{kPaints[stroke % 6], 1.0}, {kPaints[(stroke / 2 + 1) % 6], 0.6}};
            painting.apply(document::CleanBrush{});
            painting.apply(load);
            paint_stroke(painting, stroke, y_mm, stroke % 2 == 1);
            painting.advance_tick();
        }
    for (int tick = 0; tick < 60; ++tick)
        painting.advance_tick();
    return painting.film();
}

template <class T, class Change>
void spread(const grid::TiledField<T>& piece, grid::TiledField<T>& field, const Change& change) {
    const int tiles = kPiece / grid::kTileSize, copies = kCells / kPiece;
    for (int tile = 0; tile < field.tile_count(); ++tile) {
        const int x = tile % (tiles * copies), y = tile / (tiles * copies);
        const int source = y % tiles * tiles + x % tiles, copy = y / tiles * copies + x / tiles;
        if (piece.is_background(source)) continue;
        auto block = grid::TileBlock<T>::copy_of(piece.read(source));
        for (int cell = 0; cell < grid::kTileCells; ++cell)
            change(block.write()[cell], 0.7 + 0.3 * copy / (copies * copies));
        field.replace(tile, std::move(block));
    }
}

/// The whole canvas, between two strokes.
inline document::PaintingState painted_canvas(const char* medium, core::ThreadPool& pool) {
    const document::CanvasSettings settings = square(kCells);
    const film::FilmState piece = painted_piece(medium, pool);
    document::PaintingState painting = document::Painting(settings, pool).state();
    film::FilmState& film = painting.value.film;
    film.consistencies = film::Consistencies::several();
    const auto scale = [](std::int32_t& value, double factor) {
        value = static_cast<std::int32_t>(value * factor);
    };
    spread(piece.thickness, film.thickness, scale);
    spread(piece.paint, film.paint, [&](film::PaintCell& cell, double factor) {
        for (std::int32_t& channel : cell)
            scale(channel, factor);
    });
    const auto speed = [](float& value, double factor) { value *= static_cast<float>(factor); };
    spread(piece.velocity_x, film.velocity_x, speed);
    spread(piece.velocity_y, film.velocity_y, speed);
    return painting;
}

}  // namespace pastoso::bench
