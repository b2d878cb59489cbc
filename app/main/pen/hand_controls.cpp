#include "main/pen/hand_controls.hpp"

#include "brush/preset.hpp"
#include "panels/canvas/easel_panel.hpp"
#include "panels/colour/colour_panel.hpp"
#include "panels/paint/load_panel.hpp"
#include "panels/paint/medium_box.hpp"
#include "panels/paint/medium_panel.hpp"
#include "panels/paint/paint_panel.hpp"
#include "panels/paint/thinning_slider.hpp"
#include "panels/parts/status_readings.hpp"
#include "panels/pen/brush_panel.hpp"
#include "tools/paint_share.hpp"

#include <QAction>

namespace pastoso::main {
namespace {

using commands::Command;

}  // namespace

HandControls::HandControls(Studio& studio, const PanelSet& panels) : studio_(studio), panels_(panels) {
    connect_commands();
    connect_panels();
    connect(&studio_, &Studio::hand_changed, this, &HandControls::show);
    connect(&studio_, &Studio::published, this, [this](const auto& painting, const auto& status) {
        panels_.load->show_load(painting->brush_load);
        panels_.readings->show_status(status);
    });
}

void HandControls::connect_commands() {
    const commands::CommandRegistry& commands = studio_.commands();
    tools::Easel& easel = studio_.easel();
    commands.on(Command::ReloadBrush, [&easel](bool) { easel.reload(); });
    commands.on(Command::TopUpBrush, [&easel](bool) { easel.dip(); });
    commands.on(Command::BlotBrush, [&easel](bool) { easel.blot(); });
    commands.on(Command::CleanBrush, [&easel](bool) { easel.clean(); });
    commands.on(Command::SwapPaints, [this](bool) {
        studio_.easel().swap_paints();
        studio_.show_hand();
    });
    const auto step_medium = [this](int steps) {
        return [this, steps](bool) {
            thin(tools::stepped_paint_share(studio_.easel().hand().medium.paint_share, steps));
        };
    };
    commands.on(Command::MoreMedium, step_medium(1));
    commands.on(Command::MorePaint, step_medium(-1));
    commands.on(Command::ThinWash, [this](bool wash) {
        studio_.easel().thin_to_wash(wash);
        studio_.show_hand();
    });
    commands.on(Command::DryNow, [&easel](bool) { easel.dry_now(); });
    commands.on(Command::ReloadEachStroke,
                [&easel](bool reload) { easel.set_reload_each_stroke(reload); });
    commands.on(Command::TurnWithStroke, [&easel](bool turn) { easel.set_turn_with_stroke(turn); });
    commands.on(Command::TiltTool, [&easel](bool tilted) { easel.set_tilted(tilted); });
    commands.on(Command::NextBrush, [this](bool) { panels_.brushes->take_next(1); });
    commands.on(Command::PreviousBrush, [this](bool) { panels_.brushes->take_next(-1); });
    commands.on(Command::SmallerBrush, [this](bool) { step_width(-1); });
    commands.on(Command::LargerBrush, [this](bool) { step_width(1); });
}

void HandControls::connect_panels() {
    connect(panels_.brushes, &panels::BrushPanel::width_chosen, this,
            [this](double width_mm) { set_width(width_mm); });
    connect(panels_.brushes, &panels::BrushPanel::stabiliser_chosen, this,
            [this](const brush::Stabiliser& stabiliser) { studio_.easel().set_stabiliser(stabiliser); });
    connect(panels_.paints, &panels::PaintPanel::paint_chosen, this, [this](const QString& pigment) {
        document::PaintRecipe paint;
        if (!pigment.isEmpty()) paint.ingredients = {{pigment.toStdString(), 1.0}};
        studio_.choose_paint(paint);
    });
    connect(panels_.colours, &panels::ColourPanel::paint_chosen, &studio_, &Studio::choose_paint);
    connect(panels_.load, &panels::LoadPanel::dip_chosen, this, [this](const tools::Dip& dip) {
        studio_.easel().set_dip(dip);
        studio_.show_hand();
    });
    connect(panels_.medium, &panels::MediumBox::medium_chosen, this, &HandControls::use_medium);
    connect(panels_.thinning, &panels::ThinningSlider::share_chosen, this, &HandControls::thin);
    connect(panels_.physics, &panels::MediumPanel::medium_chosen, this, &HandControls::use_medium);
    connect(panels_.physics, &panels::MediumPanel::medium_changed, this,
            [this](const film::Medium& medium) {
                studio_.easel().change_medium(medium);
                studio_.show_hand();
            });
    // The brush that comes over the canvas holds what was set a moment ago.
    for (const view::CanvasView* view : studio_.views()) {
        connect(view, &view::CanvasView::pointer_moved, panels_.physics, &panels::MediumPanel::finish);
        connect(view, &view::CanvasView::pointer_moved, panels_.thinning,
                &panels::ThinningSlider::finish);
    }
    connect(panels_.stand, &panels::EaselPanel::tilted, this,
            [this](double tilt_deg, double direction_deg) {
                studio_.easel().tilt(tilt_deg, direction_deg);
            });
    connect(panels_.stand, &panels::EaselPanel::drying_changed, this,
            [this](double speed) { studio_.easel().set_drying_speed(speed); });
}

void HandControls::use_medium(const QString& name) {
    studio_.easel().use_medium(name.toStdString());
    studio_.show_hand();
}

void HandControls::thin(double paint_share) {
    studio_.easel().set_paint_share(paint_share);
    studio_.show_hand();
}

void HandControls::step_width(int steps) {
    set_width(tools::stepped_brush_width_mm(studio_.easel().hand().brush_width_mm, steps));
}

void HandControls::set_width(double width_mm) {
    studio_.easel().set_brush_width(width_mm);
    studio_.show_hand();
}

void HandControls::show(const tools::Hand& hand) {
    panels_.colours->show_paint(hand.paint);
    const auto& mix = hand.paint.ingredients;
    panels_.paints->show_paint(mix.empty() ? QString() : QString::fromStdString(mix.front().pigment));
    panels_.stand->show_tilt(hand.tilt.tilt_deg, hand.tilt.direction_deg);
    panels_.stand->show_drying(hand.air.speed);
    panels_.load->show_hand(hand);
    panels_.medium->show_medium(QString::fromStdString(hand.medium.name));
    panels_.thinning->show_hand(hand);
    panels_.physics->show_medium(tools::unthinned_medium(hand));
    const commands::CommandRegistry& commands = studio_.commands();
    commands.action(Command::ReloadEachStroke)->setChecked(hand.reload_each_stroke);
    commands.action(Command::TurnWithStroke)->setChecked(hand.turn_with_stroke);
    commands.action(Command::TiltTool)->setChecked(hand.tilted);
    const bool thins = tools::can_thin(hand);
    for (const auto command : {Command::MoreMedium, Command::ThinWash})
        commands.action(command)->setEnabled(thins);
    commands.action(Command::MorePaint)->setEnabled(thins && hand.medium.paint_share < 1.0);
    commands.action(Command::ThinWash)
        ->setChecked(thins && hand.medium.paint_share <= tools::kWashShare);
    const bool dips = tools::preset_in_hand(hand).dips;
    for (const auto command : {Command::ReloadBrush, Command::TopUpBrush})
        commands.action(command)->setEnabled(dips);
    for (interactions::OnCanvas* on : studio_.on_views())
        on->paint.set_tool(tools::sized_preset_in_hand(hand));
}

}  // namespace pastoso::main
