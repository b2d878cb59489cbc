// How the panels stand around the canvas, as a value: read from a window, kept under a name, mirrored.
#pragma once

#include "files/json_place.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pastoso::tools {

/// Panels one behind the other, of which one is seen.
struct PanelTabs {
    std::vector<std::string> panels;  ///< by name, at least one
    std::size_t raised = 0;           ///< the place of the one that is seen
    int length_px = 1;  ///< along the side, at least 1; in proportion to the others of the side
    friend bool operator==(const PanelTabs&, const PanelTabs&) = default;
};

/// What stands along one side of the canvas, from the top or from the left.
struct PanelSide {
    std::vector<PanelTabs> tabs;
    int breadth_px = 0;  ///< 0: as narrow as what stands there allows
    friend bool operator==(const PanelSide&, const PanelSide&) = default;
};

/// A panel in a window of its own.
struct FloatingPanel {
    std::string panel;
    int x_px = 0, y_px = 0;  ///< on the screen
    int width_px = 0, height_px = 0;
    friend bool operator==(const FloatingPanel&, const FloatingPanel&) = default;
};

enum class Side { Left, Right, Top, Bottom };
inline constexpr std::array kSides = {Side::Left, Side::Right, Side::Top, Side::Bottom};

/// Panels that it does not name are closed.
struct PanelArrangement {
    std::array<PanelSide, kSides.size()> sides;
    std::vector<FloatingPanel> floating;

    PanelSide& at(Side side) { return sides[static_cast<std::size_t>(side)]; }
    const PanelSide& at(Side side) const { return sides[static_cast<std::size_t>(side)]; }
    friend bool operator==(const PanelArrangement&, const PanelArrangement&) = default;
};

/// What stands on the left stands on the right, and the other way round.
PanelArrangement mirrored(PanelArrangement arrangement);

/// What stands in one place along a side wants of it.
struct LengthWish {
    int share_px = 1;  ///< at least 1, in proportion to the others where there is more room
    std::optional<int> needed_px{};  ///< it takes no more than this, and leaves the rest to the others
};

/// What each gets of `room_px`, at least 1, which they fill to the pixel where that is possible: its
/// share, or less. Where there is none to leave the rest to, all have their shares.
std::vector<int> shared_lengths(const std::vector<LengthWish>& wishes, int room_px);

/// {"left": {"breadth_px": 252, "tabs": [{"panels": [...], "raised": 0, "length_px": 300}]},
/// "floating": [...]}; sides with nothing are left out.
files::Json arrangement_json(const PanelArrangement& arrangement);

/// Throws InputError that names the place of anything malformed, and of a panel that stands twice.
PanelArrangement read_arrangement(const files::JsonPlace& place);

}  // namespace pastoso::tools
