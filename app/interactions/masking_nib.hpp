// A press and a drag paint masking fluid or lay a strip of tape, as wide as the tool in hand, or peel
// what lies there.
#pragma once

#include "document/actions/masking_actions.hpp"
#include "interactions/area_drag.hpp"
#include "tools/easel.hpp"
#include "view/canvas_view.hpp"

#include <optional>

#include <QObject>
#include <glm/vec2.hpp>

namespace pastoso::interactions {

using document::MaskingForm;

class MaskingNib : public QObject, public view::Interaction {
    Q_OBJECT
  public:
    MaskingNib(view::CanvasView& canvas, const tools::Easel& easel) : canvas_(canvas), easel_(easel) {}

    /// Nothing: presses paint.
    void mask_next(std::optional<MaskingForm> form);

    view::Took press(const input::PointerEvent& event) override;
    /// Tape with Shift level, upright or halfway between.
    void drag(const input::PointerEvent& event) override;
    void release(const input::PointerEvent& event) override;
    void cancel() override;

    /// Escape gives up what is being laid, or else goes back to painting.
    bool key(const QKeyEvent& event) override;
    void draw(const view::Overlay& overlay) override;
    bool is_mode() const override { return form_.has_value(); }

  Q_SIGNALS:
    void begun(bool peels);
    void drawn(const document::MaskStripe& stripe);
    void cancelled();  ///< of tape none but a click, or not meant
    void left();       ///< painting goes on

  private:
    struct Tape {
        glm::dvec2 from_mm, to_mm;
    };

    std::vector<glm::dvec2> line_mm() const;
    bool is_laying() const { return fluid_.active() || tape_.has_value(); }
    void drop();
    void draw_laid(const view::Overlay& overlay) const;

    view::CanvasView& canvas_;
    const tools::Easel& easel_;
    std::optional<MaskingForm> form_;
    bool peels_ = false;  ///< what is being laid peels
    AreaDrag fluid_;      ///< its way, as that of a lasso
    std::optional<Tape> tape_;
};

}  // namespace pastoso::interactions
