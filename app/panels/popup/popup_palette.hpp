// Tools, paints, the brush's width and a few commands in rings around the pointer.
#pragma once

#include "panels/paint/swatch_grid.hpp"

#include <array>
#include <vector>

#include <QFrame>

class QAction;
class QLabel;

namespace pastoso::tools {
struct Hand;
}

namespace pastoso::panels {

class RoundButton;
class ThinningSlider;

class PopupPalette : public QFrame {
    Q_OBJECT
  public:
    /// Rings of so many tools and paints. `commands` become buttons.
    PopupPalette(int tools, int paints, const std::vector<QAction*>& commands, QWidget* parent);

    struct Content {
        std::vector<QString> tools;
        QString tool_in_hand;
        std::vector<SwatchGrid::Patch> paints;
        SwatchGrid::Patch paint, second_paint;
    };
    void show_content(const Content& content);
    void show_width(double width_mm);
    void show_thinning(const tools::Hand& hand);
    void set_thumbnail(const QString& tool, const QImage& image);

    /// Around that point of the desktop, as near as all of it is seen.
    void open_at(const QPoint& place);

    /// Diameter of the thumbnails, in pixels of the layout.
    static constexpr int kThumbnail = 54;

  Q_SIGNALS:
    void tool_chosen(const QString& name);
    void paint_chosen(int index);
    void paints_swapped();
    void width_stepped(int steps);
    void share_chosen(double share);  ///< of paint in the medium in hand

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    bool focusNextPrevChild(bool next) override;

  private:
    using Ring = std::vector<QWidget*>;

    void make_tools(int count);
    void make_paints(int count);
    void make_middle();
    void make_commands(const std::vector<QAction*>& actions);
    RoundButton* button(int diameter, const QPointF& place, const char* name);
    void step_in_ring(int steps);
    void step_ring(int steps);
    bool focus_on(const Ring& ring, std::size_t index);

    std::vector<RoundButton*> tools_, paints_;
    std::array<Ring, 4> rings_;   ///< tools, paints, the middle, commands
    std::vector<QString> names_;  ///< of the tools
    RoundButton* paint_ = nullptr;
    RoundButton* second_ = nullptr;
    QLabel* width_ = nullptr;
    ThinningSlider* thinning_ = nullptr;
};

}  // namespace pastoso::panels
