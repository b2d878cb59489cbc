#include "screen/canvas_presenter.hpp"

#include "core/check.hpp"
#include "screen/qt_rect.hpp"

#include <numeric>
#include <utility>

namespace pastoso::screen {

CanvasPresenter::CanvasPresenter(std::function<void()> ready)
    : ready_(std::move(ready)),
      worker_([this](Job& job) { present(job); },
              [this](Job& job, const core::Message& fault) {
                  made_.reset();
                  Presentation failed;
                  failed.sight = job.sight;
                  failed.fault = fault;
                  hand_over(std::move(failed));
              }) {}

void CanvasPresenter::make(Sight sight, bool begins, const grid::Rect& outlined) {
    PASTOSO_CHECK(!busy_);
    busy_ = true;
    worker_.add({std::move(sight), begins, outlined});
}

std::optional<Presentation> CanvasPresenter::take(std::chrono::microseconds patience) {
    if (!busy_) return std::nullopt;
    std::unique_lock lock(mutex_);
    is_made_.wait_for(lock, patience, [this] { return made_presentation_.has_value(); });
    if (made_presentation_) busy_ = false;
    return std::exchange(made_presentation_, std::nullopt);
}

void CanvasPresenter::hand_over(Presentation presentation) {
    {
        const std::lock_guard lock(mutex_);
        made_presentation_ = std::move(presentation);
    }
    is_made_.notify_one();
    ready_();
}

void CanvasPresenter::present(const Job& job) {
    if (job.begins) made_.reset();
    Presentation next;
    next.sight = job.sight;
    next.begins = !made_;
    next.outlined = job.outlined;
    next.seen = ground_.below(job.sight.painting, job.sight.tracing, pool_);
    add_relief(next);
    add_colours(next);
    add_look(next);
    add_outlines(next);
    made_ = job.sight;
    made_seen_ = next.seen;
    hand_over(std::move(next));
}

/// Heights, sky and shadows.
void CanvasPresenter::add_relief(Presentation& next) {
    const Sight& sight = next.sight;
    LayerChanges changes = layers_.update(made_ ? made_seen_.get() : nullptr, *next.seen, sight.lighting,
                                          pool_, sight.viewing.to_rgb);
    const bool same_shadows = !made_ || (sight.lighting.azimuth_deg == made_->lighting.azimuth_deg &&
                                         sight.lighting.elevation_deg == made_->lighting.elevation_deg);
    if (!same_shadows) {
        layers_.relight(*next.seen, sight.lighting, pool_);
        changes.surface = qt_rect(layers_.cells_with_border());
    }
    next.surface = layers_.patches(changes.surface);
    next.tiles = std::move(changes.tiles);
    next.colours = std::move(changes.colours);
}

void CanvasPresenter::add_colours(Presentation& next) {
    const pigment::Viewing& viewing = next.sight.viewing;
    next.recoloured = made_ && viewing.to_rgb != made_->viewing.to_rgb;
    if (next.recoloured) next.colours = CanvasLayers::recolour(*next.seen, viewing.to_rgb, pool_);
}

void CanvasPresenter::add_look(Presentation& next) {
    const Look look = next.sight.look;
    if (!needs_thickness(look)) return;
    std::vector<int> tiles = next.tiles;
    if (!made_ || look != made_->look) {
        tiles.resize(static_cast<std::size_t>(next.seen->film.shape.tile_count()));
        std::iota(tiles.begin(), tiles.end(), 0);
    }
    next.look = look_patches(*next.seen, look, tiles, pool_);
}

void CanvasPresenter::add_outlines(Presentation& next) {
    if (next.begins)
        outlines_.reset(next.seen->film.shape);
    else if (next.recoloured)
        outlines_.forget_all();
    else
        outlines_.forget(next.tiles);
    if (next.outlined.empty()) return;
    next.outlines = outlines_.update(*next.seen, next.outlined, next.sight.viewing.to_rgb, pool_);
}

}  // namespace pastoso::screen
