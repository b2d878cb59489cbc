#include "main/layers/dry_adjusting.hpp"

#include "document/actions/actions.hpp"
#include "document/layers.hpp"
#include "main/paint/lent_paint.hpp"
#include "tools/mixed_paints.hpp"

#include <cstdint>
#include <utility>

#include <QMainWindow>

namespace pastoso::main {
namespace {

/// What is foretold follows the paint when it had the time to change.
constexpr int kForetoldLater_ms = 400;

}  // namespace

DryAdjusting::DryAdjusting(Studio& studio) : studio_(studio) {
    studio_.commands().on(commands::Command::AdjustDryPaint, [this](bool) { ask(); });
    connect(&studio_, &Studio::published, this,
            [this](const auto& painting, const auto& status) { follow(*painting, status); });
    changed_.setSingleShot(true);
    changed_.setInterval(kForetoldLater_ms);
    connect(&changed_, &QTimer::timeout, this, &DryAdjusting::look_again);
}

void DryAdjusting::ask() {
    if (paint_is_lent(studio_)) return;
    studio_.catch_up();
    const auto painting = studio_.session().snapshot();
    if (!studio_.attempt(
            [&] { document::check_paintable(*painting->layers, painting->layers->active); }))
        return;
    tools::DryColours colours(*painting);
    if (!colours.any())
        return studio_.report(
            painting->selection == nullptr
                ? tr("The layer that you paint on has no dry paint.")
                : tr("The layer that you paint on has no dry paint where it is selected."));
    delete dialog_;
    colours_ = std::move(colours);
    adjusted_ = active_part(*painting);
    dialog_ = new dialogs::AdjustDialog(
        chosen_, [this](const layers::Adjustment& adjustment) { return foretold(adjustment); },
        &studio_.window());
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    connect(&studio_, &Studio::hand_changed, dialog_, &dialogs::AdjustDialog::show_outcome);
    connect(&studio_, &Studio::session_ends, dialog_, &QDialog::reject);
    connect(dialog_, &QDialog::accepted, this, [this] { adjust(dialog_->chosen()); });
    dialog_->show();
}

std::optional<tools::AdjustedColours> DryAdjusting::foretold(
    const layers::Adjustment& adjustment) const {
    const tools::Hand& hand = studio_.easel().hand();
    const film::PaintCoefficients paint =
        tools::remembered_paint(hand.paint, document::medium_of(hand.medium));
    if (!layers::can_lie_dry(paint)) return std::nullopt;
    return colours_->adjusted(paint, adjustment,
                              {.ground = studio_.session().snapshot()->ground,
                               .lighting = studio_.canvas().lighting(),
                               .viewing = studio_.canvas().viewing()});
}

bool DryAdjusting::asks() const {
    return dialog_ != nullptr && dialog_->isVisible();
}

/// Paint of another layer, of what is selected no more, or masked, or of another canvas is not what was
/// asked about.
void DryAdjusting::follow(const document::Snapshot& painting, const session::Status& status) {
    if (!asks()) return;
    if (status.replaying || active_part(painting) != adjusted_)
        dialog_->reject();
    else if (!changed_.isActive())
        changed_.start();
}

/// It may have dried, or been painted on or taken back.
void DryAdjusting::look_again() {
    if (!asks()) return;
    tools::DryColours colours(*studio_.session().snapshot());
    if (!colours.any()) return dialog_->reject();
    colours_ = std::move(colours);
    dialog_->show_outcome();
}

/// A recording may have begun to be played since the dialog was opened. Of what is refused the session
/// says why.
void DryAdjusting::adjust(const dialogs::ChosenAdjustment& chosen) {
    chosen_ = chosen;
    if (paint_is_lent(studio_)) return;
    studio_.catch_up();
    const std::int64_t changes = studio_.session().status().changes;
    studio_.easel().adjust_dry_paint({studio_.easel().hand().paint, dialogs::adjustment_of(chosen)});
    studio_.catch_up();
    if (studio_.session().status().changes == changes) return;
    studio_.report(chosen.way == dialogs::ChosenAdjustment::Way::Glaze
                       ? tr("The glaze lies over the dry paint.")
                       : tr("The dry paint has other pigments in it."));
}

}  // namespace pastoso::main
