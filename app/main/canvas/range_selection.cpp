#include "main/canvas/range_selection.hpp"

#include "appearance/shown_number.hpp"
#include "dialogs/select_range_dialog.hpp"
#include "main/canvas/dialog_corner.hpp"
#include "tools/selecting.hpp"

#include <cmath>
#include <utility>

#include <QMainWindow>
#include <QTimer>

namespace pastoso::main {
namespace {

using commands::Command;

/// So often an open dialog looks at paint that moves.
constexpr int kLook_ms = 400;

/// Thinner paint is no more than a stain.
constexpr double kLeastWet_mm = 0.005;

/// Paint that stands higher than most, or all that is wet. Of a bare canvas, what thick paint will be.
dialogs::SelectedRange first_range(bool wetness, const tools::PaintDepths& depths) {
    constexpr double kFine_mm = 0.01;
    if (depths.most_mm == 0.0) return {.least_mm = wetness ? kLeastWet_mm : 0.5, .most_mm = 10.0};
    return {.least_mm = wetness ? kLeastWet_mm : kFine_mm * std::round(depths.mean_mm / kFine_mm),
            .most_mm = kFine_mm * std::ceil(depths.most_mm / kFine_mm)};
}

/// Whether the same range holds the same cells of both.
bool looks_alike(const document::Snapshot& a, const document::Snapshot& b) {
    return a.film.shape == b.film.shape && a.selection == b.selection && a.layers == b.layers &&
           screen::changed_tiles(&a, b).empty();
}

template <class Select>
Select range_action(const dialogs::SelectedRange& range) {
    return {range.least_mm, range.most_mm, range.how};
}

}  // namespace

RangeSelection::RangeSelection(Studio& studio) : studio_(studio) {
    studio_.commands().on(Command::SelectHeight, [this](bool) { ask(false); });
    studio_.commands().on(Command::SelectWetness, [this](bool) { ask(true); });
}

void RangeSelection::ask(bool wetness) {
    delete dialog_;
    const auto painting = studio_.session().snapshot();
    const tools::PaintDepths depths =
        wetness ? tools::wetness_on(*painting) : tools::heights_on(*painting);
    const QString words =
        wetness ? tr("Wet paint of this layer is up to %1 mm thick, %2 mm on average.")
                : tr("Paint, wet and dry, stands up to %1 mm above the canvas, %2 mm on average.");
    dialog_ = new dialogs::SelectRangeDialog(wetness ? tr("Select by wetness") : tr("Select by height"),
                                             words.arg(appearance::shown_number(depths.most_mm, 2))
                                                 .arg(appearance::shown_number(depths.mean_mm, 2)),
                                             first_range(wetness, depths), &studio_.window());
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog_, &dialogs::SelectRangeDialog::changed, this, [=, this] { preview(wetness); });
    connect(dialog_, &QDialog::accepted, this, [=, this] {
        const dialogs::SelectedRange range = dialog_->chosen();
        studio_.easel().select(wetness
                                   ? document::Action(range_action<document::SelectByWetness>(range))
                                   : document::Action(range_action<document::SelectByHeight>(range)));
    });
    connect(dialog_, &QDialog::finished, this,
            [this] { studio_.canvas().preview_selection(std::nullopt); });
    auto* looks = new QTimer(dialog_);
    connect(looks, &QTimer::timeout, this, [=, this, seen = painting]() mutable {
        const auto now = studio_.session().snapshot();
        if (looks_alike(*std::exchange(seen, now), *now)) return;
        preview(wetness);
    });
    looks->start(kLook_ms);
    show_in_corner(*dialog_, studio_.canvas());
    preview(wetness);
}

void RangeSelection::preview(bool wetness) {
    const dialogs::SelectedRange range = dialog_->chosen();
    const auto painting = studio_.session().snapshot();
    const document::Selection selection =
        wetness ? tools::selection_after(*painting, range_action<document::SelectByWetness>(range))
                : tools::selection_after(*painting, range_action<document::SelectByHeight>(range));
    studio_.canvas().preview_selection(selection);
    dialog_->show_outcome(tools::selected_share(selection), selection == nullptr);
}

}  // namespace pastoso::main
