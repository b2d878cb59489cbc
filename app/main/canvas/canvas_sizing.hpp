// The canvas on the easel: shown as it is, cut, made larger and turned, and what follows it.
#pragma once

#include "main/files/loading.hpp"
#include "main/studio.hpp"

#include <memory>
#include <optional>

#include <QObject>

namespace pastoso::panels {
class StatusReadings;
}

namespace pastoso::main {

/// While a recording is played the canvas is not the painter's, and this says so.
bool is_canvas_lent(Studio& studio);

class CanvasSizing : public QObject {
    Q_OBJECT
  public:
    CanvasSizing(Studio& studio, Loading& loading, panels::StatusReadings* readings);

    /// Begins to make the canvas that is wished for, beside the window; it is put up once it is there,
    /// with what was painted meanwhile.
    void ask_for_scale();
    void resize(const document::ResizeCanvas& resize);

  Q_SIGNALS:
    void resized();

  private:
    void ask();
    void crop_to_selection();
    void turn(const core::Orientation& turn);
    void ask_for_rotation();
    void put_up(const document::ResizedCanvas& canvas);
    std::optional<glm::dvec2> follow(std::shared_ptr<const document::BareCanvas> bare);

    Studio& studio_;
    Loading& loading_;
    panels::StatusReadings* readings_;
    std::shared_ptr<const document::BareCanvas> shown_bare_;  ///< of this painting; null at first
};

}  // namespace pastoso::main
