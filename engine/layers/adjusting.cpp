#include "layers/adjusting.hpp"

#include "core/check.hpp"
#include "film/cell/cell_drying.hpp"
#include "layers/cutting.hpp"
#include "layers/dry_cells.hpp"
#include "pigment/stirring.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace pastoso::layers {
namespace {

using film::DriedTotals;
using film::FilmState;
using film::StrataCell;

/// What came and went, summed over cells.
struct Moved {
    DriedTotals added, removed;  ///< of fixed paint that went, only fixed_quanta
    std::int64_t fixed_quanta = 0;
    std::int64_t evaporated = 0;

    Moved& operator+=(const Moved& other) {
        added += other.added;
        removed += other.removed;
        fixed_quanta += other.fixed_quanta;
        evaporated += other.evaporated;
        return *this;
    }
};

/// Changes a cell that holds dry paint, by the share that is chosen of it.
using CellChange = std::function<void(const StrataCell& cell, std::uint8_t chosen, Moved& moved)>;

/// A paint by what is left of it when it is dry. Thicknesses are dry ones, in quanta.
class DryPaint {
  public:
    explicit DryPaint(const film::PaintCoefficients& wet)
        : wet_(wet), solids_(wet[film::kSolidsChannel]) {}

    const film::PaintCoefficients& wet() const { return wet_; }
    double optical_thickness(int channel, std::int64_t thickness) const {
        return wet_[channel] * (static_cast<double>(thickness) * film::kThicknessQuantum_mm / solids_);
    }
    std::int64_t evaporated(std::int64_t thickness) const {
        return std::llround(static_cast<double>(thickness) / solids_) - thickness;
    }
    DriedTotals totals(std::int64_t thickness) const {
        DriedTotals sums{.thickness = thickness};
        for (int k = 0; k < film::kPigmentChannels; ++k)
            sums.pigment[k] = std::llround(optical_thickness(k, thickness) / film::kPaintQuantum);
        return sums;
    }

  private:
    film::PaintCoefficients wet_;
    double solids_;
};

/// What is laid on a cell, and what of it is left when it is dry.
struct Coat {
    DriedTotals dry;
    std::int32_t wet = 0;
    film::PaintCell laid{};
};

/// `carried`: its solids.
Coat coat_of(std::int32_t carried, const DryPaint& paint) {
    Coat coat{.dry = paint.totals(carried * film::kQuantaPerCarried)};
    coat.wet = static_cast<std::int32_t>(coat.dry.thickness + paint.evaporated(coat.dry.thickness));
    for (int k = 0; k < film::kPigmentChannels; ++k)
        coat.laid[k] = static_cast<std::int32_t>(coat.dry.pigment[k]);
    coat.laid[film::kSolidsChannel] = carried;
    return coat;
}

CellChange change_of(const Glaze& glaze, const DryPaint& paint) {
    // Solids are carried in coarser quanta than thickness.
    const auto carried =
        static_cast<std::int32_t>(std::lround(glaze.thickness_mm / film::kPaintQuantum));
    std::vector<Coat> coats;
    for (int share = 0; share <= grid::kWhole; ++share)
        coats.push_back(coat_of(grid::share_of(carried, static_cast<std::uint8_t>(share)), paint));
    return [coats = std::move(coats)](const StrataCell& cell, std::uint8_t chosen, Moved& moved) {
        Coat coat = coats[chosen];
        if (coat.dry.thickness == 0) return;
        moved.evaporated += film::become_stratum(coat.wet, coat.laid, cell);
        moved.added += coat.dry;
    };
}

void come(const DriedTotals& added, const DryPaint& paint, Moved& moved) {
    moved.added += added;
    moved.evaporated += paint.evaporated(added.thickness);
}

void exchange_soluble(double share, const DryPaint& paint, const StrataCell& cell, Moved& moved) {
    const std::int64_t quanta = std::llround(share * cell.soluble_thickness);
    if (quanta <= 0) return;
    DriedTotals added = paint.totals(quanta), gone{.thickness = quanta};
    for (int k = 0; k < film::kPigmentChannels; ++k) {
        std::int32_t& held = cell.soluble_pigment[k];
        gone.pigment[k] = std::llround(share * held);
        held -= static_cast<std::int32_t>(gone.pigment[k]);
        const std::int64_t most = std::numeric_limits<std::int32_t>::max() - held;
        added.pigment[k] = std::min(added.pigment[k], most);
        held += static_cast<std::int32_t>(added.pigment[k]);
    }
    moved.removed += gone;
    come(added, paint, moved);
}

/// What a stratum is made of when a share of it is exchanged for the paint.
film::PigmentMixture exchanged(const film::PigmentMixture& mixture, double share,
                               const film::PaintCoefficients& paint) {
    constexpr auto kMillimetre = static_cast<std::int32_t>(1.0 / film::kThicknessQuantum_mm);
    const pigment::Coefficients before = film::coefficients_of(mixture);
    film::PigmentCell per_mm{};
    for (int k = 0; k < film::kPigmentChannels; ++k) {
        const double mean = (1.0 - share) * before[k] + share * paint[k];
        per_mm[k] = static_cast<std::int32_t>(std::lround(mean / film::kPaintQuantum));
    }
    return film::mixture_of(per_mm.data(), kMillimetre);
}

void exchange_fixed(double share, const DryPaint& paint, const StrataCell& cell, Moved& moved) {
    const std::int64_t whole =
        std::llround(cell.support_mm / film::kThicknessQuantum_mm) - cell.soluble_thickness;
    const std::int64_t quanta = std::llround(share * static_cast<double>(whole));
    if (quanta <= 0) return;
    for (int band = 0; band < pigment::kBands; ++band) {
        const pigment::OpticalThickness in_full{paint.optical_thickness(band, whole),
                                                paint.optical_thickness(pigment::kBands + band, whole)};
        const auto [r, t, q] = film::optics_of(cell.optics, band);
        const auto mixed = pigment::stirred({r, t, q}, in_full, share);
        film::set_optics(band,
                         {static_cast<float>(mixed.reflectance), static_cast<float>(mixed.transmittance),
                          static_cast<float>(mixed.reverse)},
                         cell.optics);
    }
    cell.uppermost = exchanged(cell.uppermost, share, paint.wet());
    const DriedTotals added = paint.totals(quanta);
    cell.fixed += added;
    moved.fixed_quanta += quanta;
    come(added, paint, moved);
}

CellChange change_of(const PaintExchange& exchange, const DryPaint& paint) {
    return [whole = exchange.share, paint](const StrataCell& cell, std::uint8_t chosen, Moved& moved) {
        const double share = whole * chosen / grid::kWhole;
        exchange_fixed(share, paint, cell, moved);
        exchange_soluble(share, paint, cell, moved);
    };
}

/// The strata of a tile, for writing.
struct StrataTile {
    int tile;
    float* relief_mm;
    std::int32_t* soluble_thickness;
    film::PigmentCell* soluble_pigment;
    film::StrataOptics* optics;
    film::PigmentMixture* uppermost;
    DriedTotals fixed{};  ///< that became so
    Moved moved{};

    StrataCell at(int cell) {
        return {relief_mm[cell], soluble_thickness[cell], soluble_pigment[cell],
                optics[cell],    uppermost[cell],         fixed};
    }
    bool holds_soluble() const {
        for (int cell = 0; cell < grid::kTileCells; ++cell)
            if (!film::is_empty(soluble_pigment[cell], soluble_thickness[cell])) return true;
        return false;
    }
};

std::vector<StrataTile> opened_tiles(FilmState& layer, const grid::Mask* where) {
    std::vector<StrataTile> tiles;
    film::Strata& strata = layer.strata;
    for (int tile = 0; tile < layer.shape.tile_count(); ++tile) {
        bool any = false;
        for_each_dry_cell(layer, where, tile, [&](int, std::uint8_t) { any = true; });
        if (!any) continue;
        tiles.push_back({tile, layer.support_mm.write(tile), strata.soluble_thickness.write(tile),
                         strata.soluble_pigment.write(tile), strata.optics.write(tile),
                         strata.uppermost.write(tile)});
    }
    return tiles;
}

void close(const StrataTile& tile, film::Strata& strata) {
    strata.fixed += tile.fixed;
    if (tile.holds_soluble()) return;
    strata.soluble_thickness.reset(tile.tile);
    strata.soluble_pigment.reset(tile.tile);
}

}  // namespace

bool can_lie_dry(const film::PaintCoefficients& paint) {
    return paint[film::kSolidsChannel] >= kLeastSolids;
}

AdjustedLayer adjusted(const FilmState& layer, const film::PaintCoefficients& paint,
                       const Adjustment& adjustment, const grid::Mask* where, core::ThreadPool& pool) {
    PASTOSO_CHECK(can_lie_dry(paint));
    const DryPaint dry(paint);
    const CellChange change =
        std::visit([&](const auto& how) { return change_of(how, dry); }, adjustment);
    AdjustedLayer result{.film = layer};
    std::vector<StrataTile> tiles = opened_tiles(result.film, where);
    pool.run(tiles.size(), [&](std::size_t index, int) {
        StrataTile& tile = tiles[index];
        for_each_dry_cell(layer, where, tile.tile, [&](int cell, std::uint8_t chosen) {
            change(tile.at(cell), chosen, tile.moved);
        });
    });
    Moved moved;
    for (const StrataTile& tile : tiles) {
        close(tile, result.film.strata);
        moved += tile.moved;
    }
    if (moved.fixed_quanta > 0) {
        const std::int64_t whole = fixed_relief_quanta(layer);
        const DriedTotals gone =
            share_fixed(layer.strata.fixed, std::min(moved.fixed_quanta, whole), whole);
        result.film.strata.fixed -= gone;
        moved.removed += gone;
    }
    result.film.strata.evaporated += moved.evaporated;
    result.added = moved.added;
    result.removed = moved.removed;
    result.evaporated = moved.evaporated;
    return result;
}

}  // namespace pastoso::layers
