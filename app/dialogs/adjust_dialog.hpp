// Asks how the colour of dry paint is to be adjusted, and whether that is previewed on the canvas; shows
// its mean before and after.
#pragma once

#include "dialogs/growing_dialog.hpp"
#include "layers/adjusting.hpp"
#include "tools/dry_colours.hpp"

#include <functional>
#include <optional>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;

namespace pastoso::dialogs {

/// What is chosen of each way, and which way it is.
struct ChosenAdjustment {
    enum class Way { Glaze, Exchange };
    Way way = Way::Glaze;
    layers::Glaze glaze{};
    layers::PaintExchange exchange{};
};

layers::Adjustment adjustment_of(const ChosenAdjustment& chosen);

class AdjustDialog : public GrowingDialog {
    Q_OBJECT
  public:
    /// What the paint in hand would do; nothing where it cannot lie dry.
    using Foretell =
        std::function<std::optional<tools::AdjustedColours>(const layers::Adjustment& adjustment)>;

    AdjustDialog(const ChosenAdjustment& proposal, bool previews, Foretell foretell,
                 QWidget* parent = nullptr);

    const ChosenAdjustment& chosen() const { return chosen_; }
    bool previews() const;

    /// Foretells anew: the paint in hand may be another one.
    void show_outcome();

  Q_SIGNALS:
    /// What is foretold may be another, or whether it is previewed.
    void changed();

  private:
    QDoubleSpinBox* add_number(const QString& name, const QString& words, const QString& unit,
                               double least, double most, double value);
    void add_swatches();
    void read();
    void show_way();

    ChosenAdjustment chosen_;
    Foretell foretell_;
    QFormLayout* form_ = nullptr;
    QComboBox* ways_ = nullptr;
    QLabel *meaning_ = nullptr, *before_ = nullptr, *after_ = nullptr, *problem_ = nullptr;
    QDoubleSpinBox *thickness_ = nullptr, *share_ = nullptr;
    QCheckBox* previews_ = nullptr;
    QDialogButtonBox* buttons_ = nullptr;
};

}  // namespace pastoso::dialogs
