#include "main/pen/guide_commands.hpp"

#include "document/actions/actions.hpp"
#include "panels/pen/guides_panel.hpp"
#include "tools/mirrors.hpp"

#include <algorithm>

#include <QAction>

namespace pastoso::main {

using commands::Command;

GuideCommands::GuideCommands(Studio& studio, panels::GuidesPanel* guides)
    : studio_(studio), guides_(guides) {
    studio_.commands().on(Command::MirrorSymmetry, [this](bool upright) {
        set_mirrors(upright, tools::mirrors_of(studio_.easel().hand().symmetry).level);
    });
    studio_.commands().on(Command::MirrorLevel, [this](bool level) {
        set_mirrors(tools::mirrors_of(studio_.easel().hand().symmetry).upright, level);
    });
    const auto step_copies = [this](int steps) {
        brush::Symmetry symmetry = studio_.easel().hand().symmetry;
        symmetry.count += steps;
        set_symmetry(symmetry);
        studio_.report(tr("Strokes around the middle: %1").arg(studio_.easel().hand().symmetry.count));
    };
    studio_.commands().on(Command::MoreCopies, [step_copies](bool) { step_copies(1); });
    studio_.commands().on(Command::FewerCopies, [step_copies](bool) { step_copies(-1); });
    studio_.commands().on(Command::Ruler, [this](bool lies) { lay_ruler(lies); });
    studio_.commands().on(Command::Ellipse, [this](bool lies) { lay_ellipse(lies); });
    studio_.commands().on(Command::GuideHandles,
                          [this](bool shown) { studio_.on_canvas().guides.show_handles(shown); });
    studio_.commands().on(Command::RemoveGuides, [this](bool) { remove_guides(); });
    studio_.commands().action(Command::GuideHandles)->setChecked(true);
    connect(guides_, &panels::GuidesPanel::symmetry_chosen, this, &GuideCommands::set_symmetry);
    connect(guides_, &panels::GuidesPanel::ruler_chosen, this,
            [this](const brush::Ruler& ruler) { move_guide(ruler); });
    connect(guides_, &panels::GuidesPanel::ellipse_chosen, this,
            [this](const brush::EllipseCurve& ellipse) { move_guide(ellipse); });
    connect(&studio_.on_canvas().guides, &interactions::Guides::dragged, this,
            &GuideCommands::move_guide);
    connect(&studio_, &Studio::hand_changed, this, &GuideCommands::show);
}

/// A symmetry that had not begun stands in the middle of the canvas.
void GuideCommands::set_symmetry(const brush::Symmetry& symmetry) {
    const brush::Symmetry& before = studio_.easel().hand().symmetry;
    brush::Symmetry next = symmetry;
    next.count = std::clamp(next.count, 1, document::kMostCopies);
    if (!before.mirror && before.count == 1) {
        next.centre_x_mm = 0.5 * studio_.session().canvas().width_mm;
        next.centre_y_mm = 0.5 * studio_.session().canvas().height_mm;
    }
    studio_.easel().set_symmetry(next);
    show(studio_.easel().hand());
}

void GuideCommands::set_mirrors(bool upright, bool level) {
    set_symmetry(tools::with_mirrors(studio_.easel().hand().symmetry, {upright, level}));
}

void GuideCommands::move_guide(const tools::Guide& guide) {
    if (const auto* symmetry = std::get_if<brush::Symmetry>(&guide))
        studio_.easel().set_symmetry(*symmetry);
    if (const auto* ruler = std::get_if<brush::Ruler>(&guide)) studio_.easel().move_ruler(*ruler);
    if (const auto* ellipse = std::get_if<brush::EllipseCurve>(&guide))
        studio_.easel().lay_ellipse(*ellipse);
    show(studio_.easel().hand());
}

void GuideCommands::lay_ruler(bool lies) {
    const document::CanvasSettings& canvas = studio_.session().canvas();
    const double middle_mm = 0.5 * canvas.height_mm;
    if (lies)
        studio_.easel().lay_ruler({0.1 * canvas.width_mm, middle_mm, 0.9 * canvas.width_mm, middle_mm});
    else
        studio_.easel().take_ruler_away();
    show(studio_.easel().hand());
}

void GuideCommands::lay_ellipse(bool lies) {
    const document::CanvasSettings& canvas = studio_.session().canvas();
    const double half_mm = 0.3 * std::min(canvas.width_mm, canvas.height_mm);
    if (lies)
        studio_.easel().lay_ellipse(
            {0.5 * canvas.width_mm, 0.5 * canvas.height_mm, half_mm, half_mm, 0.0});
    else
        studio_.easel().take_ellipse_away();
    show(studio_.easel().hand());
}

void GuideCommands::remove_guides() {
    studio_.easel().take_ruler_away();
    studio_.easel().take_ellipse_away();
    brush::Symmetry none = studio_.easel().hand().symmetry;
    none.mirror = false;
    none.count = 1;
    set_symmetry(none);
}

void GuideCommands::show(const tools::Hand& hand) {
    const tools::Mirrors mirrors = tools::mirrors_of(hand.symmetry);
    studio_.commands().action(Command::MirrorSymmetry)->setChecked(mirrors.upright);
    studio_.commands().action(Command::MirrorLevel)->setChecked(mirrors.level);
    studio_.commands().action(Command::Ruler)->setChecked(hand.ruler.has_value());
    studio_.commands().action(Command::Ellipse)->setChecked(hand.ellipse.has_value());
    studio_.commands().action(Command::FewerCopies)->setEnabled(hand.symmetry.count > 1);
    studio_.commands()
        .action(Command::MoreCopies)
        ->setEnabled(hand.symmetry.count < document::kMostCopies);
    const bool any = hand.ruler || hand.ellipse || hand.symmetry.mirror || hand.symmetry.count > 1;
    studio_.commands().action(Command::RemoveGuides)->setEnabled(any);
    guides_->show_hand(hand);
    studio_.canvas().refresh();
}

}  // namespace pastoso::main
