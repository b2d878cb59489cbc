#include "main/canvas/navigation.hpp"

#include "appearance/picture_view.hpp"
#include "panels/canvas/navigator_map.hpp"
#include "panels/canvas/navigator_panel.hpp"

#include <cmath>
#include <utility>

#include <QDockWidget>
#include <QMainWindow>

namespace pastoso::main {
namespace {

constexpr int kPictureLater_ms = 250;
constexpr double kZoomPerNotch = 1.25;

/// Of the picture, whatever the size of the panel.
constexpr QSize kMostPicture(320, 320);

}  // namespace

Navigation::Navigation(Studio& studio, panels::NavigatorPanel* panel, QDockWidget* dock)
    : studio_(studio), panel_(panel) {
    const QSize size = kMostPicture * studio_.window().devicePixelRatioF();
    painter_ = std::make_unique<session::OverviewPainter>(
        size.width(), size.height(),
        [panel](const pigment::Image8& picture) {
            QMetaObject::invokeMethod(panel, [panel, image = appearance::view_of(picture).copy()] {
                panel->map().show_picture(image);
            });
        },
        studio_.teller());
    changed_.setSingleShot(true);
    changed_.setInterval(kPictureLater_ms);
    view::CanvasView& canvas = studio_.canvas();
    connect(&changed_, &QTimer::timeout, this, &Navigation::want_picture);
    connect(dock, &QDockWidget::visibilityChanged, this, [this] {
        show_view();
        changed_.start();
    });
    const auto follow = [this] {
        if (!changed_.isActive()) changed_.start();
    };
    connect(&studio_, &Studio::published, this, follow);
    connect(&canvas, &view::CanvasView::viewing_changed, this, follow);
    connect(&canvas, &view::CanvasView::view_changed, this, &Navigation::show_view);
    connect(&panel_->map(), &panels::NavigatorMap::centre_wanted, this, [&canvas](const QPointF& share) {
        canvas.show_at_centre(canvas.canvas_size_mm() * glm::dvec2(share.x(), share.y()));
    });
    connect(&panel_->map(), &panels::NavigatorMap::zoomed, this,
            [&canvas](double notches) { canvas.zoom_about_centre(std::pow(kZoomPerNotch, notches)); });
    connect(panel_, &panels::NavigatorPanel::zoom_chosen, this,
            [&canvas](double zoom) { canvas.zoom_about_centre(zoom / canvas.view_transform().zoom); });
    connect(panel_, &panels::NavigatorPanel::angle_chosen, this, [&canvas](double angle_deg) {
        canvas.turn_about_centre(angle_deg - canvas.view_transform().angle_deg);
    });
}

void Navigation::show_view() {
    if (!panel_->isVisible()) return;
    const view::CanvasView& canvas = studio_.canvas();
    const screen::ViewTransform& view = canvas.view_transform();
    panel_->show_view(view.zoom, view.angle_deg);
    const glm::dvec2 size_mm = canvas.canvas_size_mm();
    if (size_mm == glm::dvec2(0.0)) return;
    const QPointF corners[] = {{0.0, 0.0},
                               {1.0 * canvas.width(), 0.0},
                               {1.0 * canvas.width(), 1.0 * canvas.height()},
                               {0.0, 1.0 * canvas.height()}};
    QPolygonF frame;
    for (const QPointF& corner : corners) {
        const glm::dvec2 share = canvas.canvas_mm(corner) / size_mm;
        frame.append({share.x, share.y});
    }
    panel_->map().show_frame({size_mm.x, size_mm.y}, frame);
}

/// Where somebody sees it, and there is something new in it.
void Navigation::want_picture() {
    if (!panel_->isVisible()) return;
    show_view();
    auto painting = studio_.session().snapshot();
    const pigment::Viewing& viewing = studio_.canvas().viewing();
    const bool same_canvas = pictured_ != nullptr && pictured_->film.shape == painting->film.shape;
    auto tiles = screen::changed_tiles(same_canvas ? pictured_.get() : nullptr, *painting);
    const bool new_light = viewing != viewing_;
    pictured_ = painting;
    if (tiles.empty() && !new_light) return;
    viewing_ = viewing;
    painter_->want({{painting, &painting->film}, painting->ground, viewing, std::move(tiles)});
}

}  // namespace pastoso::main
