#include "recordings/relief_mesh.hpp"

#include "core/check.hpp"
#include "core/error.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::recordings {
namespace {

constexpr double kMostStepsByDefault = 1000.0;

void check_range(const core::Message& what, double value, double least, double most) {
    if (value >= least && value <= most) return;
    throw core::InputError("The relief's %1 is %2, outside the range from %3 to %4.", what, value, least,
                           most);
}

/// The column and the row of a vertex of the border, counted from the upper left corner down the left
/// side, along the lower edge, and back.
std::array<int, 2> border_place(const Relief& relief, std::size_t index) {
    const int right = relief.columns - 1, bottom = relief.rows - 1;
    const int i = static_cast<int>(index);
    if (i <= bottom) return {0, i};
    if (i <= bottom + right) return {i - bottom, bottom};
    if (i <= 2 * bottom + right) return {right, 2 * bottom + right - i};
    return {2 * (bottom + right) - i, 0};
}

double resolution_of(const grid::Shape& cells, double cell_mm, const ReliefOptions& options) {
    if (options.resolution_mm != 0.0) return options.resolution_mm;
    const double longer_mm = cell_mm * std::max(cells.width, cells.height);
    return std::max(cell_mm, longer_mm / kMostStepsByDefault);
}

int vertices_along(int cells, double cell_mm, double resolution_mm) {
    return 1 + static_cast<int>(std::max(1L, std::lround(cells * cell_mm / resolution_mm)));
}

/// Pixels whose middles are the vertices: half of those at the border lie beyond the canvas.
shade::Lattice lattice_of(const grid::Shape& cells, int columns, int rows) {
    shade::Lattice lattice;
    lattice.scale_x = (columns - 1.0) / cells.width;
    lattice.scale_y = (rows - 1.0) / cells.height;
    lattice.left_cells = -0.5 / lattice.scale_x;
    lattice.top_cells = -0.5 / lattice.scale_y;
    lattice.width = columns;
    lattice.height = rows;
    return lattice;
}

void check_options(double cell_mm, const ReliefOptions& options) {
    constexpr double kFewestCells = 1.0 / 64.0, kMostCells = 64.0;
    check_range(core::message("base in mm"), options.base_mm, 0.1, 100.0);
    check_range(core::message("exaggeration"), options.exaggeration, 0.01, 100.0);
    if (options.resolution_mm == 0.0) return;
    check_range(core::message("resolution in mm"), options.resolution_mm, cell_mm * kFewestCells,
                cell_mm * kMostCells);
}

void check_count(int columns, int rows) {
    if (static_cast<double>(columns) * rows <= kMaxReliefVertices) return;
    throw core::InputError(
        "A relief of %1 x %2 points is more than the 25 million that can be made; a coarser resolution "
        "takes fewer.",
        columns, rows);
}

}  // namespace

std::array<float, 3> Relief::at(int column, int row, float z) const {
    return {static_cast<float>(column * step_x_mm), static_cast<float>((rows - 1 - row) * step_y_mm), z};
}

std::array<float, 3> Relief::vertex(std::size_t index) const {
    PASTOSO_CHECK_OP(index, <, vertex_count());
    if (index < z_mm.size()) {
        const auto width = static_cast<std::size_t>(columns);
        return at(static_cast<int>(index % width), static_cast<int>(index / width), z_mm[index]);
    }
    const std::size_t below = index - z_mm.size();
    if (below < border_count()) {
        const auto [column, row] = border_place(*this, below);
        return at(column, row, 0.0F);
    }
    return {static_cast<float>(0.5 * (columns - 1) * step_x_mm),
            static_cast<float>(0.5 * (rows - 1) * step_y_mm), 0.0F};
}

ReliefGrid relief_grid(const grid::Shape& cells, double cell_mm, const ReliefOptions& options) {
    check_options(cell_mm, options);
    const double resolution_mm = resolution_of(cells, cell_mm, options);
    const ReliefGrid grid{vertices_along(cells.width, cell_mm, resolution_mm),
                          vertices_along(cells.height, cell_mm, resolution_mm)};
    check_count(grid.columns, grid.rows);
    return grid;
}

std::optional<Relief> relief_of(const film::FilmState& film, const ReliefOptions& options,
                                core::ThreadPool& pool, const files::KeepGoing& keep_going) {
    const ReliefGrid grid = relief_grid(film.shape, film.cell_mm, options);
    Relief relief;
    relief.columns = grid.columns;
    relief.rows = grid.rows;
    relief.step_x_mm = film.shape.width * film.cell_mm / (relief.columns - 1);
    relief.step_y_mm = film.shape.height * film.cell_mm / (relief.rows - 1);
    relief.z_mm.reserve(static_cast<std::size_t>(relief.columns) *
                        static_cast<std::size_t>(relief.rows));
    const shade::Lattice lattice = lattice_of(film.shape, relief.columns, relief.rows);
    const shade::Renderer renderer(film, {}, lattice, {}, pool);
    shade::SurfaceSamples surface;
    const bool complete = for_each_band(lattice, keep_going, [&](const grid::Rect& pixels) {
        renderer.render(pixels, nullptr, &surface);
        for (const shade::SurfaceSample& sample : surface.samples) {
            relief.z_mm.push_back(static_cast<float>(
                options.base_mm + options.exaggeration * std::max(sample.height_mm, 0.0F)));
        }
    });
    if (!complete) return {};
    return relief;
}

Relief relief_of(const film::FilmState& film, const ReliefOptions& options, core::ThreadPool& pool) {
    return *relief_of(film, options, pool, [](double) { return true; });
}

void for_each_triangle(const Relief& relief, const std::function<void(const files::Triangle&)>& use) {
    const auto columns = static_cast<std::uint32_t>(relief.columns);
    const auto rows = static_cast<std::uint32_t>(relief.rows);
    for (std::uint32_t row = 0; row + 1 < rows; ++row) {
        for (std::uint32_t column = 0; column + 1 < columns; ++column) {
            const std::uint32_t corner = row * columns + column, below = corner + columns;
            use({corner, below, corner + 1});
            use({corner + 1, below, below + 1});
        }
    }
    const auto border = static_cast<std::uint32_t>(relief.border_count());
    const auto first = static_cast<std::uint32_t>(relief.z_mm.size());
    const auto on_grid = [&](std::uint32_t i) {
        const auto [column, row] = border_place(relief, i);
        return static_cast<std::uint32_t>(row) * columns + static_cast<std::uint32_t>(column);
    };
    for (std::uint32_t i = 0; i < border; ++i) {
        const std::uint32_t next = (i + 1) % border;
        use({on_grid(next), on_grid(i), first + i});
        use({on_grid(next), first + i, first + next});
        use({first + border, first + next, first + i});
    }
}

}  // namespace pastoso::recordings
