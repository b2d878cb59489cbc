#include "main/dock_arrangement.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <QDockWidget>
#include <QMainWindow>
#include <QScreen>
#include <QTabBar>

namespace pastoso::main {
namespace {

using tools::PanelArrangement;
using tools::PanelSide;
using tools::PanelTabs;
using tools::Side;

using Docks = std::vector<QDockWidget*>;

Qt::DockWidgetArea area_of(Side side) {
    constexpr Qt::DockWidgetArea kAreas[] = {Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea,
                                             Qt::TopDockWidgetArea, Qt::BottomDockWidgetArea};
    return kAreas[static_cast<std::size_t>(side)];
}

/// The docks of a side stand one below the other.
bool is_upright(Side side) {
    return side == Side::Left || side == Side::Right;
}

std::string name_of(const QDockWidget* dock) {
    return dock->objectName().toStdString();
}

Docks docks_of(const QMainWindow& window) {
    const auto found = window.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly);
    return {found.begin(), found.end()};
}

/// Docks in one place, and the one that is seen.
struct Group {
    Docks docks;
    std::size_t raised = 0;

    QRect place() const { return docks[raised]->geometry(); }
};

/// Where it stands behind or before others, Qt tells their order in the bar of their tabs alone.
Group group_of(const QMainWindow& window, QDockWidget* dock) {
    const QList<QDockWidget*> others = window.tabifiedDockWidgets(dock);
    for (const QTabBar* bar : window.findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly)) {
        Group group;
        for (int tab = 0; tab < bar->count(); ++tab) {
            const auto has_words = [&](const QDockWidget* one) {
                return !one->isHidden() && one->windowTitle() == bar->tabText(tab);
            };
            if (tab == bar->currentIndex()) group.raised = group.docks.size();
            if (has_words(dock)) group.docks.push_back(dock);
            const auto other = std::find_if(others.begin(), others.end(), has_words);
            if (other != others.end()) group.docks.push_back(*other);
        }
        const bool is_its =
            !bar->isHidden() && std::ranges::find(group.docks, dock) != group.docks.end();
        if (is_its) return group;
    }
    return {.docks = {dock}};
}

std::vector<Group> groups_at(const QMainWindow& window, Side side) {
    std::vector<Group> groups;
    std::set<const QDockWidget*> seen;
    for (QDockWidget* dock : docks_of(window)) {
        const bool is_there =
            !dock->isHidden() && !dock->isFloating() && window.dockWidgetArea(dock) == area_of(side);
        if (!is_there || seen.contains(dock)) continue;
        groups.push_back(group_of(window, dock));
        seen.insert(groups.back().docks.begin(), groups.back().docks.end());
    }
    std::ranges::sort(groups, {}, [side](const Group& group) {
        return is_upright(side) ? group.place().y() : group.place().x();
    });
    return groups;
}

PanelSide read_side(const QMainWindow& window, Side side) {
    PanelSide read;
    for (const Group& group : groups_at(window, side)) {
        const QSize size = group.place().size();
        PanelTabs tabs{.panels = {},
                       .raised = group.raised,
                       .length_px = std::max(1, is_upright(side) ? size.height() : size.width())};
        std::ranges::transform(group.docks, std::back_inserter(tabs.panels), name_of);
        read.tabs.push_back(std::move(tabs));
        read.breadth_px = is_upright(side) ? size.width() : size.height();
    }
    return read;
}

/// Where a panel stands: with others, at a side.
struct Home {
    Side side = Side::Right;
    std::vector<std::string> companions;
};

/// A panel that has none stands by itself.
Home home_of(const std::string& panel, const PanelArrangement& home) {
    for (const Side side : tools::kSides)
        for (const PanelTabs& tabs : home.at(side).tabs)
            if (std::ranges::find(tabs.panels, panel) != tabs.panels.end()) return {side, tabs.panels};
    return {Side::Right, {panel}};
}

/// Puts the docks of one window up anew.
class Arranging {
  public:
    Arranging(QMainWindow& window, const PanelArrangement& home) : window_(window), home_(home) {
        for (QDockWidget* dock : docks_of(window)) {
            docks_[name_of(dock)] = dock;
            window.removeDockWidget(dock);
        }
    }

    /// Before those that are open, so that they come back above them.
    void close_alone(const PanelArrangement& wanted) {
        open_ = names_in(wanted);
        for (const auto& [name, dock] : docks_) {
            const Home home = home_of(name, home_);
            if (open_.contains(name) || home.companions.size() > 1) continue;
            add(dock, home.side);
            dock->hide();
        }
    }

    void open(const PanelArrangement& wanted) {
        for (const Side side : tools::kSides)
            for (const PanelTabs& tabs : wanted.at(side).tabs)
                open(tabs, side);
        for (const tools::FloatingPanel& floating : wanted.floating)
            open(floating);
    }

    void close_others() {
        for (const auto& [name, dock] : docks_) {
            const Home home = home_of(name, home_);
            if (open_.contains(name) || home.companions.size() == 1) continue;
            QDockWidget* before = open_companion(home);
            add(dock, home.side);
            if (before != nullptr) window_.tabifyDockWidget(before, dock);
            dock->hide();
        }
    }

    void raise_and_size(const PanelArrangement& wanted) {
        for (const Side side : tools::kSides)
            size(wanted.at(side), side);
    }

  private:
    static std::set<std::string> names_in(const PanelArrangement& wanted) {
        std::set<std::string> names;
        for (const PanelSide& side : wanted.sides)
            for (const PanelTabs& tabs : side.tabs)
                names.insert(tabs.panels.begin(), tabs.panels.end());
        for (const tools::FloatingPanel& floating : wanted.floating)
            names.insert(floating.panel);
        return names;
    }

    QDockWidget* dock(const std::string& name) const {
        const auto found = docks_.find(name);
        return found == docks_.end() ? nullptr : found->second;
    }

    void add(QDockWidget* dock, Side side) {
        window_.addDockWidget(area_of(side), dock);
        if (dock->isFloating()) dock->setFloating(false);
    }

    void open(const PanelTabs& tabs, Side side) {
        QDockWidget* first = nullptr;
        for (const std::string& name : tabs.panels) {
            QDockWidget* one = dock(name);
            if (one == nullptr) continue;
            add(one, side);
            if (first != nullptr) window_.tabifyDockWidget(first, one);
            if (first == nullptr) first = one;
            one->show();
        }
    }

    /// Within the screen, which may be another one by now.
    void open(const tools::FloatingPanel& floating) {
        QDockWidget* one = dock(floating.panel);
        if (one == nullptr) return;
        add(one, home_of(floating.panel, home_).side);
        one->setFloating(true);
        const QRect screen = window_.screen()->availableGeometry();
        QRect place(floating.x_px, floating.y_px, floating.width_px, floating.height_px);
        if (!screen.intersects(place)) place.moveTopLeft(screen.topLeft());
        one->setGeometry(place);
        one->show();
    }

    QDockWidget* open_companion(const Home& home) const {
        for (const std::string& name : home.companions)
            if (open_.contains(name) && dock(name) != nullptr && !dock(name)->isFloating())
                return dock(name);
        return nullptr;
    }

    void size(const PanelSide& side, Side at) {
        QList<QDockWidget*> docks;
        QList<int> lengths;
        for (const PanelTabs& tabs : side.tabs) {
            QDockWidget* raised = dock(tabs.panels[tabs.raised]);
            if (raised == nullptr) continue;
            raised->raise();
            docks.push_back(raised);
            lengths.push_back(tabs.length_px);
        }
        if (docks.isEmpty()) return;
        const bool upright = is_upright(at);
        window_.resizeDocks({docks.front()}, {std::max(1, side.breadth_px)},
                            upright ? Qt::Horizontal : Qt::Vertical);
        window_.resizeDocks(docks, lengths, upright ? Qt::Vertical : Qt::Horizontal);
    }

    QMainWindow& window_;
    const PanelArrangement& home_;
    std::map<std::string, QDockWidget*> docks_;
    std::set<std::string> open_;
};

}  // namespace

PanelArrangement read_docks(const QMainWindow& window) {
    PanelArrangement read;
    for (const Side side : tools::kSides)
        read.at(side) = read_side(window, side);
    for (const QDockWidget* dock : docks_of(window)) {
        if (dock->isHidden() || !dock->isFloating()) continue;
        const QRect place = dock->geometry();
        read.floating.push_back({name_of(dock), place.x(), place.y(), place.width(), place.height()});
    }
    return read;
}

void arrange_docks(QMainWindow& window, const PanelArrangement& wanted, const PanelArrangement& home) {
    Arranging arranging(window, home);
    arranging.close_alone(wanted);
    arranging.open(wanted);
    arranging.close_others();
    arranging.raise_and_size(wanted);
}

}  // namespace pastoso::main
