#include "main/canvas/selection_margins.hpp"

#include "dialogs/length_dialog.hpp"
#include "main/canvas/dialog_corner.hpp"
#include "tools/selecting.hpp"

#include <QMainWindow>

namespace pastoso::main {
namespace {

using commands::Command;

dialogs::AskedLength asked_margin(const QString& title, const QString& explanation, const QString& name,
                                  const QString& button) {
    return {.title = title,
            .explanation = explanation,
            .name = name,
            .button = button,
            .least_mm = document::kLeastMargin_mm,
            .most_mm = document::kMostMargin_mm};
}

dialogs::AskedLength asked_width(const QString& title, const QString& explanation,
                                 const QString& button) {
    return asked_margin(title, explanation, SelectionMargins::tr("Width"), button);
}

/// Why a selection is not to be changed so; empty where it may be.
QString problem_of(const document::Selection& changed, const document::Selection& before) {
    if (changed == nullptr) return SelectionMargins::tr("Nothing would be left of the selection.");
    if (tools::are_same(changed, before))
        return SelectionMargins::tr("The selection would stay as it is.");
    return {};
}

}  // namespace

SelectionMargins::SelectionMargins(Studio& studio) : studio_(studio) {
    studio_.commands().on(Command::GrowSelection, [this](bool) {
        ask<document::GrowSelection>(asked_width(tr("Grow the selection"),
                                                 tr("The selection becomes so much wider on all sides."),
                                                 tr("Grow")));
    });
    studio_.commands().on(Command::ShrinkSelection, [this](bool) {
        ask<document::ShrinkSelection>(asked_width(tr("Shrink the selection"),
                                                   tr("The selection becomes so much narrower on all "
                                                      "sides, but not along the edges of the canvas."),
                                                   tr("Shrink")));
    });
    studio_.commands().on(Command::BorderSelection, [this](bool) {
        ask<document::BorderSelection>(asked_width(
            tr("Border of the selection"),
            tr("Selects a band so wide along the outline, half of it on either side."), tr("Select")));
    });
    studio_.commands().on(Command::FeatherSelection, [this](bool) {
        ask<document::FeatherSelection>(asked_margin(
            tr("Feather the selection"),
            tr("The edge becomes soft: paint fades out so far on either side of the outline."),
            tr("Radius"), tr("Feather")));
    });
}

template <class Margin>
void SelectionMargins::ask(const dialogs::AskedLength& asked) {
    delete dialog_;
    dialogs::AskedLength with_proposal = asked;
    with_proposal.proposal_mm = width_mm_;
    dialog_ = new dialogs::MarginDialog(with_proposal, &studio_.window());
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog_, &dialogs::MarginDialog::changed, this, [this] { preview<Margin>(); });
    connect(dialog_, &QDialog::accepted, this, [this] {
        width_mm_ = dialog_->chosen_mm();
        studio_.easel().select(Margin{width_mm_});
    });
    connect(dialog_, &QDialog::finished, this,
            [this] { studio_.canvas().preview_selection(std::nullopt); });
    show_in_corner(*dialog_, studio_.canvas());
    preview<Margin>();
}

template <class Margin>
void SelectionMargins::preview() {
    const auto painting = studio_.session().snapshot();
    const document::Selection changed =
        document::changed_by(Margin{dialog_->chosen_mm()}, painting->selection, painting->film.cell_mm);
    dialog_->show_problem(problem_of(changed, painting->selection));
    studio_.canvas().preview_selection(changed);
}

}  // namespace pastoso::main
