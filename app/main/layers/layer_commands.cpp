#include "main/layers/layer_commands.hpp"

#include "main/layers/copied_mime.hpp"
#include "panels/layers/layer_panel.hpp"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QDockWidget>

namespace pastoso::main {
namespace {

using commands::Command;
using tools::LayerRow;

std::string numbered_name(const QString& words, std::uint32_t number) {
    return words.arg(number).toStdString();
}

}  // namespace

LayerCommands::LayerCommands(Studio& studio, panels::LayerPanel* layers, QDockWidget* dock)
    : studio_(studio), layers_(layers) {
    connect(layers_, &panels::LayerPanel::wanted, this,
            [this](const document::Action& action) { studio_.session().post(action); });
    connect(layers_, &panels::LayerPanel::choice_changed, this, &LayerCommands::show_commands);
    connect(&studio_, &Studio::published, this,
            [this](const auto& painting) { layers_->show_layers(painting->layers); });
    layers_->set_carried([this](const LayerRow& row) -> QMimeData* {
        studio_.session().wait_until_applied();
        if (row.group != 0) return nullptr;
        return copied_layer(*studio_.session().snapshot(), row.layer);
    });
    studio_.commands().on(Command::LayersPanel, [this](bool) { layers_->setFocus(Qt::TabFocusReason); });
    const auto to_chosen_layer = [this](auto action) {
        action.layer = layers_->chosen().layer;
        studio_.session().post(action);
    };
    studio_.commands().on(Command::AddLayer, [this](bool) { add_layer(); });
    studio_.commands().on(Command::DuplicateLayer,
                          [=](bool) { to_chosen_layer(document::DuplicateLayer{}); });
    studio_.commands().on(Command::MergeDown, [=](bool) { to_chosen_layer(document::MergeDown{}); });
    studio_.commands().on(Command::RenameLayer, [this, dock](bool) {
        dock->show();
        dock->raise();
        layers_->edit_name();
    });
    studio_.commands().on(Command::RemoveLayer, [this](bool) { remove_layers(); });
    studio_.commands().on(Command::ClearLayer, [this](bool) { clear_layers(); });
    studio_.commands().on(Command::FlattenLayers,
                          [this](bool) { studio_.session().post(document::FlattenLayers{}); });
    studio_.commands().on(Command::GroupLayers, [this](bool) { group_layers(); });
    studio_.commands().on(Command::UngroupLayers, [this](bool) { ungroup_layers(); });
    studio_.commands().on(Command::LayerAbove, [this](bool) { choose_neighbour(true); });
    studio_.commands().on(Command::LayerBelow, [this](bool) { choose_neighbour(false); });
    studio_.commands().on(Command::RaiseLayer, [this](bool) { move_layer(true); });
    studio_.commands().on(Command::LowerLayer, [this](bool) { move_layer(false); });
    const auto change_look = [this](bool document::LayerLook::*part, bool value) {
        document::LayerLook look = tools::look_of(layers_->stack(), layers_->chosen());
        look.*part = value;
        layers_->set_look(layers_->chosen(), look);
    };
    studio_.commands().on(Command::ShowLayer,
                          [=](bool shown) { change_look(&document::LayerLook::visible, shown); });
    studio_.commands().on(Command::LockLayer,
                          [=](bool locked) { change_look(&document::LayerLook::locked, locked); });
    studio_.commands().on(Command::LockBare,
                          [=](bool locked) { change_look(&document::LayerLook::bare_locked, locked); });
    studio_.commands().on(Command::ClipLayer,
                          [=](bool clipped) { change_look(&document::LayerLook::clipped, clipped); });
}

void LayerCommands::add_layer() {
    studio_.session().post(
        document::AddLayer{numbered_name(tr("Layer %1"), layers_->stack().next_layer)});
}

/// From above, so that the layer below is painted on next.
void LayerCommands::remove_layers() {
    auto removed = tools::layers_in(layers_->stack(), {layers_->chosen()});
    std::reverse(removed.begin(), removed.end());
    for (const document::LayerId layer : removed)
        studio_.session().post(document::RemoveLayer{layer});
}

void LayerCommands::clear_layers() {
    for (const document::LayerId layer : tools::layers_in(layers_->stack(), {layers_->chosen()}))
        studio_.session().post(document::ClearLayer{layer});
}

void LayerCommands::group_layers() {
    studio_.session().post(
        document::GroupLayers{numbered_name(tr("Group %1"), layers_->stack().next_group),
                              tools::layers_in(layers_->stack(), layers_->selected())});
}

/// The chosen group, or that of the chosen layer.
void LayerCommands::ungroup_layers() {
    const document::LayerStack& stack = layers_->stack();
    LayerRow row = layers_->chosen();
    if (row.layer != 0) row.group = stack.layers[document::place_of(stack, row.layer)].group;
    studio_.session().post(document::UngroupLayers{row.group});
}

/// Of the layer that is painted on.
void LayerCommands::choose_neighbour(bool above) {
    const document::LayerStack& stack = layers_->stack();
    const std::size_t last = stack.layers.size() - 1;
    if (above ? stack.active == last : stack.active == 0) return;
    layers_->choose({.layer = stack.layers[above ? stack.active + 1 : stack.active - 1].id});
}

void LayerCommands::move_layer(bool up) {
    const document::LayerStack& stack = layers_->stack();
    const auto gap = tools::step_from(stack, layers_->chosen(), up);
    if (!gap) return;
    if (const auto move = tools::move_to(stack, layers_->chosen(), *gap)) studio_.session().post(*move);
}

void LayerCommands::show_commands() {
    const document::LayerStack& stack = layers_->stack();
    const LayerRow chosen = layers_->chosen();
    const bool is_layer = chosen.layer != 0;
    const std::size_t place = is_layer ? document::place_of(stack, chosen.layer) : 0;
    const std::size_t count = stack.layers.size();
    const auto selected = tools::layers_in(stack, layers_->selected());
    const bool groupable = std::none_of(selected.begin(), selected.end(), [&](document::LayerId layer) {
        return stack.layers[document::place_of(stack, layer)].group != 0;
    });
    const document::LayerLook look = tools::look_of(stack, chosen);
    const auto enable = [this](Command command, bool enabled) {
        studio_.commands().action(command)->setEnabled(enabled);
    };
    enable(Command::AddLayer, count < document::kMostLayers);
    enable(Command::DuplicateLayer, is_layer && count < document::kMostLayers);
    enable(Command::RemoveLayer, tools::layers_in(stack, {chosen}).size() < count);
    enable(Command::MergeDown, is_layer && place > 0);
    enable(Command::FlattenLayers, count > 1);
    enable(Command::GroupLayers, !selected.empty() && groupable);
    enable(Command::UngroupLayers, !is_layer || stack.layers[place].group != 0);
    enable(Command::ClipLayer,
           is_layer && (look.clipped || document::clipping_base(stack, place).has_value()));
    enable(Command::LayerAbove, stack.active + 1 < count);
    enable(Command::LayerBelow, stack.active > 0);
    enable(Command::RaiseLayer, tools::step_from(stack, chosen, true).has_value());
    enable(Command::LowerLayer, tools::step_from(stack, chosen, false).has_value());
    studio_.commands().action(Command::ShowLayer)->setChecked(look.visible);
    studio_.commands().action(Command::LockLayer)->setChecked(look.locked);
    studio_.commands().action(Command::LockBare)->setChecked(look.bare_locked);
    studio_.commands().action(Command::ClipLayer)->setChecked(look.clipped);
}

}  // namespace pastoso::main
