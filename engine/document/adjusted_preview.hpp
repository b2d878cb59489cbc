// What a painting would look like with its dry paint adjusted, kept up with while it changes.
#pragma once

#include "core/thread_pool.hpp"
#include "document/painting.hpp"
#include "layers/adjusting.hpp"
#include "layers/apart.hpp"
#include "layers/view.hpp"

#include <memory>
#include <vector>

namespace pastoso::document {

struct WantedAdjustment {
    film::PaintCoefficients paint{};  ///< of which layers::can_lie_dry()
    layers::Adjustment way{};
    friend bool operator==(const WantedAdjustment&, const WantedAdjustment&) = default;
};

/// Which tiles are adjusted at once.
struct PreviewStep {
    grid::Rect around{};  ///< those nearest to the middle of these cells come first
    int most_tiles = 0;   ///< at least 1
};

/// Keeps what it adjusted, and adjusts anew only tiles whose paint has changed since.
class AdjustedPreview {
  public:
    /// A snapshot to be looked at, as AdjustDryPaint (actions/adjust_actions.hpp) would leave the
    /// painting: once it is complete(), the same bits of everything that is seen. Until then the other
    /// tiles are as they were adjusted before, or not at all where their paint is another one. The
    /// account of the films is the painting's.
    Snapshot of(const Snapshot& painting, const WantedAdjustment& wanted, const PreviewStep& step,
                core::ThreadPool& pool);

    /// Whether no tile of the last snapshot is left to be adjusted.
    bool complete() const;

  private:
    /// What all tiles depend on.
    struct Basis {
        std::shared_ptr<const LayerStack> layers;
        std::shared_ptr<const BareCanvas> bare;
        Selection selection;
        Masking masking;
        WantedAdjustment wanted;
        friend bool operator==(const Basis&, const Basis&) = default;
    };

    enum class Tile { Unadjusted, AdjustedOtherwise, Adjusted };

    void begin(const film::FilmState& film, const Basis& basis);
    void forget_changed(const film::FilmState& film);
    std::vector<int> tiles_to_adjust(const PreviewStep& step) const;
    void adjust(const film::FilmState& film, const std::vector<int>& tiles, core::ThreadPool& pool);
    film::FilmState with_adjusted_tiles(const film::FilmState& film) const;

    Basis basis_;
    film::SupportHeights base_mm_;  ///< what the active layer lies on
    Selection where_;
    film::FilmState before_, after_;  ///< the active layer on that, by tiles
    std::vector<Tile> tiles_;         ///< of `after_`
    layers::Lifter lifter_;
    layers::View view_;
};

}  // namespace pastoso::document
