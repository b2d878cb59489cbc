// The fields that actions on layers and on groups share.
#pragma once

#include "document/actions/table.hpp"
#include "document/layer_look.hpp"

#include <limits>

namespace pastoso::document {

inline constexpr std::int64_t kMostId = std::numeric_limits<LayerId>::max();

template <auto kMember>
inline constexpr Whole<At<kMember>> kLayerNumber{"layer", core::Pattern<0>("number of the layer"), 1,
                                                 kMostId, Presence::Required};
template <auto kMember>
inline constexpr Whole<At<kMember>> kGroupNumber{"group", core::Pattern<0>("number of the group"), 1,
                                                 kMostId, Presence::Required};

template <>
struct Table<LayerLook> {
    static constexpr void fields(auto&& visit) {
        using enum Presence;
        visit(Text<At<&LayerLook::name>>{"name", core::Pattern<0>("name of a layer"), kMostLayerName,
                                         Required});
        visit(Truth<At<&LayerLook::visible>>{"visible", "visible", Optional});
        visit(Truth<At<&LayerLook::locked>>{"locked", "locked", Optional, "nothing is painted on it"});
        visit(Truth<At<&LayerLook::bare_locked>>{"bare_locked", "bare locked", Optional,
                                                 "tools change only what of it has paint", 14});
        visit(Truth<At<&LayerLook::clipped>>{
            "clipped", "clipped", Optional,
            "only what lies over paint of the nearest layer below it in its group that is not clipped "
            "shows ([0091](decisions/0091-clipped-layers.md)); of layers alone, not of groups",
            15});
        visit(Number<At<&LayerLook::opacity>>{"opacity", core::Pattern<0>("opacity of the layer"), "",
                                              0.0, 1.0, Optional});
    }
};

}  // namespace pastoso::document
