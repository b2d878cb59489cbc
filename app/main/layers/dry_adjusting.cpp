#include "main/layers/dry_adjusting.hpp"

#include "document/actions/actions.hpp"
#include "document/layers.hpp"
#include "tools/mixed_paints.hpp"

#include <memory>
#include <optional>
#include <utility>

#include <QMainWindow>

namespace pastoso::main {
namespace {

using SharedColours = std::shared_ptr<const tools::DryColours>;

dialogs::AdjustDialog::Foretell foretelling(const Studio& studio, SharedColours colours) {
    return [&studio, colours = std::move(colours)](const layers::Adjustment& adjustment) {
        const tools::Hand& hand = studio.easel().hand();
        const film::PaintCoefficients paint =
            tools::remembered_paint(hand.paint, document::medium_of(hand.medium));
        std::optional<tools::AdjustedColours> found;
        if (layers::can_lie_dry(paint))
            found = colours->adjusted(paint, adjustment,
                                      {.ground = studio.session().snapshot()->ground,
                                       .lighting = studio.canvas().lighting(),
                                       .viewing = studio.canvas().viewing()});
        return found;
    };
}

}  // namespace

DryAdjusting::DryAdjusting(Studio& studio) : studio_(studio) {
    studio_.commands().on(commands::Command::AdjustDryPaint, [this](bool) { ask(); });
}

void DryAdjusting::ask() {
    if (is_lent()) return;
    studio_.catch_up();
    const auto painting = studio_.session().snapshot();
    if (!studio_.attempt(
            [&] { document::check_paintable(*painting->layers, painting->layers->active); }))
        return;
    const auto colours = std::make_shared<const tools::DryColours>(*painting);
    if (!colours->any())
        return studio_.report(
            painting->selection == nullptr
                ? tr("The layer that you paint on has no dry paint.")
                : tr("The layer that you paint on has no dry paint where it is selected."));
    auto* dialog = new dialogs::AdjustDialog(chosen_, foretelling(studio_, colours), &studio_.window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(&studio_, &Studio::hand_changed, dialog, &dialogs::AdjustDialog::show_outcome);
    connect(&studio_, &Studio::session_ends, dialog, &QDialog::reject);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { adjust(dialog->chosen()); });
    dialog->show();
}

/// A recording may have begun to be played since the dialog was opened.
void DryAdjusting::adjust(const dialogs::ChosenAdjustment& chosen) {
    chosen_ = chosen;
    if (is_lent()) return;
    studio_.easel().adjust_dry_paint({studio_.easel().hand().paint, dialogs::adjustment_of(chosen)});
    studio_.report(chosen.way == dialogs::ChosenAdjustment::Way::Glaze
                       ? tr("The glaze lies over the dry paint.")
                       : tr("The dry paint has other pigments in it."));
}

bool DryAdjusting::is_lent() {
    if (!studio_.easel().brush_is_lent()) return false;
    studio_.report(tr("A recording is being played; the paint is yours when it has ended."));
    return true;
}

}  // namespace pastoso::main
