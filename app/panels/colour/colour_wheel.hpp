// A ring of hues with the lightness and chroma of the chosen hue inside it.
#pragma once

#include "tools/colour_models.hpp"

#include <QImage>
#include <QWidget>

namespace pastoso::panels {

/// Drag along the ring or in the field, up to where sRGB ends. Keys: arrows for chroma and lightness,
/// Page Up and Page Down for the hue, with Ctrl finely. Drawn pixel by pixel of the screen.
class ColourWheel : public QWidget {
    Q_OBJECT
  public:
    explicit ColourWheel(QWidget* parent = nullptr);

    const tools::Channels& oklch() const { return oklch_; }

    /// Without a signal. A grey keeps the hue that was shown.
    void show_colour(const tools::Channels& oklch);

    bool dragging() const { return drag_ != Drag::None; }

    /// Where a hue lies on the ring and a colour of the present hue in the field.
    QPointF ring_position(double hue_deg) const;
    QPointF field_position(double lightness, double chroma) const;

    QSize sizeHint() const override { return {176, 176}; }
    QSize minimumSizeHint() const override { return {160, 160}; }

  Q_SIGNALS:
    void moved(const tools::Channels& oklch);  ///< while it is being dragged, too
    void released();                           ///< the mouse let it go

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    enum class Drag { None, Ring, Field };

    /// In pixels of the screen, from the widget's corner.
    struct Measures {
        double ratio;  ///< pixels of the screen per unit of the window
        int left, top, side;
        double inner, outer;
        int field_left, field_top, field_side;
    };
    Measures measures() const;
    void drag_to(const QPointF& position);
    void move_to(tools::Channels oklch);
    void paint_boundary(QPainter& painter) const;
    void draw_pictures();

    tools::Channels oklch_{};
    Drag drag_ = Drag::None;
    double pressed_chroma_ = 0.0;  ///< comes back where the ring is dragged past a hue that has less
    QImage ring_, field_;
    double field_hue_deg_ = -1.0;
};

}  // namespace pastoso::panels
