// Another colour for the dry paint of the layer that is painted on.
#pragma once

#include "dialogs/adjust_dialog.hpp"
#include "main/layers/active_part.hpp"
#include "main/studio.hpp"
#include "tools/dry_previewer.hpp"

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
    film::PaintCoefficients paint() const;  ///< in hand
    std::optional<tools::AdjustedColours> foretold(const layers::Adjustment& adjustment) const;
    std::optional<document::WantedAdjustment> previewed() const;  ///< none: nothing is
    void follow(const document::Snapshot& painting, const session::Status& status);
    void preview();
    void take(const tools::DryPreviewer::Found& found);
    void take_colours(const tools::DryColours& colours);
    void adjust(const dialogs::ChosenAdjustment& chosen);

    Studio& studio_;
    dialogs::ChosenAdjustment chosen_;
    QPointer<dialogs::AdjustDialog> dialog_;
    ActivePart adjusted_;                       ///< by the dialog
    std::optional<tools::DryColours> colours_;  ///< of that, before
    QTimer changed_;
    bool previews_ = true;      ///< as it was chosen last
    bool looks_again_ = false;  ///< at the colours, which may be others
    int asked_ = 0;             ///< how often the dialog was opened
    tools::DryPreviewer previewer_;
};

}  // namespace pastoso::main
