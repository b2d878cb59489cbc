#include "film/explicit/air_block.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::film {
namespace {

/// Where a row or column of a block lies on the canvas, in cells.
double place_of(const HaloSource& source) {
    return source.tile * grid::kTileSize + source.cell + 0.5;
}

bool is_near(const std::array<HaloSource, kBlockRows>& line, double middle_cells, double reach_cells) {
    return std::any_of(line.begin(), line.end(), [&](const HaloSource& source) {
        return std::abs(place_of(source) - middle_cells) < reach_cells;
    });
}

bool reaches(const AirJet& jet, const HaloMap& columns, const HaloMap& rows, double cell_mm) {
    const double reach_cells = kJetReach_radii * jet.radius_mm / cell_mm;
    return is_near(columns.cells, jet.x_mm / cell_mm, reach_cells) &&
           is_near(rows.cells, jet.y_mm / cell_mm, reach_cells);
}

}  // namespace

void press(std::span<const AirJet> jets, double density_kg_m3, const HaloMap& columns,
           const HaloMap& rows, double cell_mm, HaloBlock& block) {
    block.pressed = false;
    const double scale = kPaPerDensity_mm2_s2 / density_kg_m3;
    for (const AirJet& jet : jets) {
        if (!reaches(jet, columns, rows, cell_mm)) continue;
        if (!block.pressed) block.air.fill(0.0F);
        block.pressed = true;
        for (int y = 0; y < kBlockRows; ++y)
            for (int x = 0; x < kBlockRows; ++x)
                block.air[y * kBlockStride + x] +=
                    static_cast<float>(scale * air_pressure_Pa(jet, place_of(columns.cells[x]) * cell_mm,
                                                               place_of(rows.cells[y]) * cell_mm));
    }
}

}  // namespace pastoso::film
