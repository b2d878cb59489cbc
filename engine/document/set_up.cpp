#include "document/set_up.hpp"

#include <optional>
#include <type_traits>

namespace pastoso::document {

Recording set_up_of(const PaintingValue& painting) {
    Recording recording{.canvas = painting.bare->settings, .events = {}};
    AllActions::for_each([&]<class A>(std::type_identity<A> type) {
        if constexpr (Table<A>::kTraits.in_set_up) {
            const std::optional<A> action = in_hand(type, painting);
            if (action) recording.events.push_back({0, *action});
        }
    });
    return recording;
}

void set_up(const Recording& recording, PaintingValue& painting) {
    for (const Event& event : recording.events) {
        std::visit(
            [&]<class A>(const A& action) {
                if constexpr (Table<A>::kTraits.in_set_up) put_in_hand(action, painting);
            },
            event.action);
    }
}

}  // namespace pastoso::document
