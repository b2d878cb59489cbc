// Another colour for the dry paint of the layer that is painted on.
#pragma once

#include "dialogs/adjust_dialog.hpp"
#include "main/layers/active_part.hpp"
#include "main/studio.hpp"

#include <optional>

#include <QObject>
#include <QPointer>
#include <QTimer>

namespace pastoso::main {

class DryAdjusting : public QObject {
    Q_OBJECT
  public:
    explicit DryAdjusting(Studio& studio);

  private:
    void ask();
    bool asks() const;  ///< the dialog is open
    std::optional<tools::AdjustedColours> foretold(const layers::Adjustment& adjustment) const;
    void follow(const document::Snapshot& painting, const session::Status& status);
    void look_again();
    void adjust(const dialogs::ChosenAdjustment& chosen);

    Studio& studio_;
    dialogs::ChosenAdjustment chosen_;
    QPointer<dialogs::AdjustDialog> dialog_;
    ActivePart adjusted_;                       ///< by the dialog
    std::optional<tools::DryColours> colours_;  ///< of that, before
    QTimer changed_;
};

}  // namespace pastoso::main
