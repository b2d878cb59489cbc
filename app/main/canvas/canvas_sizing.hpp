// The canvas on the easel: shown as it is, cut and made larger, and what follows it.
#pragma once

#include "main/studio.hpp"

#include <memory>
#include <optional>

#include <QObject>

namespace pastoso::panels {
class StatusReadings;
}

namespace pastoso::main {

class CanvasSizing : public QObject {
    Q_OBJECT
  public:
    CanvasSizing(Studio& studio, panels::StatusReadings* readings);

  Q_SIGNALS:
    void resized();

  private:
    void ask();
    bool is_lent();
    void crop_to_selection();
    void resize(const document::ResizeCanvas& resize);
    std::optional<glm::dvec2> follow(std::shared_ptr<const document::BareCanvas> bare);

    Studio& studio_;
    panels::StatusReadings* readings_;
    std::shared_ptr<const document::BareCanvas> shown_bare_;  ///< of this painting; null at first
};

}  // namespace pastoso::main
