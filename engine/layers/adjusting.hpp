// The dry paint of a layer adjusted in its colour: a coat that dries over it, or a share of it exchanged
// for another paint. Wet paint stays as it is.
#pragma once

#include "core/thread_pool.hpp"
#include "film/cell/paint_cell.hpp"
#include "film/state.hpp"
#include "grid/mask.hpp"

#include <cstdint>
#include <variant>

namespace pastoso::layers {

/// An even dry coat over what lies dry, none on bare canvas. It is laid as thick wet as leaves that
/// thickness d of the paint's solids f, h = d / f, and dries as film::become_stratum() has it: it covers
/// and seals what lies below, or, thinner than film::kBindingFilm_mm, can be dissolved again.
struct Glaze {
    double thickness_mm = 0.01;  ///< dry; rounded to film::kPaintQuantum, in which cells count solids
    friend bool operator==(const Glaze&, const Glaze&) = default;
};

/// A share s of the volume of what lies dry goes, and as much dry paint comes, of K / f and S / f per
/// mm: the thickness stays. Of a stratum that can be dissolved, by volume,
///     K_k h' = (1 - s) K_k h + s (K_k / f) h,   S_k h' likewise.
/// Of what is fixed only what it does to light is known. It becomes that of the layer into which a layer
/// of the new paint, as thick as all that is fixed there, is stirred to that share,
///     R' = F(R, N) + M - F(H, N),   T' and Q' likewise (pigment::stirred()).
/// A cell without thickness has nothing to exchange.
struct PaintExchange {
    double share = 0.5;  ///< 0 to 1
    friend bool operator==(const PaintExchange&, const PaintExchange&) = default;
};

using Adjustment = std::variant<Glaze, PaintExchange>;

/// Paint that leaves less than this share of itself when it dries cannot be laid dry.
inline constexpr float kLeastSolids = 0.01F;

/// The thickest coat: of the least solids it is wet below film::kMaxThickness_mm.
inline constexpr double kMostGlaze_mm = 0.1;

/// Whether enough is left of a paint when it has dried.
bool can_lie_dry(const film::PaintCoefficients& paint);

struct AdjustedLayer {
    film::FilmState film;
    /// Dry paint that came, and that went. What went of fixed paint is counted as share_fixed() counts
    /// (layers/cutting.hpp). As much thickness came as went in an exchange.
    film::DriedTotals added{}, removed{};
    std::int64_t evaporated = 0;  ///< quanta of what came, when it dried
};

/// The layer, apart from what it lies on, with that paint, of which can_lie_dry(), on its dry paint in
/// the cells of the mask, thinner or less of it by the share that is chosen of a cell; null: everywhere.
/// Its wet paint is shared with it.
AdjustedLayer adjusted(const film::FilmState& layer, const film::PaintCoefficients& paint,
                       const Adjustment& adjustment, const grid::Mask* where, core::ThreadPool& pool);

}  // namespace pastoso::layers
