// The mixing well: paint out of tubes, and wiping it.
#pragma once

#include "document/actions/table.hpp"
#include "document/paint_recipe.hpp"

namespace pastoso::document {

struct LivingPainting;

inline constexpr double kWellWidth_mm = 120.0;
inline constexpr double kWellHeight_mm = 90.0;

inline constexpr double kLeastSqueeze_mm3 = 1.0;
inline constexpr double kMostSqueeze_mm3 = 5000.0;

/// Squeezes paint out of a tube onto the mixing well, in the medium in hand. What has no capacity left
/// stays in the tube.
struct SqueezePaint {
    PaintRecipe paint{};
    double volume_mm3 = 250.0;  ///< kLeastSqueeze_mm3 to kMostSqueeze_mm3
    double x_mm = 0.0;          ///< on the well
    double y_mm = 0.0;
    bool joins = false;  ///< the undo step before it, where paint was squeezed out there, too
    friend bool operator==(const SqueezePaint&, const SqueezePaint&) = default;
};
struct CleanWell {  ///< wipes the mixing well bare, into the ledger
    friend bool operator==(const CleanWell&, const CleanWell&) = default;
};

using WellActions = ActionList<SqueezePaint, CleanWell>;

void check_whole(const SqueezePaint& squeeze);
bool changes_anything(const CleanWell& clean, const LivingPainting& painting);
void apply(const SqueezePaint& squeeze, LivingPainting& painting);
void apply(const CleanWell& clean, LivingPainting& painting);

template <>
struct Table<SqueezePaint> {
    static constexpr ActionTraits kTraits =
        change("squeeze_paint", 4, step_name("Paint squeezed out"),
               "paint out of the tube onto the mixing well, moved inwards where the heap would hang "
               "over the rim");
    static constexpr UndoRole undo_role(const SqueezePaint& squeeze) {
        return squeeze.joins ? UndoRole::MaybeStep : UndoRole::Step;
    }
    static constexpr void fields(auto&& visit) {
        using enum Presence;
        visit(Value<At<&SqueezePaint::paint>>{"paint", "paint", Required});
        visit(Number<At<&SqueezePaint::volume_mm3>>{
            "volume_mm3", core::Pattern<0>("volume of the squeezed paint"), "mm3", kLeastSqueeze_mm3,
            kMostSqueeze_mm3, Written});
        visit(Number<At<&SqueezePaint::x_mm>>{"x_mm", core::Pattern<0>("x of the squeezed paint"), "mm",
                                              0.0, kWellWidth_mm, Required, "on the well"});
        visit(Number<At<&SqueezePaint::y_mm>>{"y_mm", core::Pattern<0>("y of the squeezed paint"), "mm",
                                              0.0, kWellHeight_mm, Required, "on the well"});
        visit(Truth<At<&SqueezePaint::joins>>{
            .key = "joins",
            .name = "joins",
            .presence = Optional,
            .note = "part of the undo step before it, where that squeezed out paint, too",
            .since = 15});
    }
};

template <>
struct Table<CleanWell> {
    static constexpr ActionTraits kTraits{.key = "clean_well",
                                          .since = 4,
                                          .meaning = "wipes the mixing well bare",
                                          .undo = UndoRole::MaybeStep,
                                          .step = step_name("Mixing well wiped"),
                                          .changes_painting = true,
                                          .stroke = StrokeRole::Ends,
                                          .in_set_up = false};
    static constexpr void fields(auto&&) {}
};

}  // namespace pastoso::document
