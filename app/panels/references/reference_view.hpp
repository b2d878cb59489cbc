// The board of references under the hand: pictures are chosen, moved, scaled and turned on it, and their
// colours picked.
#pragma once

#include "document/actions/actions.hpp"
#include "panels/references/reference_pictures.hpp"
#include "pigment/hex_colour.hpp"

#include <optional>

#include <QPointF>
#include <QRectF>
#include <QTimer>
#include <QTransform>
#include <QWidget>

class QMimeData;
class QPainter;

namespace pastoso::panels {

class ReferenceView : public QWidget {
    Q_OBJECT
  public:
    explicit ReferenceView(QWidget* parent = nullptr);

    /// Shows the painting's.
    void show_board(const document::SharedReferences& board);

    /// As it is shown, with what the hand is about to change.
    const document::ReferenceBoard& board() const { return shown_; }

    /// Null: none is chosen.
    const document::Reference* chosen() const;
    void choose(document::ReferenceId reference);  ///< 0: none
    void choose_next();

    /// Shown at once, and said when it rests: every rest is a step that Undo returns to.
    void propose(const document::SetReference& set);
    /// Says at once what was proposed a moment ago.
    void finish();

    void remove_chosen();
    /// So many places up in the order, or down.
    void raise_chosen(int places);

    /// All of it, or a part, as large as there is room.
    void fit();
    void fit(const QRectF& part_mm);
    void zoom_about(const QPointF& position, double factor);

    /// The next click picks a colour, whatever else it would do.
    void pick_next(bool picks);
    /// The mean of a few pixels of the screen, as it is shown; none beside the pictures.
    std::optional<pigment::Srgb8> colour_at(const QPointF& position) const;

    QPointF board_mm(const QPointF& position) const { return to_widget().inverted().map(position); }
    QPointF widget_position(const QPointF& point_mm) const { return to_widget().map(point_mm); }

    ReferencePictures& pictures() { return pictures_; }

    QSize sizeHint() const override { return {260, 260}; }
    QSize minimumSizeHint() const override { return {160, 110}; }

  Q_SIGNALS:
    /// What the painting is asked to do.
    void acted(const pastoso::document::Action& action);
    void chosen_changed();  ///< another one, or it looks another way
    void colour_picked(const pastoso::pigment::Srgb8& colour);
    void dropped(const QMimeData& data, const QPointF& middle_mm);
    void paste_wanted();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    enum class Drag { None, View, Move, Corner, Turn };
    struct Gesture {
        Drag drag = Drag::None;
        std::size_t corner = 0;
        document::Reference before{};  ///< the chosen one when it began
        QPointF from, last;            ///< on the widget
    };

    QTransform to_widget() const;
    void put_together();
    void say_board();
    bool would_pick(Qt::KeyboardModifiers keys) const;  ///< the left button
    bool picks(const QMouseEvent& event) const;
    void begin_gesture(const QPointF& position);
    void pick(const QPointF& position);
    Gesture gesture_at(const QPointF& position) const;
    QCursor cursor_of(const Gesture& gesture) const;
    /// By what a press at that place does, or is doing.
    void show_cursor(const QPointF& position, bool picks);
    void move_view(const QPointF& distance);
    void drag_chosen(const QPointF& position, bool in_steps);
    void place_chosen(const document::ReferencePlace& place);
    void turn_chosen(double angle_deg);
    void scale_chosen(double factor);
    void move_by_key(const QPointF& direction, bool turns);
    void zoom_by_key(double factor);
    QPointF turn_handle(const document::Reference& reference) const;
    void draw(QPainter& painter, const document::Reference& reference);
    void draw_handles(QPainter& painter, const document::Reference& reference) const;

    document::SharedReferences board_;  ///< the painting's
    document::ReferenceBoard shown_;    ///< the same with what is proposed
    std::optional<document::SetReference> proposed_;
    bool is_said_ = true;
    document::ReferenceId chosen_ = 0;
    double zoom_ = 1.0;  ///< widget units of a millimetre
    QPointF corner_;     ///< of the board's 0, 0 on the widget
    bool fitted_ = true;
    bool pick_next_ = false, space_held_ = false;
    Gesture gesture_;
    QTimer resting_;
    ReferencePictures pictures_;
};

}  // namespace pastoso::panels
