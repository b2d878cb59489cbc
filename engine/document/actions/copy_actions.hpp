// Paint that is copied, and laid down once more.
#pragma once

#include "document/actions/layer_look_table.hpp"
#include "document/actions/pen_actions.hpp"
#include "document/actions/table.hpp"
#include "film/state.hpp"

#include <memory>
#include <string>

namespace pastoso::document {

struct LivingPainting;

/// What was copied of a layer, apart from what it lay on, on a canvas that may have been another one.
using CopiedPaint = std::shared_ptr<const film::FilmState>;

/// Keeps a copy of a layer's paint, or of what is selected of it, wet and dry as it is now, for
/// PastePaint. It takes the place of the one before; Undo leaves it.
struct CopyPaint {
    LayerId layer = 0;  ///< 0: all that is visible, merged (layers/merging.hpp)
    friend bool operator==(const CopyPaint&, const CopyPaint&) = default;
};
/// Keeps paint that was copied in another painting, as if it had been copied here where it lay there.
struct BringPaint {
    CopiedPaint paint;  ///< not null; in cells of its own size

    friend bool operator==(const BringPaint& a, const BringPaint& b) {
        return a.paint == b.paint ||
               (a.paint && b.paint && film::state_hash(*a.paint) == film::state_hash(*b.paint));
    }
};
/// Lays what was copied onto a new layer above the active one, which becomes active, where it was or so
/// far from there, in whole cells. Its paint comes out of the tubes, as far as it lies on the canvas,
/// and begins at rest.
struct PastePaint {
    std::string name;  ///< of the layer
    double move_x_mm = 0.0, move_y_mm = 0.0;
    friend bool operator==(const PastePaint&, const PastePaint&) = default;
};

using CopyActions = ActionList<CopyPaint, BringPaint, PastePaint>;

void apply(const CopyPaint& copy, LivingPainting& painting);
void check_whole(const BringPaint& bring);
void apply(const BringPaint& bring, LivingPainting& painting);
void check_possible(const PastePaint& paste, const LivingPainting& painting);
void apply(const PastePaint& paste, LivingPainting& painting);

template <>
struct Table<CopyPaint> {
    static constexpr ActionTraits kTraits{
        .key = "copy_paint",
        .since = 12,
        .meaning =
            "keeps a copy of a layer's paint, or of what is selected of it, as it is at that "
            "tick; it changes no paint ([0083](decisions/0083-copied-paint.md))",
        .undo = UndoRole::NoStep,
        .step = "",
        .changes_painting = false,
        .stroke = StrokeRole::Ends,
        .in_set_up = false};
    static constexpr void fields(auto&& visit) {
        visit(Whole<At<&CopyPaint::layer>>{"layer", core::Pattern<0>("number of the layer"), 0, kMostId,
                                           Presence::Optional, "0: all that is visible, merged"});
    }
};

template <>
struct Table<BringPaint> {
    static constexpr ActionTraits kTraits{
        .key = "bring_paint",
        .since = 16,
        .meaning =
            "keeps paint that was copied in another painting, as `copy_paint` does; it changes no "
            "paint ([0094](decisions/0094-paint-of-another-painting.md))",
        .undo = UndoRole::NoStep,
        .step = "",
        .changes_painting = false,
        .stroke = StrokeRole::Ends,
        .in_set_up = false};
    static constexpr void fields(auto&& visit) {
        visit(Value<At<&BringPaint::paint>>{
            "paint", "copied paint", Presence::Required,
            "in base64, as it lies on the clipboard ([form](file-format.md#copied-paint))"});
    }
};

template <>
struct Table<PastePaint> {
    static constexpr ActionTraits kTraits =
        change("paste_paint", 12, step_name("Paint pasted"),
               "lays what was copied last onto a new layer above the active one, which becomes active; "
               "its paint comes out of the tubes");
    static constexpr void fields(auto&& visit) {
        constexpr double kFar_mm = kMaxPenPosition_mm;
        visit(Text<At<&PastePaint::name>>{"name", core::Pattern<0>("name of a layer"), kMostLayerName,
                                          Presence::Required});
        visit(Pair<At<&PastePaint::move_x_mm>, At<&PastePaint::move_y_mm>>{
            "move_mm", core::Pattern<0>("way from where it was copied"), "mm", -kFar_mm, kFar_mm,
            Presence::Written, "in whole cells"});
    }
};

}  // namespace pastoso::document
