// Mirrors, copies, ruler and ellipse on MainWindow's canvas.

#include "document/action_checks.hpp"
#include "main/main_window.hpp"
#include "panels/guides_panel.hpp"
#include "tools/mirrors.hpp"

#include <algorithm>

#include <QAction>

namespace pastoso::main {

using commands::Command;

void MainWindow::connect_guide_commands() {
    commands_.on(Command::MirrorSymmetry, [this](bool upright) {
        set_mirrors(upright, tools::mirrors_of(easel_->hand().symmetry).level);
    });
    commands_.on(Command::MirrorLevel, [this](bool level) {
        set_mirrors(tools::mirrors_of(easel_->hand().symmetry).upright, level);
    });
    const auto step_copies = [this](int steps) {
        brush::Symmetry symmetry = easel_->hand().symmetry;
        symmetry.count += steps;
        set_symmetry(symmetry);
        report(tr("Strokes around the middle: %1").arg(easel_->hand().symmetry.count));
    };
    commands_.on(Command::MoreCopies, [step_copies](bool) { step_copies(1); });
    commands_.on(Command::FewerCopies, [step_copies](bool) { step_copies(-1); });
    commands_.on(Command::Ruler, [this](bool lies) { lay_ruler(lies); });
    commands_.on(Command::Ellipse, [this](bool lies) { lay_ellipse(lies); });
    commands_.on(Command::GuideHandles, [this](bool shown) { canvas_->show_handles(shown); });
    commands_.on(Command::RemoveGuides, [this](bool) { remove_guides(); });
    commands_.action(Command::GuideHandles)->setChecked(true);
    connect(guides_, &panels::GuidesPanel::symmetry_chosen, this, &MainWindow::set_symmetry);
    connect(guides_, &panels::GuidesPanel::ruler_chosen, this,
            [this](const brush::Ruler& ruler) { move_guide(ruler); });
    connect(guides_, &panels::GuidesPanel::ellipse_chosen, this,
            [this](const brush::EllipseCurve& ellipse) { move_guide(ellipse); });
}

/// A symmetry that had not begun stands in the middle of the canvas.
void MainWindow::set_symmetry(const brush::Symmetry& symmetry) {
    const brush::Symmetry& before = easel_->hand().symmetry;
    brush::Symmetry next = symmetry;
    next.count = std::clamp(next.count, 1, document::kMostCopies);
    if (!before.mirror && before.count == 1) {
        next.centre_x_mm = 0.5 * session_->canvas().width_mm;
        next.centre_y_mm = 0.5 * session_->canvas().height_mm;
    }
    easel_->set_symmetry(next);
    show_guides();
}

void MainWindow::set_mirrors(bool upright, bool level) {
    set_symmetry(tools::with_mirrors(easel_->hand().symmetry, {upright, level}));
}

void MainWindow::move_guide(const tools::Guide& guide) {
    if (const auto* symmetry = std::get_if<brush::Symmetry>(&guide)) easel_->set_symmetry(*symmetry);
    if (const auto* ruler = std::get_if<brush::Ruler>(&guide)) easel_->move_ruler(*ruler);
    if (const auto* ellipse = std::get_if<brush::EllipseCurve>(&guide)) easel_->lay_ellipse(*ellipse);
    show_guides();
}

void MainWindow::lay_ruler(bool lies) {
    const document::CanvasSettings& canvas = session_->canvas();
    const double middle_mm = 0.5 * canvas.height_mm;
    if (lies)
        easel_->lay_ruler({0.1 * canvas.width_mm, middle_mm, 0.9 * canvas.width_mm, middle_mm});
    else
        easel_->take_ruler_away();
    show_guides();
}

void MainWindow::lay_ellipse(bool lies) {
    const document::CanvasSettings& canvas = session_->canvas();
    const double half_mm = 0.3 * std::min(canvas.width_mm, canvas.height_mm);
    if (lies)
        easel_->lay_ellipse({0.5 * canvas.width_mm, 0.5 * canvas.height_mm, half_mm, half_mm, 0.0});
    else
        easel_->take_ellipse_away();
    show_guides();
}

void MainWindow::remove_guides() {
    easel_->take_ruler_away();
    easel_->take_ellipse_away();
    brush::Symmetry none = easel_->hand().symmetry;
    none.mirror = false;
    none.count = 1;
    set_symmetry(none);
}

void MainWindow::show_guides() {
    const tools::Hand& hand = easel_->hand();
    const tools::Mirrors mirrors = tools::mirrors_of(hand.symmetry);
    commands_.action(Command::MirrorSymmetry)->setChecked(mirrors.upright);
    commands_.action(Command::MirrorLevel)->setChecked(mirrors.level);
    commands_.action(Command::Ruler)->setChecked(hand.ruler.has_value());
    commands_.action(Command::Ellipse)->setChecked(hand.ellipse.has_value());
    commands_.action(Command::FewerCopies)->setEnabled(hand.symmetry.count > 1);
    commands_.action(Command::MoreCopies)->setEnabled(hand.symmetry.count < document::kMostCopies);
    const bool any = hand.ruler || hand.ellipse || hand.symmetry.mirror || hand.symmetry.count > 1;
    commands_.action(Command::RemoveGuides)->setEnabled(any);
    guides_->show_hand(hand);
    canvas_->update();
}

}  // namespace pastoso::main
