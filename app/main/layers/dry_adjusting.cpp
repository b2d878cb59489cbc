#include "main/layers/dry_adjusting.hpp"

#include "document/actions/actions.hpp"
#include "document/layers.hpp"
#include "main/canvas/dialog_corner.hpp"
#include "main/paint/lent_paint.hpp"
#include "screen/window_pixels.hpp"
#include "tools/mixed_paints.hpp"

#include <cstdint>
#include <utility>

#include <QMainWindow>

namespace pastoso::main {
namespace {

/// What is foretold follows the paint when it had the time to change.
constexpr int kForetoldLater_ms = 400;

}  // namespace

DryAdjusting::DryAdjusting(Studio& studio)
    : studio_(studio),
      previewer_(
          [this](tools::DryPreviewer::Found found) {
              QMetaObject::invokeMethod(
                  this, [this, found = std::move(found)] { take(found); }, Qt::QueuedConnection);
          },
          studio.teller()) {
    studio_.commands().on(commands::Command::AdjustDryPaint, [this](bool) { ask(); });
    connect(&studio_, &Studio::published, this,
            [this](const auto& painting, const auto& status) { follow(*painting, status); });
    changed_.setSingleShot(true);
    changed_.setInterval(kForetoldLater_ms);
    connect(&changed_, &QTimer::timeout, this, [this] {
        looks_again_ = true;
        preview();
    });
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
    looks_again_ = false;
    ++asked_;
    dialog_ = new dialogs::AdjustDialog(
        chosen_, previews_,
        [this](const layers::Adjustment& adjustment) { return foretold(adjustment); },
        &studio_.window());
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    connect(&studio_, &Studio::hand_changed, dialog_, &dialogs::AdjustDialog::show_outcome);
    connect(&studio_, &Studio::session_ends, dialog_, &QDialog::reject);
    connect(dialog_, &dialogs::AdjustDialog::changed, this, &DryAdjusting::preview);
    connect(dialog_, &QDialog::accepted, this, [this] { adjust(dialog_->chosen()); });
    connect(dialog_, &QDialog::finished, this, [this] {
        studio_.canvas().preview_painting(nullptr);
        previewer_.forget();
    });
    show_in_corner(*dialog_, studio_.canvas());
    preview();
}

film::PaintCoefficients DryAdjusting::paint() const {
    const tools::Hand& hand = studio_.easel().hand();
    return tools::remembered_paint(hand.paint, document::medium_of(hand.medium));
}

std::optional<tools::AdjustedColours> DryAdjusting::foretold(
    const layers::Adjustment& adjustment) const {
    const film::PaintCoefficients in_hand = paint();
    if (!layers::can_lie_dry(in_hand)) return std::nullopt;
    return colours_->adjusted(in_hand, adjustment,
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
    if (status.replaying || active_part(painting) != adjusted_) return dialog_->reject();
    preview();
    if (!changed_.isActive()) changed_.start();
}

std::optional<document::WantedAdjustment> DryAdjusting::previewed() const {
    const film::PaintCoefficients in_hand = paint();
    if (!previews_ || !layers::can_lie_dry(in_hand)) return std::nullopt;
    return document::WantedAdjustment{in_hand, dialogs::adjustment_of(dialog_->chosen())};
}

/// The painting as it is stays on the canvas until there is something else to be seen.
void DryAdjusting::preview() {
    if (!asks()) return;
    previews_ = dialog_->previews();
    const auto wanted = previewed();
    const view::CanvasView& canvas = studio_.canvas();
    if (!wanted) studio_.canvas().preview_painting(nullptr);
    if (!wanted && !looks_again_) return;
    const auto painting = studio_.session().snapshot();
    const grid::Rect seen =
        screen::seen_cells(canvas.view_transform(), screen::window_px(canvas), painting->film.shape);
    previewer_.want({painting, wanted, seen, looks_again_, asked_});
}

void DryAdjusting::take(const tools::DryPreviewer::Found& found) {
    if (!asks() || found.number != asked_) return;
    if (found.preview != nullptr && previewed()) studio_.canvas().preview_painting(found.preview);
    if (found.colours) take_colours(*found.colours);
}

/// The paint may have dried, or been painted on or taken back.
void DryAdjusting::take_colours(const tools::DryColours& colours) {
    looks_again_ = false;
    if (!colours.any()) return dialog_->reject();
    colours_ = colours;
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
