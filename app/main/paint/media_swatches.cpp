#include "main/paint/media_swatches.hpp"

#include "appearance/picture_view.hpp"
#include "film/medium.hpp"
#include "panels/paint/medium_box.hpp"
#include "panels/paint/medium_panel.hpp"

#include <ranges>

#include <QMainWindow>

namespace pastoso::main {

MediaSwatches::MediaSwatches(Studio& studio, const PanelSet& panels)
    : studio_(studio), boxes_{panels.medium, panels.physics->media()} {
    for (const panels::MediumBox* box : boxes_)
        connect(box, &panels::MediumBox::swatches_wanted, this, &MediaSwatches::paint_all);
}

/// The latest asked for is painted first, so they are asked for from the last to the first.
void MediaSwatches::paint_all() {
    if (painter_ != nullptr) return;
    pixels_ = studio_.window().devicePixelRatioF();
    const QSize size = panels::kMediumSwatch * pixels_;
    painter_ = std::make_unique<session::ThumbnailPainter>(
        size.width(), size.height(),
        [this](const std::string& medium, const pigment::Image8& picture) { show(medium, picture); },
        studio_.teller());
    for (const film::Medium& medium : film::bundled_media() | std::views::reverse)
        painter_->want(medium);
}

/// On the painter's thread.
void MediaSwatches::show(const std::string& medium, const pigment::Image8& picture) {
    QImage image = appearance::view_of(picture).copy();
    image.setDevicePixelRatio(pixels_);
    for (panels::MediumBox* box : boxes_)
        QMetaObject::invokeMethod(
            box, [box, name = QString::fromStdString(medium), image] { box->set_swatch(name, image); });
}

}  // namespace pastoso::main
