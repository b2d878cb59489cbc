// What can happen to groups of layers (layers.hpp).
#pragma once

#include "document/actions/layer_look_table.hpp"
#include "document/actions/table.hpp"

#include <string>
#include <vector>

namespace pastoso::document {

struct LivingPainting;

struct GroupLayers {  ///< puts layers that lie next to each other, of no group, into a new one
    std::string name;
    std::vector<LayerId> layers;
    friend bool operator==(const GroupLayers&, const GroupLayers&) = default;
};
struct SetGroup {
    GroupId group = 0;
    LayerLook look;
    friend bool operator==(const SetGroup&, const SetGroup&) = default;
};
struct MoveGroup {
    GroupId group = 0;
    int place = 0;  ///< how many of the other layers are below its lowest afterwards
    friend bool operator==(const MoveGroup&, const MoveGroup&) = default;
};
struct UngroupLayers {  ///< leaves the group's layers where they are
    GroupId group = 0;
    friend bool operator==(const UngroupLayers&, const UngroupLayers&) = default;
};

using GroupActions = ActionList<GroupLayers, SetGroup, MoveGroup, UngroupLayers>;

void check_whole(const SetGroup& set);
void apply(const GroupLayers& group, LivingPainting& painting);
void apply(const SetGroup& set, LivingPainting& painting);
void apply(const MoveGroup& move, LivingPainting& painting);
void apply(const UngroupLayers& ungroup, LivingPainting& painting);

template <>
struct Table<GroupLayers> {
    static constexpr ActionTraits kTraits =
        change("group_layers", 5, step_name("Layers grouped"),
               "puts layers that lie next to each other and are in no "
               "group into a new one. Groups are numbered like layers");
    static constexpr void fields(auto&& visit) {
        visit(Text<At<&GroupLayers::name>>{"name", core::Pattern<0>("name of a group"), kMostLayerName,
                                           Presence::Required});
        visit(Value<At<&GroupLayers::layers>>{"layers", "numbers of the layers", Presence::Required,
                                              "a list of them"});
    }
};

template <>
struct Table<SetGroup> {
    static constexpr ActionTraits kTraits =
        change("set_group", 5, step_name("Look of a group"), "how a group is called and shown");
    static constexpr void fields(auto&& visit) {
        visit(Part<At<&SetGroup::look>>{});
        visit(kGroupNumber<&SetGroup::group>);
    }
};

template <>
struct Table<MoveGroup> {
    static constexpr ActionTraits kTraits =
        change("move_group", 5, step_name("Group moved"), "changes the order of layers");
    static constexpr void fields(auto&& visit) {
        visit(kGroupNumber<&MoveGroup::group>);
        visit(Whole<At<&MoveGroup::place>>{
            "place", core::Pattern<0>("position of the group"), 0, kMostLayers, Presence::Required,
            "how many layers that are not in it are below it afterwards"});
    }
};

template <>
struct Table<UngroupLayers> {
    static constexpr ActionTraits kTraits =
        change("ungroup_layers", 5, step_name("Group dissolved"),
               "leaves the layers of a group where they are, in none");
    static constexpr void fields(auto&& visit) { visit(kGroupNumber<&UngroupLayers::group>); }
};

}  // namespace pastoso::document
