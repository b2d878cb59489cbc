// How panels stand, as values: mirrored, kept under names, in files.
#include "tools/workspaces.hpp"

#include "core/error.hpp"
#include "core/temporary_folder.hpp"
#include "core/text_file.hpp"

#include <set>

#include <gmock/gmock.h>

namespace pastoso::tools {
namespace {

PanelArrangement some_arrangement() {
    PanelArrangement panels = arrangement_of(Workspace::Mixing);
    panels.at(Side::Bottom) = {.tabs = {{.panels = {"layers_panel"}, .raised = 0, .length_px = 640}},
                               .breadth_px = 120};
    panels.floating = {{"guides_panel", -20, 30, 300, 200}};
    return panels;
}

std::set<std::string> names_in(const PanelArrangement& panels) {
    std::set<std::string> names;
    for (const PanelSide& side : panels.sides)
        for (const PanelTabs& tabs : side.tabs)
            for (const std::string& panel : tabs.panels)
                EXPECT_TRUE(names.insert(panel).second) << panel;
    return names;
}

std::string error_of(const std::filesystem::path& file, const std::string& text) {
    core::write_text_file(file, text);
    try {
        read_workspaces(file);
    } catch (const core::InputError& error) {
        return std::string(error.what()).substr(file.string().size());
    }
    return "no error";
}

TEST(PanelArrangement, MirroredTwiceIsAsItWas) {
    const PanelArrangement panels = some_arrangement();
    EXPECT_NE(mirrored(panels), panels);
    EXPECT_EQ(mirrored(mirrored(panels)), panels);
    EXPECT_EQ(mirrored(panels).at(Side::Left), panels.at(Side::Right));
    EXPECT_EQ(mirrored(panels).at(Side::Bottom), panels.at(Side::Bottom));
}

TEST(PanelArrangement, WhatNeedsLessThanItsShareLeavesTheRestToTheOthers) {
    using testing::ElementsAre;
    EXPECT_THAT(shared_lengths({{500, {}}, {300, {}}}, 1600), ElementsAre(1000, 600));
    EXPECT_THAT(shared_lengths({{500, {}}, {300, 240}}, 1600), ElementsAre(1360, 240));
    EXPECT_THAT(shared_lengths({{500, {}}, {300, 900}}, 1600), ElementsAre(1000, 600))
        << "no more than its share";
    EXPECT_THAT(shared_lengths({{300, {}}, {100, {}}, {200, 50}}, 450), ElementsAre(300, 100, 50));
    EXPECT_THAT(shared_lengths({{200, 50}, {100, {}}, {300, {}}}, 450), ElementsAre(50, 100, 300))
        << "in any order";
    EXPECT_THAT(shared_lengths({{1, 10}, {1, 10}}, 100), ElementsAre(50, 50)) << "all of it is used";
    EXPECT_THAT(shared_lengths({{378, {}}, {141, {}}, {171, {}}}, 546), ElementsAre(330, 93, 123))
        << "of too little room each gives way alike";
    EXPECT_THAT(shared_lengths({{500, {}}, {300, 200}}, 690), ElementsAre(490, 200));
    EXPECT_THAT(shared_lengths({{1, {}}, {1, {}}, {1, {}}}, 100), ElementsAre(33, 33, 34));
}

TEST(Workspaces, ThoseThatComeWithTheProgramNamePanelsThatHaveAHome) {
    const std::set<std::string> all = names_in(panels_at_home());
    EXPECT_EQ(all.size(), 16U);
    for (const Workspace shipped :
         {Workspace::Sketch, Workspace::Oil, Workspace::Mixing, Workspace::Export}) {
        const std::set<std::string> open = names_in(arrangement_of(shipped));
        EXPECT_FALSE(open.empty());
        EXPECT_TRUE(std::ranges::includes(all, open));
        for (const PanelSide& side : arrangement_of(shipped).sides)
            for (const PanelTabs& tabs : side.tabs)
                EXPECT_LT(tabs.raised, tabs.panels.size());
    }
}

TEST(Workspaces, OwnOnesAreKeptRenamedAndRemoved) {
    Workspaces workspaces;
    EXPECT_EQ(arrangement_in_use(workspaces), arrangement_of(Workspace::Oil));
    keep("Portraits", some_arrangement(), workspaces);
    EXPECT_EQ(workspaces.in_use, "Portraits");
    EXPECT_EQ(arrangement_in_use(workspaces), some_arrangement());
    keep("Portraits", {}, workspaces);
    ASSERT_EQ(workspaces.own.size(), 1U);
    EXPECT_EQ(workspaces.own[0].panels, PanelArrangement());
    keep("Skies", some_arrangement(), workspaces);
    rename_in_use("Clouds", workspaces);
    EXPECT_EQ(find_own(workspaces, "Skies"), nullptr);
    ASSERT_NE(find_own(workspaces, "Clouds"), nullptr);
    EXPECT_EQ(find_own(workspaces, "Clouds")->panels, some_arrangement());
    EXPECT_EQ(workspaces.in_use, "Clouds");
    rename_in_use("Clouds", workspaces);
    EXPECT_EQ(workspaces.own.size(), 2U);
    remove_in_use(workspaces);
    EXPECT_EQ(workspaces.in_use, "");
    EXPECT_EQ(workspaces.own.size(), 1U);
    use(workspaces.own[0], workspaces);
    EXPECT_EQ(workspaces.shipped, std::nullopt);
    use(Workspace::Sketch, workspaces);
    EXPECT_EQ(workspaces.in_use, "");
    EXPECT_EQ(arrangement_in_use(workspaces), arrangement_of(Workspace::Sketch));
}

TEST(Workspaces, ComeBackAsTheyWereWritten) {
    const tests::TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "workspaces.json";
    EXPECT_EQ(read_workspaces(file), Workspaces());
    Workspaces workspaces;
    workspaces.left_handed = true;
    use(Workspace::Export, workspaces);
    write_workspaces(workspaces, file);
    EXPECT_EQ(read_workspaces(file), workspaces);
    keep("Portraits", some_arrangement(), workspaces);
    keep("\"Skies\" & sea", {}, workspaces);
    write_workspaces(workspaces, file);
    EXPECT_EQ(read_workspaces(file), workspaces);
    remove_in_use(workspaces);
    write_workspaces(workspaces, file);
    EXPECT_EQ(read_workspaces(file), workspaces) << "none is in use";
}

TEST(Workspaces, WhatIsMalformedIsToldWithItsPlace) {
    const tests::TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "workspaces.json";
    const std::string head = R"({"version": 1, "left_handed": false, "in_use": )";
    EXPECT_EQ(error_of(file, head + R"({"own": "Skies"}, "own": []})"),
              ", in_use.own: there is no \"Skies\".");
    EXPECT_EQ(error_of(file, head + R"({"shipped": "gouache"}, "own": []})"),
              ", in_use.shipped: \"gouache\" is not one of sketch, oil, mixing, export.");
    EXPECT_EQ(
        error_of(file,
                 head + R"({}, "own": [{"name": "A", "panels": {}}, {"name": "A", "panels": {}}]})"),
        ", own[1].name: \"A\" is there twice.");
    EXPECT_EQ(
        error_of(file, head + R"({}, "own": [{"name": "A", "panels": {"left": {"breadth_px": 1, "tabs":
        [{"panels": ["x", "x"], "raised": 0, "length_px": 1}]}}}]})"),
        ", own[0].panels.left.tabs[0].panels[1]: the panel x stands there twice.");
    EXPECT_THAT(
        error_of(file, head + R"({}, "own": [{"name": "A", "panels": {"left": {"breadth_px": 1, "tabs":
        [{"panels": ["x"], "raised": 1, "length_px": 1}]}}}]})"),
        testing::HasSubstr("own[0].panels.left.tabs[0].raised"));
}

}  // namespace
}  // namespace pastoso::tools
