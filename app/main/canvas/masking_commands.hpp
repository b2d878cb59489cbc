// Masking fluid and tape: painted and laid on the canvas, and peeled off.
#pragma once

#include "main/studio.hpp"

#include <optional>

#include <QObject>

namespace pastoso::panels {
class BrushPanel;
}

namespace pastoso::main {

class MaskingCommands : public QObject {
    Q_OBJECT
  public:
    /// Taking a tool of `brushes` ends the masking.
    MaskingCommands(Studio& studio, panels::BrushPanel* brushes);

    void go_back_to_painting() { mask_with(std::nullopt); }

  Q_SIGNALS:
    void masking_begins();  ///< a press masks from now on, and does nothing else

  private:
    void listen_to_nib();
    void mask_with(std::optional<interactions::MaskingForm> form);
    void show(const document::Snapshot& painting);
    void enable();

    Studio& studio_;
    std::optional<interactions::MaskingForm> form_;  ///< none: a press paints
    bool any_masked_ = false, any_selected_ = false;
};

}  // namespace pastoso::main
