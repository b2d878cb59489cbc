// The medium in hand, and how paint dries.
#pragma once

#include "document/actions/pen_actions.hpp"
#include "document/actions/table.hpp"
#include "film/cell/drying_air.hpp"
#include "film/medium.hpp"
#include "film/thinning.hpp"

#include <optional>
#include <string>
#include <type_traits>

namespace pastoso::document {

struct LivingPainting;
struct PaintingValue;
struct UndoStep;

/// A second of paint time lasts at most this many seconds of drying.
inline constexpr double kFastestDrying = 1e5;

/// Takes another medium in hand: paint loaded from now on is of it. What is wet keeps its own.
struct UseMedium {
    std::string name;                   ///< of one that comes with the program
    std::optional<film::Medium> own{};  ///< its numbers as the painter changed them, under its name
    double paint_share = 1.0;           ///< the rest is what thins it (film/thinning.hpp)
    friend bool operator==(const UseMedium&, const UseMedium&) = default;
};
struct SetDrying {  ///< how fast paint on the canvas dries from now on; in the well it stays open
    film::DryingAir air;
    friend bool operator==(const SetDrying&, const SetDrying&) = default;
};
struct DryNow {  ///< all wet paint on the canvas becomes dry at once, or what is selected of it
    friend bool operator==(const DryNow&, const DryNow&) = default;
};

using MediaActions = ActionList<UseMedium, SetDrying, DryNow>;

/// The numbers of a medium in hand, thinned. Throws InputError as film::find_medium() does.
film::Medium medium_of(const UseMedium& use);

void check_whole(const UseMedium& use);
void check_possible(const DryNow& dry, const LivingPainting& painting);
UndoStep undo_step(const DryNow& dry, const LivingPainting& painting);
void put_in_hand(const UseMedium& use, PaintingValue& painting);
void put_in_hand(const SetDrying& set, PaintingValue& painting);
UseMedium in_hand(std::type_identity<UseMedium>, const PaintingValue& painting);
SetDrying in_hand(std::type_identity<SetDrying>, const PaintingValue& painting);
void apply(const UseMedium& use, LivingPainting& painting);
void apply(const DryNow& dry, LivingPainting& painting);

template <>
struct Table<UseMedium> {
    static constexpr ActionTraits kTraits = setting(
        "use_medium", 1,
        "takes a medium in hand, which the next paint is mixed with. Paint brings all numbers of its "
        "medium along");
    static constexpr void fields(auto&& visit) {
        visit(Value<At<&UseMedium::name>>{"name", "medium", Presence::Required});
        visit(Value<At<&UseMedium::own>>{
            "numbers", "numbers of one's own", Presence::Optional,
            "any of the [numbers of a medium](media.md), which take the place of its own", 8});
        visit(Number<At<&UseMedium::paint_share>>{
            "paint_share", core::Pattern<0>("share of paint"), "", film::kLeastPaintShare, 1.0,
            Presence::Optional, "by volume; the rest is what [thins the medium](media.md)", 10});
    }
};

template <>
struct Table<SetDrying> {
    static constexpr ActionTraits kTraits = setting("set_drying", 2, "how fast paint dries from now on");
    template <auto kMember>
    using InAir = At<&SetDrying::air, kMember>;
    static constexpr void fields(auto&& visit) {
        using Air = film::DryingAir;
        using enum Presence;
        visit(Number<InAir<&Air::speed>>{"speed", core::Pattern<0>("speed of drying"), "", 0.0,
                                         kFastestDrying, Required,
                                         "seconds of drying in a second of paint time"});
        visit(Number<InAir<&Air::fan>>{"fan", core::Pattern<0>("strength of the fan"), "", 1.0, 1000.0,
                                       Optional,
                                       "how many times faster paint dries in its middle; 1: none"});
        visit(Number<InAir<&Air::fan_x_mm>>{"fan_x_mm", core::Pattern<0>("x of the fan"), "mm",
                                            -kMaxPenPosition_mm, kMaxPenPosition_mm, Optional});
        visit(Number<InAir<&Air::fan_y_mm>>{"fan_y_mm", core::Pattern<0>("y of the fan"), "mm",
                                            -kMaxPenPosition_mm, kMaxPenPosition_mm, Optional});
        visit(Number<InAir<&Air::fan_radius_mm>>{"fan_radius_mm", core::Pattern<0>("radius of the fan"),
                                                 "mm", 0.0, kMaxPenPosition_mm, Optional,
                                                 "0: everywhere; its effect falls off smoothly"});
    }
};

template <>
struct Table<DryNow> {
    static constexpr ActionTraits kTraits =
        change("dry_now", 2, step_name("Dry now"),
               "all wet paint of the active layer becomes dry, or what is selected of it");
    static constexpr void fields(auto&&) {}
};

}  // namespace pastoso::document
