// A ring of hues with the lightness and chroma of the chosen hue inside it.
#pragma once

#include "tools/colour_aids.hpp"

#include <cstddef>
#include <optional>
#include <vector>

#include <QImage>
#include <QWidget>

namespace pastoso::panels {

/// Drag along the ring or in the field, up to where sRGB ends. With a gamut mask all colours of the
/// present lightness are on a disc in the field's place, and what is chosen is held to the mask, whose
/// corners can be dragged. Marks
/// on the ring, which a click takes, are the hues of a harmony. Keys: arrows for chroma and lightness,
/// Page Up and Page Down for the hue, with Ctrl finely. Drawn pixel by pixel of the screen.
class ColourWheel : public QWidget {
    Q_OBJECT
  public:
    explicit ColourWheel(QWidget* parent = nullptr);

    const tools::Channels& oklch() const { return oklch_; }

    /// Without a signal. A grey keeps the hue that was shown.
    void show_colour(const tools::Channels& oklch);

    /// The colour stays until it is moved.
    void show_aids(const tools::ColourAids& aids);

    bool dragging() const { return drag_ != Drag::None; }

    /// Where a hue lies on the ring and a colour of the present hue in the field.
    QPointF ring_position(double hue_deg) const;
    QPointF field_position(double lightness, double chroma) const;
    /// Where a place of the disc (tools::disc_place()) lies.
    QPointF disc_position(const glm::dvec2& place) const;

    QSize sizeHint() const override { return {176, 176}; }
    QSize minimumSizeHint() const override { return {160, 160}; }

  Q_SIGNALS:
    void moved(const tools::Channels& oklch);  ///< while it is being dragged, too
    void released();                           ///< the mouse let it go
    void mask_moved(const tools::GamutMask& mask);  ///< a corner of it was dragged, and let go

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    enum class Drag { None, Ring, Field, Disc, Mark, Corner };

    /// In pixels of the screen, from the widget's corner.
    struct Measures {
        double ratio;  ///< pixels of the screen per unit of the window
        int left, top, side;
        double inner, outer;
        int field_left, field_top, field_side;
        double disc;  ///< its radius
    };
    Measures measures() const;
    Drag place_of(const QPointF& position) const;
    const double* mark_at(const QPointF& position) const;
    std::optional<std::size_t> corner_at(const QPointF& position) const;
    void move_corner(const glm::dvec2& place);
    void drag_to(const QPointF& position);
    void move_to(tools::Channels oklch);
    void turn_harmony(double hue_deg);
    bool has_mask() const { return aids_.mask.shape != tools::MaskShape::None; }
    void paint_field(QPainter& painter) const;
    void paint_boundary(QPainter& painter) const;
    void paint_disc(QPainter& painter) const;
    void draw_pictures();

    tools::Channels oklch_{};
    Drag drag_ = Drag::None;
    double pressed_chroma_ = 0.0;  ///< comes back where the ring is dragged past a hue that has less
    std::size_t corner_ = 0;       ///< that is dragged
    tools::ColourAids aids_;
    double harmony_deg_ = 0.0;       ///< the hue that the harmony is of; a click on a mark leaves it
    std::vector<double> marks_deg_;  ///< the hues that go with it
    QImage ring_, field_, disc_;
    double field_hue_deg_ = -1.0, disc_lightness_ = -1.0;
};

}  // namespace pastoso::panels
