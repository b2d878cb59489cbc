// The brush in hand: taking, dipping and cleaning it.
#pragma once

#include "brush/preset.hpp"
#include "document/actions/table.hpp"
#include "document/paint_recipe.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>

namespace pastoso::document {

struct LivingPainting;
struct PaintingValue;

/// Takes a clean brush in hand; what the old one held goes to the ledger.
struct TakeBrush {
    std::string preset;
    double size_mm = 0.0;  ///< width of the tip; 0: the preset's own
    std::uint32_t seed = 1;
    /// A preset that does not come with the program: all of it, as brush::preset_to_json() writes it.
    std::string definition{};
    friend bool operator==(const TakeBrush&, const TakeBrush&) = default;
};
struct LoadPaint {  ///< dips the brush
    PaintRecipe paint{};
    PaintRecipe second{};          ///< no ingredients: the brush holds `paint` alone
    double second_share = 0.0;     ///< mean share of the second paint, 0 to 1
    double share_variation = 0.0;  ///< how much the share differs from bristle to bristle, 0 to 1
    bool side_by_side = false;     ///< double load: one half of the tip each, instead of half-mixed
    bool tip_only = false;  ///< dips only the hairs that reach deepest; the others stay as they are
    double fill = 1.0;      ///< of the brush's capacity, 0 to 1.2
    friend bool operator==(const LoadPaint&, const LoadPaint&) = default;
};
struct CleanBrush {      ///< wipes paint off the brush, into the ledger
    double share = 1.0;  ///< of what every bristle holds, 0 to 1; less than all blots it
    friend bool operator==(const CleanBrush&, const CleanBrush&) = default;
};

/// A clean brush lies aside; what the one held that lay there goes to the ledger.
struct LayBrushAside {
    TakeBrush brush{};
    friend bool operator==(const LayBrushAside&, const LayBrushAside&) = default;
};
/// The brush in hand and the one that lies aside change places, as they are; none where none lies there.
struct SwapBrushes {
    friend bool operator==(const SwapBrushes&, const SwapBrushes&) = default;
};

using BrushActions = ActionList<TakeBrush, LoadPaint, CleanBrush, LayBrushAside, SwapBrushes>;

/// The preset that a brush is taken of: its own definition, or the bundled one of that name. Throws
/// InputError as brush::parse_preset() and brush::find_preset() do.
brush::Preset preset_of(const TakeBrush& take);

void check_whole(const TakeBrush& take);
void check_whole(const LoadPaint& load);
void check_whole(const LayBrushAside& lay);
void check_possible(const LoadPaint& load, const LivingPainting& painting);
void put_in_hand(const TakeBrush& take, PaintingValue& painting);
/// All of its preset with it: one that comes with the program may be another in a later version.
std::optional<TakeBrush> in_hand(std::type_identity<TakeBrush>, const PaintingValue& painting);
void put_in_hand(const LayBrushAside& lay, PaintingValue& painting);
std::optional<LayBrushAside> in_hand(std::type_identity<LayBrushAside>, const PaintingValue& painting);
void apply(const TakeBrush& take, LivingPainting& painting);
void apply(const LoadPaint& load, LivingPainting& painting);
void apply(const CleanBrush& clean, LivingPainting& painting);
void apply(const LayBrushAside& lay, LivingPainting& painting);
void apply(const SwapBrushes& swap, LivingPainting& painting);

template <>
struct Table<TakeBrush> {
    static constexpr ActionTraits kTraits{
        .key = "take_brush",
        .since = 1,
        .meaning = "takes a clean brush in hand; what the old one held is counted as wiped off",
        .undo = UndoRole::NoStep,
        .step = "",
        .changes_painting = false,
        .stroke = StrokeRole::Ends,
        .in_set_up = true};
    static constexpr void fields(auto&& visit) {
        visit(Value<At<>>{.key = "preset",
                          .name = "preset",
                          .presence = Presence::Required,
                          .note = "the name of one that comes with the program, or all of a preset "
                                  "as in its file"});
        visit(Number<At<&TakeBrush::size_mm>>{"size_mm", core::Pattern<0>("width of the brush"), "mm",
                                              0.5, 200.0, Presence::Optional, "0: the preset's own"});
        visit(Whole<At<&TakeBrush::seed>>{"seed", core::Pattern<0>("seed of the brush"), 0, UINT32_MAX,
                                          Presence::Optional});
    }
};

template <>
struct Table<LoadPaint> {
    static constexpr ActionTraits kTraits{.key = "load_paint",
                                          .since = 1,
                                          .meaning = "dips the brush",
                                          .undo = UndoRole::NoStep,
                                          .step = "",
                                          .changes_painting = false,
                                          .stroke = StrokeRole::Ends,
                                          .in_set_up = false};
    static constexpr void fields(auto&& visit) {
        using enum Presence;
        visit(Value<At<&LoadPaint::paint>>{"paint", "paint", Required});
        visit(Value<At<&LoadPaint::second>>{"second", "second paint", Optional, "for two at once"});
        visit(Number<At<&LoadPaint::second_share>>{"second_share",
                                                   core::Pattern<0>("share of the second paint"), "",
                                                   0.0, 1.0, Optional, "the mean of all bristles"});
        visit(Number<At<&LoadPaint::share_variation>>{"share_variation",
                                                      core::Pattern<0>("variation of the share"), "",
                                                      0.0, 1.0, Optional, "from bristle to bristle"});
        visit(Truth<At<&LoadPaint::side_by_side>>{"side_by_side", "double load", Optional,
                                                  "one half of the tip in each paint"});
        visit(Truth<At<&LoadPaint::tip_only>>{
            "tip_only", "dip of the tip alone", Optional,
            "only the hairs that reach deepest; the others keep what they hold", 3});
        visit(Number<At<&LoadPaint::fill>>{"fill", core::Pattern<0>("fill of the brush"), "", 0.0, 1.2,
                                           Optional, "of what it can hold"});
    }
};

template <>
struct Table<CleanBrush> {
    static constexpr ActionTraits kTraits{.key = "clean_brush",
                                          .since = 1,
                                          .meaning = "wipes the brush",
                                          .undo = UndoRole::NoStep,
                                          .step = "",
                                          .changes_painting = false,
                                          .stroke = StrokeRole::Ends,
                                          .in_set_up = false};
    static constexpr void fields(auto&& visit) {
        visit(Number<At<&CleanBrush::share>>{
            "share", core::Pattern<0>("share that is wiped off the brush"), "", 0.0, 1.0,
            Presence::Optional, "of what every bristle holds"});
    }
};

template <>
struct Table<LayBrushAside> {
    static constexpr ActionTraits kTraits{
        .key = "lay_brush_aside",
        .since = 11,
        .meaning = "a clean brush lies aside; what the one held that lay there is counted as wiped off",
        .undo = UndoRole::NoStep,
        .step = "",
        .changes_painting = false,
        .stroke = StrokeRole::GoesOn,
        .in_set_up = true};
    static constexpr void fields(auto&& visit) { visit(Part<At<&LayBrushAside::brush>>{}); }
};

template <>
struct Table<SwapBrushes> {
    static constexpr ActionTraits kTraits{
        .key = "swap_brushes",
        .since = 11,
        .meaning = "the brush in hand and the one that lies aside change places, with what they hold",
        .undo = UndoRole::NoStep,
        .step = "",
        .changes_painting = false,
        .stroke = StrokeRole::Ends,
        .in_set_up = false};
    static constexpr void fields(auto&&) {}
};

}  // namespace pastoso::document
