#include "main/canvas/masking_commands.hpp"

#include "panels/pen/brush_panel.hpp"

#include <QAction>

namespace pastoso::main {

using commands::Command;
using interactions::MaskingForm;

namespace {

QString words_of(MaskingForm form) {
    if (form == MaskingForm::Fluid)
        return MaskingCommands::tr(
            "Paint masking fluid, as wide as the tool in hand: no paint gets below it. Alt peels it off "
            "again; Esc, or taking a tool, goes back to painting.");
    return MaskingCommands::tr(
        "Drag a strip of masking tape, as wide as the tool in hand; Shift keeps it level, upright or "
        "halfway. Alt peels it off again; Esc, or taking a tool, goes back to painting.");
}

}  // namespace

MaskingCommands::MaskingCommands(Studio& studio, panels::BrushPanel* brushes) : studio_(studio) {
    const auto masks_with = [this](MaskingForm form) {
        return [this, form](bool on) { mask_with(on ? std::optional(form) : std::nullopt); };
    };
    studio_.commands().on(Command::MaskingFluid, masks_with(MaskingForm::Fluid));
    studio_.commands().on(Command::MaskingTape, masks_with(MaskingForm::Tape));
    studio_.commands().on(Command::MaskSelection,
                          [this](bool) { studio_.easel().select(document::MaskSelection{}); });
    studio_.commands().on(Command::SelectMasked,
                          [this](bool) { studio_.easel().select(document::SelectMasked{}); });
    studio_.commands().on(Command::PeelMasking,
                          [this](bool) { studio_.easel().select(document::PeelMasking{}); });
    connect(brushes, &panels::BrushPanel::brush_taken, this, &MaskingCommands::go_back_to_painting);
    connect(&studio_, &Studio::published, this, [this](const auto& painting) { show(*painting); });
    listen_to_nib();
    enable();
}

void MaskingCommands::listen_to_nib() {
    const interactions::MaskingNib* nib = &studio_.on_canvas().masking;
    connect(nib, &interactions::MaskingNib::left, this, &MaskingCommands::go_back_to_painting);
    connect(nib, &interactions::MaskingNib::cancelled, this,
            [this] { studio_.report(tr("Nothing was masked. Esc again goes back to painting.")); });
    connect(nib, &interactions::MaskingNib::begun, this, [this](bool peels) {
        studio_.report(peels ? tr("Peels the masking off there.") : tr("Masks the canvas there."));
    });
    connect(nib, &interactions::MaskingNib::drawn, this,
            [this](const document::MaskStripe& stripe) { studio_.easel().select(stripe); });
}

/// Nothing: the brush paints again.
void MaskingCommands::mask_with(std::optional<MaskingForm> form) {
    if (form == form_) return;
    if (form) Q_EMIT masking_begins();
    form_ = form;
    studio_.commands().action(Command::MaskingFluid)->setChecked(form == MaskingForm::Fluid);
    studio_.commands().action(Command::MaskingTape)->setChecked(form == MaskingForm::Tape);
    studio_.on_canvas().masking.mask_next(form);
    studio_.report(form ? words_of(*form) : tr("The brush paints again."));
}

void MaskingCommands::show(const document::Snapshot& painting) {
    const bool any = painting.masking.cells != nullptr;
    if (any_masked_ && !any) studio_.report(tr("The masking is peeled off."));
    any_masked_ = any;
    any_selected_ = painting.selection != nullptr;
    enable();
}

void MaskingCommands::enable() {
    studio_.commands().action(Command::MaskSelection)->setEnabled(any_selected_);
    for (const Command command : {Command::SelectMasked, Command::PeelMasking})
        studio_.commands().action(command)->setEnabled(any_masked_);
}

}  // namespace pastoso::main
