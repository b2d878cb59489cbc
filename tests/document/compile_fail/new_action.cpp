// A new action compiles with its whole table; without a trait, or without any table, it does not.
#include "document/actions/actions.hpp"

namespace pastoso::document {

struct Sigh {
    double loudness = 0.5;
};

#ifndef WITHOUT_TABLE
template <>
struct Table<Sigh> {
    static constexpr ActionTraits kTraits{
        .key = "sigh",
        .since = 9,
        .meaning = "sighs",
        .undo = UndoRole::NoStep,
        .step = "",
#ifndef WITHOUT_CHANGES
        .changes_painting = false,
#endif
#ifndef WITHOUT_STROKE
        .stroke = StrokeRole::GoesOn,
#endif
#ifndef WITHOUT_SET_UP
        .in_set_up = false,
#endif
    };
    static constexpr void fields(auto&& visit) {
        visit(Number<At<&Sigh::loudness>>{"loudness", "loudness of the sigh", "", 0.0, 1.0,
                                          Presence::Required});
    }
};
#endif

const ActionTraits& traits_of_a_new_action() {
    return Table<Sigh>::kTraits;
}

}  // namespace pastoso::document
