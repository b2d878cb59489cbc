// What can happen to the layers of a painting (layers.hpp), as plain data.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pastoso::document {

/// Layers are numbered from 1 in the order in which they come to be, groups too; a number is never given
/// twice. A layer of the group 0 is in none.
using LayerId = std::uint32_t;
using GroupId = std::uint32_t;

/// How a layer or a group shows, and whether it can be changed. What a group says holds for all of its
/// layers beside what each of them says.
struct LayerLook {
    std::string name{};
    bool visible = true;
    bool locked = false;   ///< nothing is painted on it, cleared or merged
    double opacity = 1.0;  ///< of what its paint does to light, 0 to 1; its relief stays
    friend bool operator==(const LayerLook&, const LayerLook&) = default;
};

struct AddLayer {  ///< bare and with nothing but a name, above the active one; becomes active
    std::string name;
    friend bool operator==(const AddLayer&, const AddLayer&) = default;
};
struct SelectLayer {  ///< makes it the active one: its wet paint flows, that of all others is asleep
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
struct ClearLayer {  ///< wipes all its paint off, wet and dry
    LayerId layer = 0;
    friend bool operator==(const ClearLayer&, const ClearLayer&) = default;
};
struct MoveLayer {
    LayerId layer = 0;
    int place = 0;      ///< how many of the other layers are below it afterwards
    GroupId group = 0;  ///< that it is in then
    friend bool operator==(const MoveLayer&, const MoveLayer&) = default;
};
struct MergeDown {  ///< onto the one below it (layers/merging.hpp), which keeps its name and its place
    LayerId layer = 0;
    friend bool operator==(const MergeDown&, const MergeDown&) = default;
};
struct FlattenLayers {  ///< merges all that are visible into the lowest of them; hidden ones stay
    friend bool operator==(const FlattenLayers&, const FlattenLayers&) = default;
};
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

}  // namespace pastoso::document
