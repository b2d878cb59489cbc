// Going back and forth in what was done.
#pragma once

#include "document/actions/table.hpp"

namespace pastoso::document {

struct LivingPainting;

struct Undo {
    friend bool operator==(const Undo&, const Undo&) = default;
};
struct Redo {
    friend bool operator==(const Redo&, const Redo&) = default;
};

using HistoryActions = ActionList<Undo, Redo>;

void apply(const Undo& undo, LivingPainting& painting);
void apply(const Redo& redo, LivingPainting& painting);

template <>
struct Table<Undo> {
    static constexpr ActionTraits kTraits{.key = "undo",
                                          .since = 1,
                                          .meaning = "takes the latest undo step back",
                                          .undo = UndoRole::Undo,
                                          .step = "",
                                          .changes_painting = true,
                                          .stroke = StrokeRole::Ends,
                                          .in_set_up = false};
    static constexpr void fields(auto&&) {}
};

template <>
struct Table<Redo> {
    static constexpr ActionTraits kTraits{.key = "redo",
                                          .since = 1,
                                          .meaning = "does again what Undo took back last",
                                          .undo = UndoRole::Redo,
                                          .step = "",
                                          .changes_painting = true,
                                          .stroke = StrokeRole::Ends,
                                          .in_set_up = false};
    static constexpr void fields(auto&&) {}
};

}  // namespace pastoso::document
