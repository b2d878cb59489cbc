#include "main/pen/guide_commands.hpp"

#include "document/actions/actions.hpp"
#include "panels/pen/guides_panel.hpp"
#include "tools/mirrors.hpp"

#include <algorithm>
#include <utility>

#include <QAction>

namespace pastoso::main {

using commands::Command;
using tools::GuideKind;

namespace {

constexpr std::pair<Command, GuideKind> kKinds[] = {
    {Command::Ruler, GuideKind::Ruler},
    {Command::ParallelRuler, GuideKind::ParallelRuler},
    {Command::Ellipse, GuideKind::Ellipse},
    {Command::ConcentricEllipse, GuideKind::ConcentricEllipse},
    {Command::OnePointPerspective, GuideKind::OnePoint},
    {Command::TwoPointPerspective, GuideKind::TwoPoints},
    {Command::ThreePointPerspective, GuideKind::ThreePoints},
    {Command::GuideGrid, GuideKind::Grid},
};

}  // namespace

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
    for (const auto& [command, kind] : kKinds) {
        studio_.commands().on(command,
                              [this, laid = kind](bool lies) { lay(lies ? laid : GuideKind::None); });
    }
    studio_.commands().on(Command::SnapToGuide, [this](bool snaps) { snap(snaps); });
    studio_.commands().on(Command::GuideHandles,
                          [this](bool shown) { studio_.on_canvas().guides.show_handles(shown); });
    studio_.commands().on(Command::RemoveGuides, [this](bool) { remove_guides(); });
    studio_.commands().action(Command::GuideHandles)->setChecked(true);
    studio_.commands().action(Command::SnapToGuide)->setChecked(true);
    connect(guides_, &panels::GuidesPanel::symmetry_chosen, this, &GuideCommands::set_symmetry);
    connect(guides_, &panels::GuidesPanel::kind_chosen, this, &GuideCommands::lay);
    connect(guides_, &panels::GuidesPanel::guide_chosen, this,
            [this](const brush::PenGuide& guide) { move_guide(guide); });
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
    if (const auto* laid = std::get_if<brush::PenGuide>(&guide)) studio_.easel().lay_guide(*laid);
    show(studio_.easel().hand());
}

/// A ruler that was none lies along the last stroke.
void GuideCommands::lay(GuideKind kind) {
    tools::Easel& easel = studio_.easel();
    if (kind == GuideKind::None) {
        easel.take_guide_away();
    } else {
        const document::CanvasSettings& canvas = studio_.session().canvas();
        brush::PenGuide guide =
            tools::as_kind(easel.hand().laid, kind, {canvas.width_mm, canvas.height_mm});
        auto* ruler = std::get_if<brush::Ruler>(&guide.form);
        if (ruler != nullptr && !easel.hand().ruler()) *ruler = easel.ruler_along_stroke(*ruler);
        easel.lay_guide(guide);
    }
    show(easel.hand());
}

void GuideCommands::snap(bool snaps) {
    brush::PenGuide guide = studio_.easel().hand().laid;
    guide.strength = snaps ? strength_ : 0.0;
    move_guide(guide);
}

void GuideCommands::remove_guides() {
    studio_.easel().take_guide_away();
    brush::Symmetry none = studio_.easel().hand().symmetry;
    none.mirror = false;
    none.count = 1;
    set_symmetry(none);
}

void GuideCommands::show(const tools::Hand& hand) {
    const tools::Mirrors mirrors = tools::mirrors_of(hand.symmetry);
    studio_.commands().action(Command::MirrorSymmetry)->setChecked(mirrors.upright);
    studio_.commands().action(Command::MirrorLevel)->setChecked(mirrors.level);
    const GuideKind laid = tools::kind_of(hand.laid);
    for (const auto& [command, kind] : kKinds)
        studio_.commands().action(command)->setChecked(kind == laid);
    if (hand.laid.strength > 0.0) strength_ = hand.laid.strength;
    studio_.commands().action(Command::SnapToGuide)->setChecked(hand.laid.strength > 0.0);
    studio_.commands().action(Command::FewerCopies)->setEnabled(hand.symmetry.count > 1);
    studio_.commands()
        .action(Command::MoreCopies)
        ->setEnabled(hand.symmetry.count < document::kMostCopies);
    const bool any = laid != GuideKind::None || hand.symmetry.mirror || hand.symmetry.count > 1;
    studio_.commands().action(Command::RemoveGuides)->setEnabled(any);
    guides_->show_hand(hand);
    studio_.canvas().refresh();
}

}  // namespace pastoso::main
