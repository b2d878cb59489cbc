// The layers of a painting from below, each with strata of dried paint and a wet film.
#pragma once

#include "document/actions/group_actions.hpp"
#include "document/actions/layer_actions.hpp"
#include "film/state.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace pastoso::document {

struct Layer {
    LayerId id = 0;
    GroupId group = 0;
    LayerLook look{};
    /// Its paint, apart from what it lies on (layers/apart.hpp); null for the active layer, whose film
    /// lies on the canvas.
    std::shared_ptr<const film::FilmState> inactive{};
    friend bool operator==(const Layer&, const Layer&) = default;
};

struct LayerGroup {
    GroupId id = 0;
    LayerLook look{};
    friend bool operator==(const LayerGroup&, const LayerGroup&) = default;
};

/// The layers of a group lie next to each other, and every group has one.
struct LayerStack {
    std::vector<Layer> layers;  ///< the lowest first, at least one
    std::vector<LayerGroup> groups;
    std::size_t active = 0;
    LayerId next_layer = 1;
    GroupId next_group = 1;

    /// Inactive films are equal when they are the same.
    friend bool operator==(const LayerStack&, const LayerStack&) = default;
};

/// A stack of one layer, which is active.
LayerStack single_layer();

/// Throws InputError when there is no such layer or group.
std::size_t place_of(const LayerStack& stack, LayerId layer);
LayerGroup& group_of(LayerStack& stack, GroupId group);
const LayerGroup& group_of(const LayerStack& stack, GroupId group);

/// The place of what the layer at `place` is clipped to if it is: the nearest layer below it in its
/// group, or in none like it, that is not clipped itself. Where there is none, all of the layer shows.
std::optional<std::size_t> clipping_base(const LayerStack& stack, std::size_t place);

/// The same of a layer that is clipped; none of one that is not.
std::optional<std::size_t> clipped_to(const LayerStack& stack, std::size_t place);

/// A layer with what the one says that it is clipped to: visible when both are, opacities multiplied.
LayerLook look_in_group(const LayerStack& stack, std::size_t place);

/// look_in_group() with what its group says: visible when both are, locked when one is, what is
/// bare as well, opacities multiplied.
LayerLook effective_look(const LayerStack& stack, std::size_t place);

/// Whether nothing else is said of it than what single_layer() says.
bool is_single(const LayerStack& stack);

/// Throws InputError when numbers, groups or looks are such as no painting comes to have.
void check_stack(const LayerStack& stack);

/// Throws InputError for a name that is too long and for an opacity that is none.
void check_look(const LayerLook& look);

/// The same of a group; throws for one that is clipped, too.
void check_group_look(const LayerLook& look);

/// Throws InputError, naming the layer, unless it is visible and not locked.
void check_paintable(const LayerStack& stack, std::size_t place);

/// Throws InputError, naming the layer, when it is locked.
void check_unlocked(const LayerStack& stack, std::size_t place);

// Changes of the order. All layers are inactive or none of those that move is active; they throw
// InputError and leave the stack as it was when there is no such layer or place.

void move_layer(LayerStack& stack, const MoveLayer& move);
void group_layers(LayerStack& stack, const GroupLayers& group);
void move_group(LayerStack& stack, const MoveGroup& move);
void ungroup_layers(LayerStack& stack, GroupId group);

/// Forgets groups without layers.
void drop_empty_groups(LayerStack& stack);

}  // namespace pastoso::document
