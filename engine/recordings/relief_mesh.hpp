// The relief of a canvas as a closed solid for 3D printing, in millimetres: x right, y up the canvas,
// z out of it, the flat back at z = 0.
#pragma once

#include "core/thread_pool.hpp"
#include "files/triangle_file.hpp"
#include "film/state.hpp"
#include "recordings/export_bands.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace pastoso::recordings {

inline constexpr double kMaxReliefVertices = 25e6;

struct ReliefOptions {
    double base_mm = 2.0;        ///< from the back to level 0 of the support, 0.1 to 100
    double exaggeration = 1.0;   ///< heights are multiplied by this, 0.01 to 100
    double resolution_mm = 0.0;  ///< distance of vertices; 0: a cell, or 1/1000 of the longer side where
                                 ///< that is more
    friend bool operator==(const ReliefOptions&, const ReliefOptions&) = default;
};

/// The points of a relief's front.
struct ReliefGrid {
    int columns = 0, rows = 0;
};

/// Those that a canvas of so many cells gets. Throws InputError for options outside their ranges and for
/// more than kMaxReliefVertices.
ReliefGrid relief_grid(const grid::Shape& cells, double cell_mm, const ReliefOptions& options);

/// A grid of heights over a flat back. The solid's vertices are those of the grid, row by row from the
/// canvas's upper left corner, then those of the back: below the border of the grid, all around from the
/// same corner down the left side, and the middle.
struct Relief {
    int columns = 0, rows = 0;  ///< at least 2 each
    double step_x_mm = 0.0, step_y_mm = 0.0;
    std::vector<float> z_mm;  ///< > 0

    std::size_t border_count() const { return 2 * static_cast<std::size_t>(columns + rows) - 4; }
    std::size_t vertex_count() const { return z_mm.size() + border_count() + 1; }
    std::size_t triangle_count() const {
        return 2 * static_cast<std::size_t>(columns - 1) * static_cast<std::size_t>(rows - 1) +
               3 * border_count();
    }
    std::array<float, 3> vertex(std::size_t index) const;

  private:
    std::array<float, 3> at(int column, int row, float z) const;
};

/// Means of the interpolated surface around the vertices: z = base + exaggeration max(h, 0). Throws
/// InputError as relief_grid() does. None where `keep_going` said so.
std::optional<Relief> relief_of(const film::FilmState& film, const ReliefOptions& options,
                                core::ThreadPool& pool, const files::KeepGoing& keep_going);

/// The same to the end.
Relief relief_of(const film::FilmState& film, const ReliefOptions& options, core::ThreadPool& pool);

/// Calls use(triangle) for the triangles of the solid, seen from outside counter-clockwise: two for each
/// square of the grid, the walls, and a fan around the middle of the back. Every edge belongs to two.
void for_each_triangle(const Relief& relief, const std::function<void(const files::Triangle&)>& use);

}  // namespace pastoso::recordings
