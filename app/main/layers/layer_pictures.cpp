#include "main/layers/layer_pictures.hpp"

#include "appearance/picture_view.hpp"
#include "panels/layers/layer_delegate.hpp"
#include "panels/layers/layer_panel.hpp"
#include "tools/layer_list.hpp"

#include <utility>

#include <QDockWidget>
#include <QMainWindow>

namespace pastoso::main {
namespace {

/// Pictures follow the paint when it had the time to change.
constexpr int kPicturesLater_ms = 400;

/// Whether two films show the same paint, as far as their tiles tell.
bool same_paint(const film::FilmState& a, const film::FilmState& b) {
    if (a.shape != b.shape) return false;
    for (int tile = 0; tile < a.thickness.tile_count(); ++tile) {
        const bool same = a.thickness.shares_tile(b.thickness, tile) &&
                          a.paint.shares_tile(b.paint, tile) &&
                          a.lower.paint.shares_tile(b.lower.paint, tile) &&
                          a.strata.optics.shares_tile(b.strata.optics, tile) &&
                          a.strata.soluble_thickness.shares_tile(b.strata.soluble_thickness, tile);
        if (!same) return false;
    }
    return true;
}

/// The film of a layer, by itself or on what lies below it.
std::shared_ptr<const film::FilmState> film_of(
    const document::Layer& layer, const std::shared_ptr<const document::Snapshot>& painting) {
    if (layer.inactive != nullptr) return layer.inactive;
    if (painting->active != nullptr) return painting->active;
    return {painting, &painting->film};
}

}  // namespace

LayerPictures::LayerPictures(Studio& studio, panels::LayerPanel* layers, QDockWidget* dock)
    : studio_(studio), layers_(layers) {
    const double pixels = studio_.window().devicePixelRatioF();
    const QSize size = panels::kLayerPicture * pixels;
    painter_ = std::make_unique<session::LayerPainter>(
        size.width(), size.height(),
        [layers, pixels](document::LayerId layer, const session::LayerPicture& picture) {
            QImage image = appearance::view_of_rgba(picture.rgba, picture.width, picture.height).copy();
            image.setDevicePixelRatio(pixels);
            QMetaObject::invokeMethod(layers, [layers, layer, image, wet = picture.wet] {
                layers->set_picture(layer, image, wet);
            });
        },
        studio_.teller());
    changed_.setSingleShot(true);
    changed_.setInterval(kPicturesLater_ms);
    connect(&changed_, &QTimer::timeout, this, &LayerPictures::want);
    connect(dock, &QDockWidget::visibilityChanged, &changed_, qOverload<>(&QTimer::start));
    connect(&studio_, &Studio::session_begun, this, &LayerPictures::forget);
    connect(&studio_, &Studio::published, this, [this] {
        if (!changed_.isActive()) changed_.start();
    });
}

/// Of layers whose paint has changed, while the hand rests and somebody sees the panel.
void LayerPictures::want() {
    if (!layers_->isVisible()) return;
    if (studio_.session().status().stroke_in_progress) return changed_.start();
    const auto painting = studio_.session().snapshot();
    std::erase_if(pictured_, [&](const auto& entry) {
        const document::LayerId id = entry.first;
        return tools::layers_in(*painting->layers, {{.layer = id}}).empty();
    });
    for (const document::Layer& layer : painting->layers->layers) {
        auto film = film_of(layer, painting);
        auto& pictured = pictured_[layer.id];
        if (pictured != nullptr && (pictured == film || same_paint(*pictured, *film))) continue;
        pictured = film;
        painter_->want(layer.id, std::move(film), painting->ground);
    }
}

void LayerPictures::forget() {
    pictured_.clear();
    layers_->forget_pictures();
}

}  // namespace pastoso::main
