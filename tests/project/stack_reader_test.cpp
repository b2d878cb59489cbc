#include "project/stack_reader.hpp"

#include "core/error.hpp"
#include "core/message_text.hpp"
#include "document/layers.hpp"

#include <gmock/gmock.h>

namespace pastoso::project {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

RasterStack stack_of(const std::string& content) {
    return read_stack(
        "<?xml version='1.0' encoding='UTF-8'?>\n<image w='30' h='20'>\n" + content + "</image>",
        "a.ora, stack.xml");
}

std::string error_of(const std::string& xml) {
    try {
        read_stack(xml, "a.ora, stack.xml");
    } catch (const core::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(RasterStack, HasItsLayersFromBelow) {
    const RasterStack stack = stack_of(
        "<stack><layer name='Top &amp; &#228;' src='data/1.png' x='-3' y='4' opacity='0.25' "
        "visibility='hidden'/><layer src='data/0.png'/></stack>");
    EXPECT_EQ(stack.width, 30);
    EXPECT_EQ(stack.height, 20);
    EXPECT_EQ(stack.px_per_mm_x, 0.0);
    ASSERT_EQ(stack.pictures.size(), 2U);
    EXPECT_EQ(stack.pictures[0].source, "data/0.png");
    EXPECT_EQ(stack.pictures[0].look, (document::LayerLook{.name = "Layer"}));
    EXPECT_EQ(stack.pictures[1].x, -3);
    EXPECT_EQ(stack.pictures[1].y, 4);
    EXPECT_EQ(stack.pictures[1].look, (document::LayerLook{"Top & \u00e4", false, false, 0.25}));
    EXPECT_TRUE(stack.notes.empty());
}

TEST(RasterStack, HasGroupsOfOneLevel) {
    const RasterStack stack = stack_of(
        "<stack><stack name='A' opacity='0.5'><layer src='3'/><stack name='B' opacity='0.5' "
        "visibility='hidden'><layer src='2' opacity='0.5'/></stack></stack><layer src='1'/>"
        "<stack name='C'><layer src='0'/></stack></stack>");
    ASSERT_EQ(stack.groups.size(), 2U);
    EXPECT_EQ(stack.groups[0], (document::LayerLook{.name = "A", .opacity = 0.5}));
    std::vector<std::size_t> groups;
    for (const StackPicture& picture : stack.pictures)
        groups.push_back(picture.group);
    EXPECT_THAT(groups, ElementsAre(2, 0, 1, 1));
    EXPECT_FALSE(stack.pictures[2].look.visible);
    EXPECT_EQ(stack.pictures[2].look.opacity, 0.25);
    EXPECT_EQ(stack.pictures[3].look.opacity, 1.0);
    EXPECT_THAT(core::texts_of(stack.notes), ElementsAre("the groups within \"A\" become part of it."));
}

TEST(RasterStack, SaysWhatItLeavesOut) {
    const RasterStack stack = stack_of(
        "<stack><layer name='L' src='1' composite-op='svg:multiply'/><text x='1'/>"
        "<layer name='Empty'/></stack>");
    EXPECT_THAT(
        core::texts_of(stack.notes),
        ElementsAre("\"L\" was laid over the others by svg:multiply and is laid over them as paint.",
                    "<text> is left out.", "\"Empty\" holds no picture and is left out."));
    EXPECT_EQ(stack.pictures.size(), 1U);
}

TEST(RasterStack, WhatShowsOnlyOverWhatIsBelowIsClipped) {
    const RasterStack stack = stack_of(
        "<stack composite-op='svg:src-atop'><layer src='1' composite-op='svg:src-atop'/>"
        "<layer src='0' composite-op='svg:src-over'/></stack>");
    ASSERT_EQ(stack.pictures.size(), 2U);
    EXPECT_FALSE(stack.pictures[0].look.clipped);
    EXPECT_TRUE(stack.pictures[1].look.clipped);
    EXPECT_THAT(core::texts_of(stack.notes),
                ElementsAre("\"Group\" was laid over the others by svg:src-atop and is laid over them "
                            "as paint."));
}

TEST(RasterStack, KnowsTheResolutionUnlessItIsThatOfScreens) {
    EXPECT_DOUBLE_EQ(read_stack("<image w='3' h='2' xres='254' yres='127'/>", "a").px_per_mm_x, 10.0);
    EXPECT_DOUBLE_EQ(read_stack("<image w='3' h='2' xres='254' yres='127'/>", "a").px_per_mm_y, 5.0);
    EXPECT_EQ(read_stack("<image w='3' h='2' xres='72' yres='72'/>", "a").px_per_mm_x, 0.0);
}

TEST(RasterStack, ShortensNamesBetweenLetters) {
    std::string name;
    for (int i = 0; i < 150; ++i)
        name += "\u00e4";
    const RasterStack stack = stack_of("<stack><layer src='1' name='x" + name + "'/></stack>");
    EXPECT_EQ(stack.pictures[0].look.name, "x" + name.substr(0, document::kMostLayerName - 2));
}

TEST(RasterStack, ThatIsNoneIsRefusedWithItsLine) {
    EXPECT_EQ(error_of("<svg/>"),
              "a.ora, stack.xml, line 1: this is no list of layers; it would begin with <image>.");
    EXPECT_THAT(error_of("<image w='3' h='2'>\n<stack>"), HasSubstr("line 2: this is not valid XML ("));
    EXPECT_THAT(error_of(""), HasSubstr("this is not valid XML ("));
    EXPECT_THAT(error_of("<image h='2'/>"), HasSubstr("the size of the picture is missing."));
    EXPECT_THAT(error_of("<image w='99999' h='2'/>"),
                HasSubstr("\"w\" is 99999, but must lie between 1"));
    EXPECT_THAT(error_of("<image w='2px' h='2'/>"), HasSubstr("expected a number for \"w\"."));
    EXPECT_THAT(error_of("<image w='nan' h='2'/>"), HasSubstr("expected a number for \"w\"."));
    EXPECT_THAT(error_of("<image w='3' h='2'><stack><layer src='a' opacity='2'/></stack></image>"),
                HasSubstr("\"opacity\" is 2"));
    EXPECT_THAT(error_of("<image w='3' h='2'><stack><layer src='a' x='1e9'/></stack></image>"),
                HasSubstr("\"x\" is 1"));
}

TEST(RasterStack, ThatWouldUnfoldIsRefused) {
    EXPECT_THAT(error_of("<!DOCTYPE image [<!ENTITY a 'aaaa'>]><image w='3' h='2'>&a;</image>"),
                HasSubstr("a document type is not read here."));
    std::string deep = "<image w='3' h='2'>";
    for (int i = 0; i < 40; ++i)
        deep += "<stack>";
    EXPECT_THAT(error_of(deep), HasSubstr("nested too deep."));
    std::string many = "<image w='3' h='2'><stack>";
    for (int i = 0; i < 101; ++i)
        many += "<layer src='a'/>";
    EXPECT_THAT(error_of(many), HasSubstr("there are more than 100 layers."));
}

}  // namespace
}  // namespace pastoso::project
