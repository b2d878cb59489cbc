// A press selects what has nearly the colour that is seen there.
#pragma once

#include "document/actions/selection_actions.hpp"
#include "view/canvas_view.hpp"

#include <optional>

#include <QObject>

namespace pastoso::interactions {

enum class WandReach { Connected, Everywhere };

class ColourWand : public QObject, public view::Interaction {
    Q_OBJECT
  public:
    explicit ColourWand(view::CanvasView& canvas) : canvas_(canvas) {}

    /// Nothing: presses paint.
    void take(std::optional<WandReach> reach);

    view::Took press(const input::PointerEvent& event) override;
    /// To the right for colours that differ more, to the left for less; it stays so for the next press.
    void drag(const input::PointerEvent& event) override;
    void release(const input::PointerEvent& event) override;
    void cancel() override;

    /// Escape gives up a drag, or else goes back to painting.
    bool key(const QKeyEvent& event) override;
    std::optional<QCursor> cursor() const override;
    bool is_mode() const override { return reach_.has_value(); }

  Q_SIGNALS:
    /// During a press: what is going to be selected.
    void pulled(const document::SelectSimilarColour& colour);
    void chosen(const document::SelectSimilarColour& colour);
    void cancelled();
    void left();  ///< painting goes on

  private:
    view::CanvasView& canvas_;
    std::optional<WandReach> reach_;
    std::optional<document::SelectSimilarColour> pressed_;
    QPointF pressed_at_;   ///< on the view
    double before_ = 0.0;  ///< the difference when the press came
    double difference_ = document::SelectSimilarColour{}.difference;
};

}  // namespace pastoso::interactions
