// What can happen to the board of references (references.hpp): it is no paint, and in no picture of the
// painting.
#pragma once

#include "document/actions/layer_look_table.hpp"
#include "document/actions/pen_actions.hpp"
#include "document/actions/table.hpp"
#include "document/references.hpp"

#include <string>

namespace pastoso::document {

struct LivingPainting;

inline constexpr double kLeastReference_mm = 1.0;

struct LayReference {  ///< above all others, opaque and in its colours
    std::string name;
    ReferencePlace place;
    /// Not null; 1 to pigment::kMostPictureSide_px a side, pigment::kMostPicturePixels in all.
    SharedReferencePicture picture;
    bool joins = false;  ///< the undo step before it, where a reference was laid there, too

    friend bool operator==(const LayReference& a, const LayReference& b) {
        return a.name == b.name && a.place == b.place && a.joins == b.joins &&
               (a.picture == b.picture || (a.picture && b.picture && *a.picture == *b.picture));
    }
};
struct SetReference {  ///< how it lies and looks; nothing happens where there is none of that number
    ReferenceId reference = 0;
    ReferencePlace place;
    ReferenceLook look;
    friend bool operator==(const SetReference&, const SetReference&) = default;
};
struct MoveReference {  ///< in the order of them; as SetReference where there is none
    ReferenceId reference = 0;
    int place = 0;  ///< how many of the others are below it afterwards
    friend bool operator==(const MoveReference&, const MoveReference&) = default;
};
struct RemoveReference {  ///< as SetReference where there is none
    ReferenceId reference = 0;
    friend bool operator==(const RemoveReference&, const RemoveReference&) = default;
};

using ReferenceActions = ActionList<LayReference, SetReference, MoveReference, RemoveReference>;

bool changes_anything(const SetReference& set, const LivingPainting& painting);
bool changes_anything(const MoveReference& move, const LivingPainting& painting);
bool changes_anything(const RemoveReference& remove, const LivingPainting& painting);
void check_whole(const LayReference& lay);
/// Throws InputError where the board is full.
void check_possible(const LayReference& lay, const LivingPainting& painting);
void apply(const LayReference& lay, LivingPainting& painting);
void apply(const SetReference& set, LivingPainting& painting);
void apply(const MoveReference& move, LivingPainting& painting);
void apply(const RemoveReference& remove, LivingPainting& painting);

template <auto kMember>
inline constexpr Whole<At<kMember>> kReferenceNumber{
    "reference", core::Pattern<0>("number of the reference"), 1, kMostId, Presence::Required};

template <>
struct Table<ReferencePlace> {
    static constexpr void fields(auto&& visit) {
        using Place = ReferencePlace;
        using enum Presence;
        constexpr double kFar_mm = kMaxPenPosition_mm;
        visit(Number<At<&Place::x_mm>>{"x_mm", core::Pattern<0>("x of the reference"), "mm", -kFar_mm,
                                       kFar_mm, Required, "of its middle, on a board of its own"});
        visit(Number<At<&Place::y_mm>>{"y_mm", core::Pattern<0>("y of the reference"), "mm", -kFar_mm,
                                       kFar_mm, Required});
        visit(Number<At<&Place::width_mm>>{"width_mm", core::Pattern<0>("width of the reference"), "mm",
                                           kLeastReference_mm, kFar_mm, Required,
                                           "its height follows in proportion"});
        visit(Number<At<&Place::turn_deg>>{"turn_deg", core::Pattern<0>("turn of the reference"),
                                           core::Pattern<0>("degrees"), -360.0, 360.0, Optional,
                                           "clockwise"});
        visit(Truth<At<&Place::mirrored>>{"mirrored", "mirrored", Optional,
                                          "left and right, before it is turned"});
    }
};

template <>
struct Table<ReferenceLook> {
    static constexpr void fields(auto&& visit) {
        using enum Presence;
        visit(Number<At<&ReferenceLook::opacity>>{
            "opacity", core::Pattern<0>("opacity of the reference"), "", 0.0, 1.0, Optional});
        visit(Truth<At<&ReferenceLook::grey>>{"grey", "grey", Optional, "shown without its colours"});
    }
};

template <>
struct Table<LayReference> {
    static constexpr ActionTraits kTraits = change(
        "lay_reference", 14, step_name("Reference picture"),
        "lays a picture on the board of references, above all others. References are numbered from 1, "
        "in the order in which they come ([0086](decisions/0086-reference-board.md))");
    static constexpr UndoRole undo_role(const LayReference& lay) {
        return lay.joins ? UndoRole::MaybeStep : UndoRole::Step;
    }
    static constexpr void fields(auto&& visit) {
        visit(Text<At<&LayReference::name>>{"name", core::Pattern<0>("name of a reference"),
                                            kMostReferenceName, Presence::Required});
        visit(Part<At<&LayReference::place>>{});
        visit(Value<At<&LayReference::picture>>{
            "png", "picture", Presence::Required,
            "a PNG file in base64: sRGB, with or without transparency, at most 32 768 pixels a side, "
            "100 million in all, 200 million on the board"});
        visit(Truth<At<&LayReference::joins>>{
            .key = "joins",
            .name = "joins",
            .presence = Presence::Optional,
            .note = "part of the undo step before it, where that laid a reference, too",
            .since = 15});
    }
};

template <>
struct Table<SetReference> {
    static constexpr ActionTraits kTraits =
        possible_change("set_reference", 14, step_name("Place of a reference"),
                        "how a reference lies on the board from now on, and how it shows");
    static constexpr void fields(auto&& visit) {
        visit(kReferenceNumber<&SetReference::reference>);
        visit(Part<At<&SetReference::place>>{});
        visit(Part<At<&SetReference::look>>{});
    }
};

template <>
struct Table<MoveReference> {
    static constexpr ActionTraits kTraits = possible_change(
        "move_reference", 14, step_name("Order of the references"), "changes their order");
    static constexpr void fields(auto&& visit) {
        visit(kReferenceNumber<&MoveReference::reference>);
        visit(Whole<At<&MoveReference::place>>{"place", core::Pattern<0>("position of the reference"), 0,
                                               kMostReferences, Presence::Required,
                                               "how many of the others are below it afterwards"});
    }
};

template <>
struct Table<RemoveReference> {
    static constexpr ActionTraits kTraits =
        possible_change("remove_reference", 14, step_name("Reference taken away"), "");
    static constexpr void fields(auto&& visit) { visit(kReferenceNumber<&RemoveReference::reference>); }
};

}  // namespace pastoso::document
