// The layers in MainWindow: what is done to them, and their pictures in the panel.

#include "main/main_window.hpp"
#include "panels/layer_delegate.hpp"
#include "panels/layer_icons.hpp"
#include "panels/layer_panel.hpp"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QDockWidget>

namespace pastoso::main {
namespace {

using commands::Command;
using panels::LayerIcon;
using tools::LayerRow;

/// Pictures follow the paint when it had the time to change.
constexpr int kPicturesLater_ms = 400;

constexpr std::pair<Command, LayerIcon> kIcons[] = {
    {Command::AddLayer, LayerIcon::New},       {Command::DuplicateLayer, LayerIcon::Duplicate},
    {Command::GroupLayers, LayerIcon::Group},  {Command::MergeDown, LayerIcon::MergeDown},
    {Command::RemoveLayer, LayerIcon::Remove}, {Command::ShowLayer, LayerIcon::Eye},
    {Command::LockLayer, LayerIcon::Lock},
};

/// Whether two films show the same paint, as far as their tiles tell.
bool same_paint(const film::FilmState& a, const film::FilmState& b) {
    if (a.shape != b.shape) return false;
    for (int tile = 0; tile < a.thickness.tile_count(); ++tile) {
        const bool same = a.thickness.shares_tile(b.thickness, tile) &&
                          a.paint.shares_tile(b.paint, tile) &&
                          a.strata.optics.shares_tile(b.strata.optics, tile) &&
                          a.strata.soluble_thickness.shares_tile(b.strata.soluble_thickness, tile);
        if (!same) return false;
    }
    return true;
}

/// The film of a layer, by itself or on what lies below it.
std::shared_ptr<const film::FilmState> film_of(
    const document::Layer& layer, const std::shared_ptr<const document::Snapshot>& painting) {
    if (layer.asleep != nullptr) return layer.asleep;
    if (painting->active != nullptr) return painting->active;
    return {painting, &painting->film};
}

std::string numbered_name(const QString& words, std::uint32_t number) {
    return words.arg(number).toStdString();
}

}  // namespace

panels::LayerPanel* MainWindow::make_layer_panel() {
    const auto action = [this](Command command) { return commands_.action(command); };
    for (const auto& [command, icon] : kIcons)
        action(command)->setIcon(panels::layer_icon(icon, devicePixelRatioF()));
    auto* panel = new panels::LayerPanel(
        {action(Command::AddLayer), action(Command::DuplicateLayer), action(Command::GroupLayers),
         action(Command::MergeDown), action(Command::RemoveLayer)},
        {action(Command::RenameLayer), action(Command::ShowLayer), action(Command::LockLayer), nullptr,
         action(Command::AddLayer), action(Command::DuplicateLayer), action(Command::ClearLayer),
         action(Command::RemoveLayer), nullptr, action(Command::MergeDown),
         action(Command::FlattenLayers), action(Command::GroupLayers), action(Command::UngroupLayers)});
    const double pixels = devicePixelRatioF();
    const QSize size = panels::kLayerPicture * pixels;
    layer_painter_ = std::make_unique<session::LayerPainter>(
        size.width(), size.height(),
        [panel, pixels](document::LayerId layer, const session::LayerPicture& picture) {
            QImage image = QImage(picture.rgba.data(), picture.width, picture.height, 4 * picture.width,
                                  QImage::Format_RGBA8888)
                               .copy();
            image.setDevicePixelRatio(pixels);
            QMetaObject::invokeMethod(panel, [panel, layer, image, wet = picture.wet] {
                panel->set_picture(layer, image, wet);
            });
        });
    layers_changed_.setSingleShot(true);
    layers_changed_.setInterval(kPicturesLater_ms);
    connect(&layers_changed_, &QTimer::timeout, this, &MainWindow::want_layer_pictures);
    return panel;
}

void MainWindow::connect_layers() {
    connect(layers_, &panels::LayerPanel::wanted, this,
            [this](const document::Action& action) { session_->post(action); });
    connect(layers_, &panels::LayerPanel::choice_changed, this, &MainWindow::show_layer_commands);
    connect(docks_.at(Command::LayersPanel), &QDockWidget::visibilityChanged, &layers_changed_,
            qOverload<>(&QTimer::start));
    commands_.on(Command::LayersPanel, [this](bool) { layers_->setFocus(Qt::TabFocusReason); });
    const auto to_chosen_layer = [this](auto action) {
        action.layer = layers_->chosen().layer;
        session_->post(action);
    };
    commands_.on(Command::AddLayer, [this](bool) { add_layer(); });
    commands_.on(Command::DuplicateLayer, [=](bool) { to_chosen_layer(document::DuplicateLayer{}); });
    commands_.on(Command::MergeDown, [=](bool) { to_chosen_layer(document::MergeDown{}); });
    commands_.on(Command::RenameLayer, [this](bool) {
        docks_.at(Command::LayersPanel)->show();
        docks_.at(Command::LayersPanel)->raise();
        layers_->edit_name();
    });
    commands_.on(Command::RemoveLayer, [this](bool) { remove_layers(); });
    commands_.on(Command::ClearLayer, [this](bool) { clear_layers(); });
    commands_.on(Command::FlattenLayers, [this](bool) { session_->post(document::FlattenLayers{}); });
    commands_.on(Command::GroupLayers, [this](bool) { group_layers(); });
    commands_.on(Command::UngroupLayers, [this](bool) { ungroup_layers(); });
    commands_.on(Command::LayerAbove, [this](bool) { choose_neighbour(true); });
    commands_.on(Command::LayerBelow, [this](bool) { choose_neighbour(false); });
    commands_.on(Command::RaiseLayer, [this](bool) { move_layer(true); });
    commands_.on(Command::LowerLayer, [this](bool) { move_layer(false); });
    const auto change_look = [this](bool document::LayerLook::*part, bool value) {
        document::LayerLook look = tools::look_of(layers_->stack(), layers_->chosen());
        look.*part = value;
        layers_->set_look(layers_->chosen(), look);
    };
    commands_.on(Command::ShowLayer,
                 [=](bool shown) { change_look(&document::LayerLook::visible, shown); });
    commands_.on(Command::LockLayer,
                 [=](bool locked) { change_look(&document::LayerLook::locked, locked); });
}

void MainWindow::add_layer() {
    session_->post(document::AddLayer{numbered_name(tr("Layer %1"), layers_->stack().next_layer)});
}

/// From above, so that the layer below is painted on next.
void MainWindow::remove_layers() {
    auto removed = tools::layers_in(layers_->stack(), {layers_->chosen()});
    std::reverse(removed.begin(), removed.end());
    for (const document::LayerId layer : removed)
        session_->post(document::RemoveLayer{layer});
}

void MainWindow::clear_layers() {
    for (const document::LayerId layer : tools::layers_in(layers_->stack(), {layers_->chosen()}))
        session_->post(document::ClearLayer{layer});
}

void MainWindow::group_layers() {
    session_->post(document::GroupLayers{numbered_name(tr("Group %1"), layers_->stack().next_group),
                                         tools::layers_in(layers_->stack(), layers_->selected())});
}

/// The chosen group, or that of the chosen layer.
void MainWindow::ungroup_layers() {
    const document::LayerStack& stack = layers_->stack();
    LayerRow row = layers_->chosen();
    if (row.layer != 0) row.group = stack.layers[document::place_of(stack, row.layer)].group;
    session_->post(document::UngroupLayers{row.group});
}

/// Of the layer that is painted on.
void MainWindow::choose_neighbour(bool above) {
    const document::LayerStack& stack = layers_->stack();
    const std::size_t last = stack.layers.size() - 1;
    if (above ? stack.active == last : stack.active == 0) return;
    layers_->choose({.layer = stack.layers[above ? stack.active + 1 : stack.active - 1].id});
}

void MainWindow::move_layer(bool up) {
    const document::LayerStack& stack = layers_->stack();
    const auto gap = tools::step_from(stack, layers_->chosen(), up);
    if (!gap) return;
    if (const auto move = tools::move_to(stack, layers_->chosen(), *gap)) session_->post(*move);
}

void MainWindow::show_layers(const document::Snapshot& painting) {
    layers_->show_layers(painting.layers);
    if (!layers_changed_.isActive()) layers_changed_.start();
}

void MainWindow::show_layer_commands() {
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
        commands_.action(command)->setEnabled(enabled);
    };
    enable(Command::AddLayer, count < document::kMostLayers);
    enable(Command::DuplicateLayer, is_layer && count < document::kMostLayers);
    enable(Command::RemoveLayer, tools::layers_in(stack, {chosen}).size() < count);
    enable(Command::MergeDown, is_layer && place > 0);
    enable(Command::FlattenLayers, count > 1);
    enable(Command::GroupLayers, !selected.empty() && groupable);
    enable(Command::UngroupLayers, !is_layer || stack.layers[place].group != 0);
    enable(Command::LayerAbove, stack.active + 1 < count);
    enable(Command::LayerBelow, stack.active > 0);
    enable(Command::RaiseLayer, tools::step_from(stack, chosen, true).has_value());
    enable(Command::LowerLayer, tools::step_from(stack, chosen, false).has_value());
    commands_.action(Command::ShowLayer)->setChecked(look.visible);
    commands_.action(Command::LockLayer)->setChecked(look.locked);
}

// ---- pictures

/// Of layers whose paint has changed, while the hand rests and somebody sees the panel.
void MainWindow::want_layer_pictures() {
    if (!layers_->isVisible()) return;
    if (session_->status().stroke_in_progress) return layers_changed_.start();
    const auto painting = session_->snapshot();
    std::erase_if(pictured_, [&](const auto& entry) {
        const document::LayerId id = entry.first;
        return tools::layers_in(*painting->layers, {{.layer = id}}).empty();
    });
    for (const document::Layer& layer : painting->layers->layers) {
        auto film = film_of(layer, painting);
        auto& pictured = pictured_[layer.id];
        if (pictured != nullptr && (pictured == film || same_paint(*pictured, *film))) continue;
        pictured = film;
        layer_painter_->want(layer.id, std::move(film), painting->ground);
    }
}

void MainWindow::forget_layer_pictures() {
    pictured_.clear();
    if (layers_ != nullptr) layers_->forget_pictures();
}

}  // namespace pastoso::main
