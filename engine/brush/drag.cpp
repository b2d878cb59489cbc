#include "brush/drag.hpp"

#include "brush/lane_weight.hpp"
#include "core/elementary.hpp"

#include <algorithm>
#include <cmath>

namespace pastoso::brush {
namespace {

/// Paint that stops within this way is left at rest.
constexpr double kStop_mm = 0.002;

/// Weight times contact of one cell, as the exchange has it.
float touch_of(const ExchangeRule& rule, const CellBatch& cells, int i) {
    const float s = cells.dx_mm[i] * rule.across_x + cells.dy_mm[i] * rule.across_y;
    const float t = cells.dx_mm[i] * rule.along_x + cells.dy_mm[i] * rule.along_y;
    const float radius2 = rule.lane ? t * t : s * s + t * t;
    const float across = rule.lane ? lane_weight(s, rule.lane_core) : 1.0F;
    const float weight = std::max(0.0F, 1.0F - radius2) * (1.0F + rule.crown * radius2) * across;
    const float surface = cells.support_mm[i] + film::thickness_mm(cells.thickness[i]);
    return weight * std::clamp((surface - rule.lowest_mm) * rule.fade_per_mm, 0.0F, 1.0F);
}

std::int32_t thickest(const CellBatch& cells) {
    std::int32_t thickest = 0;
    for (int i = 0; i < cells.count(); ++i)
        thickest = std::max(thickest, cells.thickness[i]);
    return thickest;
}

constexpr double kThinnest_mm2_s = film::kThinnest_m2_s * 1e6;

/// Thickness from which on paint goes on moving.
std::int32_t least_quanta(double log_viscosity, double speed_mm_s) {
    const double nu_mm2_s = kThinnest_mm2_s * std::exp(log_viscosity);
    const double quanta = std::sqrt(3.0 * kStop_mm * nu_mm2_s / speed_mm_s) / film::kThicknessQuantum_mm;
    return static_cast<std::int32_t>(std::min(std::ceil(quanta), film::kMaxThickness_quanta + 1.0));
}

/// ln(nu / kThinnest_m2_s) of the most viscous paint that goes on moving at that thickness.
float most_viscous(std::int32_t quanta, double speed_mm_s) {
    const double h_mm = film::thickness_mm(quanta);
    return static_cast<float>(
        core::natural_log(speed_mm_s * h_mm * h_mm / (3.0 * kStop_mm * kThinnest_mm2_s)));
}

bool is_no_stiffer(const film::PaintCell& paint, std::int32_t thickness, float log_viscosity) {
    constexpr auto kRatio = static_cast<float>(film::kThicknessQuantum_mm / film::kPaintQuantum);
    return static_cast<float>(paint[film::kViscosityChannel]) <=
           log_viscosity * kRatio * static_cast<float>(thickness);
}

/// u += s (tip - u) at the faces from every cell of `from` to the next along one axis.
template <class Share>
void drag_faces(const grid::Rect& from, float tip_mm_s, const Share& share,
                grid::TiledField<float>& velocity) {
    for (int y = from.y0; y < from.y1; ++y) {
        for (int x = from.x0; x < from.x1; ++x) {
            const float s = share(x, y);
            if (s <= 0.0F) continue;
            float& u = velocity.write(velocity.shape().tile_at(x, y))[grid::Shape::cell_in_tile(x, y)];
            u += s * (tip_mm_s - u);
        }
    }
}

}  // namespace

DragRates drag_rates(const Brush& brush, const ResolvedTip& tip, const HandPose& hand, double step_mm,
                     const film::Consistencies& paint) {
    const double share =
        brush.preset.exchange.momentum * (1.0 - std::exp(-step_mm / brush.tip.radius_mm));
    DragRates rates;
    rates.share = static_cast<float>(share) * tip.share;
    rates.velocity_x_mm_s = static_cast<float>(hand.speed_mm_s * hand.travel_x);
    rates.velocity_y_mm_s = static_cast<float>(hand.speed_mm_s * hand.travel_y);
    rates.speed_mm_s = std::hypot(rates.velocity_x_mm_s, rates.velocity_y_mm_s);
    rates.least_quanta =
        least_quanta(paint.uniform() ? paint.uniform()->log_viscosity : 0.0, rates.speed_mm_s);
    return rates;
}

void PaintDrag::Shares::set(int x, int y, float share, const grid::Rect& all) {
    if (!any) {
        cells = all;
        values.assign(static_cast<std::size_t>(all.width()) * static_cast<std::size_t>(all.height()),
                      0.0F);
        any = true;
    }
    at(x, y) = share;
}

void PaintDrag::compute_shares(const ExchangeRule& rule, const DragRates& rates, float log_viscosity,
                               const CellBatch& touched, const film::FilmState& film) {
    const bool alike = film.consistencies.uniform().has_value();
    for (const CellBatch::TilePart& part : touched.parts()) {
        if (film.thickness.is_background(part.tile)) continue;
        const std::int32_t* thickness = film.thickness.read(part.tile);
        const film::PaintCell* paint = film.paint.read(part.tile);
        const grid::Rect tile = film.shape.tile_cells(part.tile);
        for (int i = part.begin; i < part.end; ++i) {
            const std::int32_t cell = touched.cell[i];
            const std::uint8_t share = touched.share(part, i);
            if (thickness[cell] == 0 || share == 0) continue;
            if (!alike && !is_no_stiffer(paint[cell], thickness[cell], log_viscosity)) continue;
            shares_.set(tile.x0 + cell % grid::kTileSize, tile.y0 + cell / grid::kTileSize,
                        rates.share * touch_of(rule, touched, i) * grid::fraction_of(share),
                        touched.cells());
        }
    }
}

bool PaintDrag::find(const ExchangeRule& rule, const DragRates& rates, const CellBatch& touched,
                     const film::FilmState& film) {
    shares_.any = false;
    const std::int32_t quanta = rates.share > 0.0F ? thickest(touched) : 0;
    if (quanta >= rates.least_quanta)
        compute_shares(rule, rates, most_viscous(quanta, rates.speed_mm_s), touched, film);
    return shares_.any;
}

grid::Rect PaintDrag::apply(const DragRates& rates, film::FilmState& film) {
    const grid::Rect& cells = shares_.cells;
    const auto between = [&](int x, int y, int next_x, int next_y) {
        const float a = shares_.at(x, y), b = shares_.at(next_x, next_y);
        return a > 0.0F && b > 0.0F ? 0.5F * (a + b) : 0.0F;
    };
    drag_faces(
        {cells.x0, cells.y0, cells.x1 - 1, cells.y1}, rates.velocity_x_mm_s,
        [&](int x, int y) { return between(x, y, x + 1, y); }, film.velocity_x);
    drag_faces(
        {cells.x0, cells.y0, cells.x1, cells.y1 - 1}, rates.velocity_y_mm_s,
        [&](int x, int y) { return between(x, y, x, y + 1); }, film.velocity_y);
    return cells;
}

}  // namespace pastoso::brush
