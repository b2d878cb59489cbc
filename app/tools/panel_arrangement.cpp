#include "tools/panel_arrangement.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <set>
#include <utility>

namespace pastoso::tools {
namespace {

using files::Json;
using files::JsonPlace;

/// More than any screen has.
constexpr std::int64_t kMost_px = 100000;

constexpr const char* kNames[] = {"left", "right", "top", "bottom"};

const char* name_of(Side side) {
    return kNames[static_cast<std::size_t>(side)];
}

Json tabs_json(const PanelTabs& tabs) {
    return {{"panels", tabs.panels}, {"raised", tabs.raised}, {"length_px", tabs.length_px}};
}

Json side_json(const PanelSide& side) {
    Json tabs = Json::array();
    for (const PanelTabs& one : side.tabs)
        tabs.push_back(tabs_json(one));
    return {{"breadth_px", side.breadth_px}, {"tabs", std::move(tabs)}};
}

Json floating_json(const FloatingPanel& floating) {
    return {{"panel", floating.panel},
            {"x_px", floating.x_px},
            {"y_px", floating.y_px},
            {"width_px", floating.width_px},
            {"height_px", floating.height_px}};
}

/// A panel stands in one place.
class Panels {
  public:
    std::string read(const JsonPlace& place) {
        const std::string panel = place.text();
        if (!read_.insert(panel).second) place.fail("the panel %1 stands there twice.", panel);
        return panel;
    }

  private:
    std::set<std::string> read_;
};

PanelTabs read_tabs(const JsonPlace& place, Panels& panels) {
    place.allow_only({"panels", "raised", "length_px"});
    const JsonPlace names = place.entry("panels");
    if (names.size() == 0) names.fail("there is no panel.");
    PanelTabs tabs;
    for (std::size_t i = 0; i < names.size(); ++i)
        tabs.panels.push_back(panels.read(names.element(i)));
    const auto last = static_cast<std::int64_t>(tabs.panels.size()) - 1;
    tabs.raised = static_cast<std::size_t>(place.entry("raised").integer(0, last));
    tabs.length_px = static_cast<int>(place.entry("length_px").integer(1, kMost_px));
    return tabs;
}

PanelSide read_side(const JsonPlace& place, Panels& panels) {
    place.allow_only({"breadth_px", "tabs"});
    PanelSide side;
    side.breadth_px = static_cast<int>(place.entry("breadth_px").integer(0, kMost_px));
    const JsonPlace tabs = place.entry("tabs");
    for (std::size_t i = 0; i < tabs.size(); ++i)
        side.tabs.push_back(read_tabs(tabs.element(i), panels));
    return side;
}

FloatingPanel read_floating(const JsonPlace& place, Panels& panels) {
    place.allow_only({"panel", "x_px", "y_px", "width_px", "height_px"});
    const auto number = [&place](const char* key, std::int64_t least) {
        return static_cast<int>(place.entry(key).integer(least, kMost_px));
    };
    return {panels.read(place.entry("panel")), number("x_px", -kMost_px), number("y_px", -kMost_px),
            number("width_px", 1), number("height_px", 1)};
}

/// More room than all shares is divided in proportion. Of less, each gives way alike, as panels do in a
/// window that becomes lower. Rounded where each ends, so that nothing is left over.
std::vector<int> portions(const std::vector<int>& shares, int room_px) {
    const std::int64_t all = std::accumulate(shares.begin(), shares.end(), std::int64_t{0});
    const std::int64_t lacking_px = std::max(std::int64_t{0}, all - room_px);
    const auto count = static_cast<std::int64_t>(shares.size());
    std::vector<int> lengths;
    std::int64_t before = 0;
    for (std::int64_t i = 0; i < count; ++i) {
        const int share = shares[static_cast<std::size_t>(i)];
        const std::int64_t lost_px = lacking_px * (i + 1) / count - lacking_px * i / count;
        const std::int64_t gained_px = room_px * (before + share) / all - room_px * before / all;
        before += share;
        lengths.push_back(
            static_cast<int>(lacking_px > 0 ? std::max(std::int64_t{1}, share - lost_px) : gained_px));
    }
    return lengths;
}

}  // namespace

PanelArrangement mirrored(PanelArrangement arrangement) {
    std::swap(arrangement.at(Side::Left), arrangement.at(Side::Right));
    return arrangement;
}

std::vector<int> shared_lengths(const std::vector<LengthWish>& wishes, int room_px) {
    std::vector<int> shares, open_shares;
    for (const LengthWish& wish : wishes) {
        shares.push_back(wish.share_px);
        if (!wish.needed_px) open_shares.push_back(wish.share_px);
    }
    std::vector<int> lengths = portions(shares, room_px);
    if (open_shares.empty()) return lengths;
    int rest_px = room_px;
    for (std::size_t i = 0; i < wishes.size(); ++i) {
        if (!wishes[i].needed_px) continue;
        lengths[i] = std::min(lengths[i], *wishes[i].needed_px);
        rest_px -= lengths[i];
    }
    const std::vector<int> open_lengths = portions(open_shares, rest_px);
    auto next = open_lengths.begin();
    for (std::size_t i = 0; i < wishes.size(); ++i)
        if (!wishes[i].needed_px) lengths[i] = *next++;
    return lengths;
}

Json arrangement_json(const PanelArrangement& arrangement) {
    Json json = Json::object();
    for (const Side side : kSides)
        if (!arrangement.at(side).tabs.empty()) json[name_of(side)] = side_json(arrangement.at(side));
    Json floating = Json::array();
    for (const FloatingPanel& panel : arrangement.floating)
        floating.push_back(floating_json(panel));
    if (!floating.empty()) json["floating"] = std::move(floating);
    return json;
}

PanelArrangement read_arrangement(const JsonPlace& place) {
    place.allow_only({"left", "right", "top", "bottom", "floating"});
    PanelArrangement arrangement;
    Panels panels;
    for (const Side side : kSides)
        if (const auto read = place.optional_entry(name_of(side)))
            arrangement.at(side) = read_side(*read, panels);
    if (const auto floating = place.optional_entry("floating"))
        for (std::size_t i = 0; i < floating->size(); ++i)
            arrangement.floating.push_back(read_floating(floating->element(i), panels));
    return arrangement;
}

}  // namespace pastoso::tools
