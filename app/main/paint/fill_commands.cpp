#include "main/paint/fill_commands.hpp"

#include "appearance/shown_number.hpp"
#include "dialogs/length_dialog.hpp"
#include "main/paint/lent_paint.hpp"
#include "panels/pen/brush_panel.hpp"

#include <QAction>
#include <QMainWindow>

namespace pastoso::main {

using commands::Command;

FillCommands::FillCommands(Studio& studio, panels::BrushPanel* brushes) : studio_(studio) {
    studio_.commands().on(Command::FillPaint,
                          [this](bool) { pour({.paint = studio_.easel().hand().paint}); });
    studio_.commands().on(Command::FillSecond,
                          [this](bool) { pour({.paint = studio_.easel().hand().second_paint}); });
    studio_.commands().on(Command::FillGradient, [this](bool on) { draw_gradients(on); });
    studio_.commands().on(Command::FillThickness, [this](bool) { ask_thickness(); });
    studio_.commands().on(Command::ToneGround, [this](bool) { ask_for_ground(); });
    connect(brushes, &panels::BrushPanel::brush_taken, this, &FillCommands::end_gradients);
    listen_to_line();
}

void FillCommands::listen_to_line() {
    const interactions::GradientLine* line = &studio_.on_canvas().gradient;
    connect(line, &interactions::GradientLine::left, this, &FillCommands::end_gradients);
    connect(line, &interactions::GradientLine::cancelled, this,
            [this] { studio_.report(tr("Nothing was poured. Esc again goes back to painting.")); });
    connect(line, &interactions::GradientLine::drawn, this,
            [this](const glm::dvec2& from_mm, const glm::dvec2& to_mm) {
                const tools::Hand& hand = studio_.easel().hand();
                pour({.paint = hand.paint,
                      .second = hand.second_paint,
                      .line = {{from_mm.x, from_mm.y}, {to_mm.x, to_mm.y}}});
            });
}

void FillCommands::draw_gradients(bool on) {
    if (on == drawing_) return;
    if (on) Q_EMIT gradients_begin();
    drawing_ = on;
    studio_.on_canvas().gradient.draw_next(on);
    studio_.commands().action(Command::FillGradient)->setChecked(on);
    studio_.report(
        on ? tr("Drag a line from the paint in hand to the second paint; Shift keeps it level, "
                "upright or halfway. Esc, or taking a tool, goes back to painting.")
           : tr("The brush paints again."));
}

void FillCommands::pour(document::FillWithPaint fill) {
    if (paint_is_lent(studio_)) return;
    fill.thickness_mm = thickness_mm_;
    studio_.easel().fill(fill);
    const QString words = studio_.session().snapshot()->selection == nullptr
                              ? tr("%1 mm of paint are poured over the whole canvas.")
                              : tr("%1 mm of paint are poured over what is selected.");
    studio_.report(words.arg(appearance::shown_number(thickness_mm_)));
}

void FillCommands::ask_for_ground() {
    if (paint_is_lent(studio_)) return;
    auto* dialog = new dialogs::ThicknessDialog(
        {.title = tr("Toned ground"),
         .explanation =
             tr("An even coat of the paint in hand covers the whole canvas, dry at once, on a "
                "layer below all others: 0.02 mm tints the canvas, 0.1 mm covers it."),
         .name = tr("Thickness"),
         .button = tr("Tone the ground"),
         .least_mm = document::kLeastFill_mm,
         .most_mm = document::kMostFill_mm,
         .proposal_mm = ground_mm_},
        &studio_.window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { tone_ground(dialog->chosen_mm()); });
    dialog->show();
}

/// A recording may have begun to be played since the dialog was opened.
void FillCommands::tone_ground(double thickness_mm) {
    ground_mm_ = thickness_mm;
    if (paint_is_lent(studio_)) return;
    studio_.easel().tone_ground({.paint = studio_.easel().hand().paint,
                                 .thickness_mm = ground_mm_,
                                 .name = tr("Ground").toStdString()});
}

void FillCommands::ask_thickness() {
    auto* dialog = new dialogs::ThicknessDialog(
        {.title = tr("Thickness of fills"),
         .explanation =
             tr("Fills and gradients pour an even film of wet paint, as thick as this: 0.05 mm "
                "shows what lies below, 0.2 mm covers, 1 mm stands as a paste."),
         .name = tr("Thickness"),
         .button = tr("Keep"),
         .least_mm = document::kLeastFill_mm,
         .most_mm = document::kMostFill_mm,
         .proposal_mm = thickness_mm_},
        &studio_.window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { thickness_mm_ = dialog->chosen_mm(); });
    dialog->show();
}

}  // namespace pastoso::main
