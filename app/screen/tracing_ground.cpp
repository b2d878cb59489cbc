#include "screen/tracing_ground.hpp"

namespace pastoso::screen {

std::shared_ptr<const document::Snapshot> TracingGround::below(
    const std::shared_ptr<const document::Snapshot>& painting, const Tracing& tracing,
    core::ThreadPool& pool) {
    if (tracing == nullptr) return painting;
    lay(tracing, painting->film.shape, painting->film.cell_mm, pool);
    auto seen = std::make_shared<document::Snapshot>(*painting);
    seen->film = view_.of(painting->film, strata_, pool);
    return seen;
}

void TracingGround::lay(const Tracing& tracing, const grid::Shape& shape, double cell_mm,
                        core::ThreadPool& pool) {
    const bool same_place = laid_ != nullptr && cells_.shape() == shape &&
                            laid_->picture == tracing->picture && laid_->place == tracing->place;
    if (!same_place)
        cells_ = layers::picture_cells(*tracing->picture, tracing->place, shape, cell_mm, pool);
    if (!same_place || laid_->opacity != tracing->opacity)
        strata_ = layers::picture_strata(cells_, tracing->opacity, pool);
    laid_ = tracing;
}

}  // namespace pastoso::screen
