#include "recordings/export_bands.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::recordings {
namespace {

constexpr double kBandCells = 1 << 22;
constexpr int kFewestRows = 8;

int rows_of_a_band(const shade::Lattice& lattice, double most_pixels) {
    const double row_cells = lattice.width / lattice.scale_x / lattice.scale_y;
    const double rows = std::min(most_pixels / lattice.width, kBandCells / row_cells);
    return std::max(kFewestRows, static_cast<int>(std::min<double>(rows, lattice.height)));
}

}  // namespace

shade::Lattice export_lattice(const ExportSource& source) {
    return shade::picture_lattice(source.film.shape, source.film.shape.cells(), source.settings.scale);
}

double export_px_per_mm(const ExportSource& source) {
    return source.settings.scale / source.film.cell_mm;
}

bool for_each_band(const shade::Lattice& lattice, const files::KeepGoing& keep_going,
                   const std::function<void(const grid::Rect&)>& work, double most_pixels) {
    const int rows = rows_of_a_band(lattice, most_pixels);
    for (int y = 0; y < lattice.height; y += rows) {
        if (!keep_going(static_cast<double>(y) / lattice.height)) return false;
        work({0, y, lattice.width, std::min(y + rows, lattice.height)});
    }
    return keep_going(1.0);
}

}  // namespace pastoso::recordings
