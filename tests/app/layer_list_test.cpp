// Layers as a list from above: rows, steps and drops in it against plain stacks.
#include "tools/layer_list.hpp"

#include <gtest/gtest.h>

namespace pastoso::tools {
namespace {

using document::Action;
using document::MoveGroup;
using document::MoveLayer;

/// From the lowest: 1, 2 and 3 in the group 1, 4.
document::LayerStack stack_with_group() {
    document::LayerStack stack;
    stack.layers = {{.id = 1}, {.id = 2, .group = 1}, {.id = 3, .group = 1}, {.id = 4}};
    stack.groups = {{.id = 1}};
    stack.next_layer = 5;
    stack.next_group = 2;
    return stack;
}

std::vector<LayerEntry> after(document::LayerStack stack, const std::optional<Action>& move) {
    if (const auto* layer = std::get_if<MoveLayer>(&*move)) document::move_layer(stack, *layer);
    if (const auto* group = std::get_if<MoveGroup>(&*move)) document::move_group(stack, *group);
    return layer_entries(stack);
}

LayerRow layer(document::LayerId id) {
    return {.layer = id};
}
const LayerRow kGroup{.group = 1};

TEST(LayerList, ListsFromAboveWithGroupsAsRows) {
    EXPECT_EQ(layer_entries(stack_with_group()),
              (std::vector<LayerEntry>{{layer(4)}, {kGroup, {3, 2}}, {layer(1)}}));
    EXPECT_EQ(layer_entries(document::single_layer()), (std::vector<LayerEntry>{{layer(1)}}));
}

TEST(LayerList, ALayerIsDroppedBetweenRows) {
    const auto stack = stack_with_group();
    EXPECT_EQ(after(stack, move_to(stack, layer(1), {0, 0})),
              (std::vector<LayerEntry>{{layer(1)}, {layer(4)}, {kGroup, {3, 2}}}));
    EXPECT_EQ(after(stack, move_to(stack, layer(4), {0, 3})),
              (std::vector<LayerEntry>{{kGroup, {3, 2}}, {layer(1)}, {layer(4)}}));
    EXPECT_EQ(after(stack, move_to(stack, layer(4), {0, 2})),
              (std::vector<LayerEntry>{{kGroup, {3, 2}}, {layer(4)}, {layer(1)}}));
}

TEST(LayerList, ALayerIsDroppedIntoAndOutOfAGroup) {
    const auto stack = stack_with_group();
    EXPECT_EQ(after(stack, move_to(stack, layer(4), {1, 1})),
              (std::vector<LayerEntry>{{kGroup, {3, 4, 2}}, {layer(1)}}));
    EXPECT_EQ(after(stack, move_to(stack, layer(1), {1, 2})),
              (std::vector<LayerEntry>{{layer(4)}, {kGroup, {3, 2, 1}}}));
    EXPECT_EQ(after(stack, move_to(stack, layer(3), {1, 2})),
              (std::vector<LayerEntry>{{layer(4)}, {kGroup, {2, 3}}, {layer(1)}}));
    EXPECT_EQ(after(stack, move_to(stack, layer(2), {0, 1})),
              (std::vector<LayerEntry>{{layer(4)}, {layer(2)}, {kGroup, {3}}, {layer(1)}}));
    EXPECT_EQ(after(stack, move_to(stack, layer(3), {0, 3})),
              (std::vector<LayerEntry>{{layer(4)}, {kGroup, {2}}, {layer(1)}, {layer(3)}}));
}

TEST(LayerList, AGroupMovesWhole) {
    const auto stack = stack_with_group();
    EXPECT_EQ(move_to(stack, kGroup, {0, 0}), Action(MoveGroup{1, 2}));
    EXPECT_EQ(move_to(stack, kGroup, {0, 3}), Action(MoveGroup{1, 0}));
    EXPECT_EQ(move_to(stack, kGroup, {1, 0}), std::nullopt) << "not into a group";
}

TEST(LayerList, WhatIsThereAlreadyDoesNotMove) {
    const auto stack = stack_with_group();
    for (const int row : {0, 1})
        EXPECT_EQ(move_to(stack, layer(4), {0, row}), std::nullopt);
    for (const int row : {1, 2})
        EXPECT_EQ(move_to(stack, kGroup, {0, row}), std::nullopt);
    for (const int row : {0, 1})
        EXPECT_EQ(move_to(stack, layer(3), {1, row}), std::nullopt);
}

TEST(LayerList, StepsUpGoThroughEveryPlaceAndEnd) {
    auto stack = stack_with_group();
    std::vector<std::vector<LayerEntry>> seen;
    while (const auto gap = step_from(stack, layer(1), true)) {
        document::move_layer(stack, std::get<MoveLayer>(move_to(stack, layer(1), *gap).value()));
        seen.push_back(layer_entries(stack));
        ASSERT_LE(seen.size(), 5U);
    }
    EXPECT_EQ(seen, (std::vector<std::vector<LayerEntry>>{{{layer(4)}, {kGroup, {3, 2, 1}}},
                                                          {{layer(4)}, {kGroup, {3, 1, 2}}},
                                                          {{layer(4)}, {kGroup, {1, 3, 2}}},
                                                          {{layer(4)}, {layer(1)}, {kGroup, {3, 2}}},
                                                          {{layer(1)}, {layer(4)}, {kGroup, {3, 2}}}}));
}

TEST(LayerList, StepsDownUndoStepsUp) {
    for (const LayerRow& row : {layer(1), layer(2), layer(3), kGroup}) {
        auto stack = stack_with_group();
        const auto there = move_to(stack, row, step_from(stack, row, true).value()).value();
        const auto before = layer_entries(stack);
        if (row == kGroup)
            document::move_group(stack, std::get<MoveGroup>(there));
        else
            document::move_layer(stack, std::get<MoveLayer>(there));
        EXPECT_EQ(after(stack, move_to(stack, row, step_from(stack, row, false).value())), before);
    }
    EXPECT_EQ(step_from(stack_with_group(), layer(1), false), std::nullopt);
    EXPECT_EQ(step_from(stack_with_group(), layer(4), true), std::nullopt);
}

TEST(LayerList, RowsStandForLayers) {
    const auto stack = stack_with_group();
    EXPECT_EQ(layers_in(stack, {kGroup, layer(1), layer(3)}), (std::vector<document::LayerId>{1, 2, 3}));
}

}  // namespace
}  // namespace pastoso::tools
