// What can happen to the layers of a painting (layers.hpp).
#pragma once

#include "document/actions/layer_look_table.hpp"
#include "document/actions/pen_actions.hpp"
#include "document/actions/table.hpp"
#include "layers/transform.hpp"

#include <string>

namespace pastoso::document {

struct LivingPainting;

/// A transform scales by this along an axis, mirroring aside: what is smaller is not to be seen; larger,
/// a cell would fill a small canvas.
inline constexpr double kLeastScale = 0.05, kMostScale = 20.0;
/// Smaller than a cell of the finest canvas.
inline constexpr double kLeastDistorted_mm = 0.01;

struct AddLayer {  ///< bare and with nothing but a name, above the active one; becomes active
    std::string name;
    friend bool operator==(const AddLayer&, const AddLayer&) = default;
};
struct SelectLayer {  ///< makes it the active one: its wet paint flows, that of all others keeps still
    LayerId layer = 0;
    friend bool operator==(const SelectLayer&, const SelectLayer&) = default;
};
struct SetLayer {
    LayerId layer = 0;
    LayerLook look;
    friend bool operator==(const SetLayer&, const SetLayer&) = default;
};
struct DuplicateLayer {  ///< with as much paint from the tubes; the copy lies above it, and is active
    LayerId layer = 0;
    friend bool operator==(const DuplicateLayer&, const DuplicateLayer&) = default;
};
struct RemoveLayer {  ///< with all its paint, which is wiped off; the last one stays
    LayerId layer = 0;
    friend bool operator==(const RemoveLayer&, const RemoveLayer&) = default;
};
struct ClearLayer {  ///< wipes its paint off, wet and dry: all, or what is selected of it
    LayerId layer = 0;
    friend bool operator==(const ClearLayer&, const ClearLayer&) = default;
};
/// Moves, turns and scales its paint, or what is selected of it and the selection with it; that is then
/// laid over the rest (layers/merging.hpp). Paint keeps its thickness: what there is more of afterwards
/// comes out of the tubes, what there is less of and what comes beyond the canvas is wiped off.
struct TransformLayer {
    LayerId layer = 0;
    layers::Transform transform;
    friend bool operator==(const TransformLayer&, const TransformLayer&) = default;
};
/// Draws its paint, or what is selected of it and the selection with it, by the corners of a rectangle;
/// otherwise the same. The corners have to go round an area (layers::bends_outwards()), and each side to
/// be scaled by kLeastScale to kMostScale.
struct DistortLayer {
    LayerId layer = 0;
    layers::Distortion distortion;
    friend bool operator==(const DistortLayer&, const DistortLayer&) = default;
};
struct MoveLayer {
    LayerId layer = 0;
    int place = 0;      ///< how many of the other layers are below it afterwards
    GroupId group = 0;  ///< that it is in then
    friend bool operator==(const MoveLayer&, const MoveLayer&) = default;
};
/// Onto the one below it (layers/merging.hpp), which keeps its name and its position. What clipping
/// hides is wiped off, unless both are clipped to the same layer: so is the result then.
struct MergeDown {
    LayerId layer = 0;
    friend bool operator==(const MergeDown&, const MergeDown&) = default;
};
/// Merges all that are visible into the lowest of them; hidden ones stay. What clipping hides is wiped
/// off.
struct FlattenLayers {
    friend bool operator==(const FlattenLayers&, const FlattenLayers&) = default;
};

using LayerActions = ActionList<AddLayer, SelectLayer, SetLayer, DuplicateLayer, RemoveLayer, ClearLayer,
                                TransformLayer, DistortLayer, MoveLayer, MergeDown, FlattenLayers>;

void check_whole(const TransformLayer& move);
void check_whole(const DistortLayer& distort);
void apply(const AddLayer& add, LivingPainting& painting);
void apply(const SelectLayer& select, LivingPainting& painting);
void apply(const SetLayer& set, LivingPainting& painting);
void apply(const DuplicateLayer& duplicate, LivingPainting& painting);
void apply(const RemoveLayer& remove, LivingPainting& painting);
void apply(const ClearLayer& clear, LivingPainting& painting);
void apply(const TransformLayer& move, LivingPainting& painting);
void apply(const DistortLayer& distort, LivingPainting& painting);
void apply(const MoveLayer& move, LivingPainting& painting);
void apply(const MergeDown& merge, LivingPainting& painting);
void apply(const FlattenLayers& flatten, LivingPainting& painting);

template <>
struct Table<AddLayer> {
    static constexpr ActionTraits kTraits = change(
        "add_layer", 5, step_name("New layer"),
        "adds a bare layer above the active one; it becomes active. Layers are numbered from 1, in "
        "the order in which they come to be");
    static constexpr void fields(auto&& visit) {
        visit(Text<At<&AddLayer::name>>{"name", core::Pattern<0>("name of a layer"), kMostLayerName,
                                        Presence::Required});
    }
};

template <>
struct Table<SelectLayer> {
    static constexpr ActionTraits kTraits{
        .key = "select_layer",
        .since = 5,
        .meaning = "makes a layer the active one: its wet paint flows, that of all others keeps still",
        .undo = UndoRole::NoStep,
        .step = "",
        .changes_painting = false,
        .stroke = StrokeRole::Ends,
        .in_set_up = false};
    static constexpr void fields(auto&& visit) { visit(kLayerNumber<&SelectLayer::layer>); }
};

template <>
struct Table<SetLayer> {
    static constexpr ActionTraits kTraits =
        change("set_layer", 5, step_name("Look of a layer"), "how a layer is called and shown");
    static constexpr void fields(auto&& visit) {
        visit(Part<At<&SetLayer::look>>{});
        visit(kLayerNumber<&SetLayer::layer>);
    }
};

template <>
struct Table<DuplicateLayer> {
    static constexpr ActionTraits kTraits =
        change("duplicate_layer", 5, step_name("Layer duplicated"),
               "the copy lies above its model and becomes active; its paint comes out of the tubes");
    static constexpr void fields(auto&& visit) { visit(kLayerNumber<&DuplicateLayer::layer>); }
};

template <>
struct Table<RemoveLayer> {
    static constexpr ActionTraits kTraits =
        change("remove_layer", 5, step_name("Layer removed"), "what was on it is counted as wiped off");
    static constexpr void fields(auto&& visit) { visit(kLayerNumber<&RemoveLayer::layer>); }
};

template <>
struct Table<ClearLayer> {
    static constexpr ActionTraits kTraits = change("clear_layer", 5, step_name("Layer cleared"),
                                                   "wipes all its paint off, or what is selected of it");
    static constexpr void fields(auto&& visit) { visit(kLayerNumber<&ClearLayer::layer>); }
};

template <>
struct Table<TransformLayer> {
    static constexpr ActionTraits kTraits = change(
        "transform_layer", 6, step_name("Transform"),
        "its paint, or what is selected of it, is scaled and turned about the centre, then moved; "
        "paint keeps its thickness ([0030](decisions/0030-transforms.md))");
    template <auto kMember>
    using In = At<&TransformLayer::transform, kMember>;
    static constexpr void fields(auto&& visit) {
        visit(kLayerNumber<&TransformLayer::layer>);
        using layers::Transform;
        using enum Presence;
        constexpr double kFar_mm = kMaxPenPosition_mm;
        visit(Pair<In<&Transform::centre_x_mm>, In<&Transform::centre_y_mm>>{
            "centre_mm", core::Pattern<0>("transform's centre"), "mm", -kFar_mm, kFar_mm, Written});
        visit(Pair<In<&Transform::move_x_mm>, In<&Transform::move_y_mm>>{
            "move_mm", core::Pattern<0>("transform's move"), "mm", -kFar_mm, kFar_mm, Written});
        visit(Number<In<&Transform::turn_deg>>{"turn_deg", core::Pattern<0>("turn of the transform"),
                                               core::Pattern<0>("degrees"), -360.0, 360.0, Written,
                                               "clockwise"});
        visit(Pair<In<&Transform::scale_x>, In<&Transform::scale_y>>{
            "scale", core::Pattern<0>("transform's scale"), "", -kMostScale, kMostScale, Written,
            "at least 0.05 each; negative to mirror"});
    }
};

template <>
struct Table<DistortLayer> {
    static constexpr ActionTraits kTraits = change(
        "distort_layer", 14, step_name("Transform"),
        "its paint, or what is selected of it, is drawn by the corners of a rectangle, in perspective; "
        "paint keeps its thickness ([0088](decisions/0088-perspective-and-rotation.md))");
    template <auto... kMembers>
    using In = At<&DistortLayer::distortion, kMembers...>;
    template <auto kCorner>
    static constexpr auto corner(const char* key, core::Pattern<0> name) {
        using layers::Place;
        constexpr double kFar_mm = kMaxPenPosition_mm;
        return Pair<In<kCorner, &Place::x_mm>, In<kCorner, &Place::y_mm>>{
            key, name, "mm", -kFar_mm, kFar_mm, Presence::Required};
    }
    static constexpr void fields(auto&& visit) {
        visit(kLayerNumber<&DistortLayer::layer>);
        using layers::Distortion;
        visit(corner<&Distortion::corner>("corner_mm", core::Pattern<0>("corner that is distorted")));
        visit(Pair<In<&Distortion::width_mm>, In<&Distortion::height_mm>>{
            "size_mm", core::Pattern<0>("size of what is distorted"), "mm", kLeastDistorted_mm,
            kMaxPenPosition_mm, Presence::Required, "of the rectangle from that corner"});
        visit(corner<&Distortion::upper_left>("upper_left_mm",
                                              core::Pattern<0>("upper left corner of the distortion")));
        visit(corner<&Distortion::upper_right>(
            "upper_right_mm", core::Pattern<0>("upper right corner of the distortion")));
        visit(corner<&Distortion::lower_right>(
            "lower_right_mm", core::Pattern<0>("lower right corner of the distortion")));
        visit(corner<&Distortion::lower_left>("lower_left_mm",
                                              core::Pattern<0>("lower left corner of the distortion")));
    }
};

template <>
struct Table<MoveLayer> {
    static constexpr ActionTraits kTraits =
        change("move_layer", 5, step_name("Layer moved"), "changes the order of layers");
    static constexpr void fields(auto&& visit) {
        visit(kLayerNumber<&MoveLayer::layer>);
        visit(Whole<At<&MoveLayer::place>>{"place", core::Pattern<0>("position of the layer"), 0,
                                           kMostLayers, Presence::Required,
                                           "how many of the others are below it afterwards"});
        visit(Whole<At<&MoveLayer::group>>{"group", core::Pattern<0>("group of the layer"), 0, kMostId,
                                           Presence::Optional, "that it is in then; 0: none"});
    }
};

template <>
struct Table<MergeDown> {
    static constexpr ActionTraits kTraits =
        change("merge_down", 5, step_name("Merged down"), "merges a layer onto the one below it");
    static constexpr void fields(auto&& visit) { visit(kLayerNumber<&MergeDown::layer>); }
};

template <>
struct Table<FlattenLayers> {
    static constexpr ActionTraits kTraits =
        change("flatten_layers", 5, step_name("Flattened"),
               "merges all that are visible into the lowest of them");
    static constexpr void fields(auto&&) {}
};

}  // namespace pastoso::document
