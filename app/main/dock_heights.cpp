#include "main/dock_heights.hpp"

#include "main/dock_arrangement.hpp"
#include "panels/layers/layer_panel.hpp"
#include "tools/workspaces.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <QDockWidget>
#include <QMainWindow>
#include <QMouseEvent>
#include <QTabBar>

namespace pastoso::main {
namespace {

using tools::PanelTabs;
using tools::Side;

/// Of which it is known how much it holds.
constexpr const char* kLayers = "layers_panel";

QDockWidget* dock_named(const QMainWindow& window, const std::string& name) {
    return window.findChild<QDockWidget*>(QString::fromStdString(name), Qt::FindDirectChildrenOnly);
}

/// Of the names above panels that stand one behind the other.
int names_height_px(const QMainWindow& window, const PanelTabs& tabs) {
    if (tabs.panels.size() < 2) return 0;
    for (const auto* bar : window.findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly))
        if (bar->isVisible()) return bar->height();
    return 0;
}

/// Whether what is dragged there parts panels of one side, and not a side from the canvas.
bool parts_panels(const QMainWindow& window, const QPoint& place) {
    if (!window.isSeparator(place)) return false;
    const auto docks = window.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly);
    return std::any_of(docks.begin(), docks.end(), [&](const QDockWidget* dock) {
        const QRect there = dock->geometry();
        return dock->isVisible() && !dock->isFloating() && place.x() >= there.left() &&
               place.x() <= there.right();
    });
}

}  // namespace

DockHeights::DockHeights(QMainWindow& window, const PanelSet& panels)
    : window_(window), followed_(tools::arrangement_of(tools::Workspace::Oil)) {
    window_.installEventFilter(this);
    connect(panels.layers, &panels::LayerPanel::choice_changed, this, [this, layers = panels.layers] {
        const std::size_t count = layers->stack().layers.size();
        if (std::exchange(layers_, count) != count) fit_soon();
    });
}

void DockHeights::follow(const tools::PanelArrangement& arrangement) {
    followed_ = arrangement;
    fit_soon();
}

bool DockHeights::eventFilter(QObject* object, QEvent* event) {
    if (event->type() == QEvent::Resize || event->type() == QEvent::Show) fit_soon();
    if (event->type() == QEvent::MouseButtonPress &&
        parts_panels(window_, static_cast<const QMouseEvent*>(event)->position().toPoint()))
        leave_as_they_are();
    return QObject::eventFilter(object, event);
}

/// Once the layout has done its part.
void DockHeights::fit_soon() {
    if (!follows() || std::exchange(waits_, true)) return;
    QMetaObject::invokeMethod(
        this, [this] { fit(); }, Qt::QueuedConnection);
}

void DockHeights::fit() {
    waits_ = false;
    if (!follows() || !window_.isVisible()) return;
    for (const Side side : {Side::Left, Side::Right})
        fit(side);
}

/// One where another panel stands, too, is the painter's own.
void DockHeights::fit(Side side) {
    std::vector<tools::LengthWish> wishes;
    QList<QDockWidget*> docks;
    int room_px = 0;
    const tools::PanelArrangement standing = read_docks(window_);
    for (const PanelTabs& tabs : standing.at(side).tabs) {
        const std::optional<int> share = share_of(tabs);
        if (!share) return;
        wishes.push_back({*share, needed_by(tabs)});
        docks.push_back(dock_named(window_, tabs.panels[tabs.raised]));
        room_px += tabs.length_px + names_height_px(window_, tabs);
    }
    const bool knows_one =
        std::ranges::any_of(wishes, [](const auto& wish) { return wish.needed_px.has_value(); });
    if (docks.size() < 2 || !knows_one) return;
    const std::vector<int> lengths = tools::shared_lengths(wishes, room_px);
    window_.resizeDocks(docks, {lengths.begin(), lengths.end()}, Qt::Vertical);
}

/// Nothing: it is nowhere in the arrangement that is followed.
std::optional<int> DockHeights::share_of(const PanelTabs& tabs) const {
    for (const tools::PanelSide& side : followed_->sides)
        for (const PanelTabs& there : side.tabs)
            if (std::ranges::find_first_of(tabs.panels, there.panels) != tabs.panels.end())
                return there.length_px;
    return {};
}

/// Nothing: it is unknown, so that it takes what there is.
std::optional<int> DockHeights::needed_by(const PanelTabs& tabs) const {
    if (std::ranges::find(tabs.panels, kLayers) == tabs.panels.end()) return {};
    return dock_named(window_, kLayers)->sizeHint().height() + names_height_px(window_, tabs);
}

}  // namespace pastoso::main
