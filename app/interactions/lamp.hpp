// A handle over the canvas by which the lamp is dragged.
#pragma once

#include "interactions/light_handle.hpp"
#include "view/canvas_view.hpp"

#include <optional>

#include <QObject>

class QPainter;

namespace pastoso::interactions {

class Lamp : public QObject, public view::Interaction {
    Q_OBJECT
  public:
    explicit Lamp(view::CanvasView& canvas) : canvas_(canvas) {}

    void show(bool shown);

    view::Took press(const input::PointerEvent& event) override;
    void drag(const input::PointerEvent& event) override;
    void release(const input::PointerEvent& /*event*/) override { cancel(); }
    void cancel() override { to_lamp_.reset(); }
    void draw(const view::Overlay& overlay) override;

  Q_SIGNALS:
    /// It moves where CanvasView::set_lighting() has it.
    void dragged(double elevation_deg, double azimuth_deg);

  private:
    void paint(QPainter& painter) const;
    LightDial dial() const;
    LightDirection direction() const;

    view::CanvasView& canvas_;
    bool shown_ = false;
    std::optional<glm::dvec2> to_lamp_;  ///< from the pointer, while it is dragged
};

}  // namespace pastoso::interactions
