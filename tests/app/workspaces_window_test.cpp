// The panels around the canvas: closed and back, moved, in workspaces, for left hands, over restarts.
#include "app/window_fixture.hpp"
#include "core/text_file.hpp"
#include "main/dock_arrangement.hpp"
#include "main/program/language.hpp"
#include "main/window_parts.hpp"

#include <cstdlib>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QSlider>
#include <QTest>
#include <QToolBar>
#include <gmock/gmock.h>

namespace pastoso::tests {
namespace {

using commands::Command;
using testing::HasSubstr;
using tools::PanelArrangement;
using tools::Side;
using tools::Workspace;

constexpr std::pair<Command, Workspace> kShipped[] = {{Command::WorkspaceSketch, Workspace::Sketch},
                                                      {Command::WorkspaceOil, Workspace::Oil},
                                                      {Command::WorkspaceMixing, Workspace::Mixing},
                                                      {Command::WorkspaceExport, Workspace::Export}};

/// Lengths and breadths are the window's affair.
std::string places(const PanelArrangement& panels) {
    std::string text;
    for (const Side side : tools::kSides)
        for (const tools::PanelTabs& tabs : panels.at(side).tabs) {
            text += "lrtb"[static_cast<std::size_t>(side)];
            text += ":";
            for (std::size_t i = 0; i < tabs.panels.size(); ++i)
                text += (i == tabs.raised ? " *" : " ") + tabs.panels[i];
            text += "\n";
        }
    for (const tools::FloatingPanel& floating : panels.floating)
        text += "floating: " + floating.panel + "\n";
    return text;
}

class WorkspacesWindow : public WindowTest {
  protected:
    void SetUp() override {
        WindowTest::SetUp();
        if (!HasFatalFailure()) action(Command::Pause)->trigger();
    }
    void TearDown() override {
        main::speak(QStringLiteral("en"));
        WindowTest::TearDown();
    }
    void give(Command command) {
        action(command)->trigger();
        QApplication::processEvents();
    }
    PanelArrangement stand() { return main::read_docks(window()); }
    QDockWidget& dock(const char* name) {
        return *window().findChild<QDockWidget*>(QString::fromLatin1(name));
    }
    main::WorkspaceCommands& workspaces() { return parts().workspaces; }
    QStringList menu_words() {
        QStringList words;
        for (const QAction* title : window().menuBar()->actions()) {
            if (!title->menu()->actions().contains(action(Command::SaveWorkspace))) continue;
            Q_EMIT title->menu()->aboutToShow();
            for (const QAction* one : title->menu()->actions())
                if (one->isVisible()) words.push_back(one->text());
        }
        return words;
    }
};

TEST_F(WorkspacesWindow, StandAsTheProgramSaysAndAreReadAsTheyStand) {
    EXPECT_EQ(places(stand()), places(tools::arrangement_of(Workspace::Oil))) << "at the first start";
    for (const auto& [command, workspace] : kShipped) {
        give(command);
        EXPECT_EQ(places(stand()), places(tools::arrangement_of(workspace)));
        EXPECT_TRUE(action(command)->isChecked());
        EXPECT_GT(canvas().width(), 300);
    }
    EXPECT_FALSE(action(Command::WorkspaceOil)->isChecked());
}

TEST_F(WorkspacesWindow, AClosedPanelComesBackWhereItStood) {
    for (const char* name : {"brushes_panel", "easel_panel", "colour_panel", "history_panel"}) {
        SCOPED_TRACE(name);
        const std::string before = places(stand());
        dock(name).close();
        QApplication::processEvents();
        EXPECT_THAT(places(stand()), testing::Not(HasSubstr(name)));
        dock(name).show();
        QApplication::processEvents();
        dock("tool_panel").raise();
        dock("layers_panel").raise();
        EXPECT_EQ(places(stand()), before);
    }
}

TEST_F(WorkspacesWindow, APanelThatAWorkspaceHasNotComesByItsCommand) {
    give(Command::WorkspaceSketch);
    for (const auto& [command, name] : {std::pair{Command::EaselPanel, "easel_panel"},
                                        {Command::ColourPanel, "colour_panel"},
                                        {Command::MessagesPanel, "messages_panel"}}) {
        give(command);
        EXPECT_TRUE(dock(name).isVisible()) << name;
    }
    EXPECT_EQ(window().dockWidgetArea(&dock("easel_panel")), Qt::LeftDockWidgetArea);
    EXPECT_EQ(window().dockWidgetArea(&dock("colour_panel")), Qt::RightDockWidgetArea);
}

TEST_F(WorkspacesWindow, LeftHandedIsTheMirrorOfEveryWorkspace) {
    give(Command::LeftHanded);
    EXPECT_EQ(places(stand()), places(tools::mirrored(tools::arrangement_of(Workspace::Oil))));
    for (const auto& [command, workspace] : kShipped) {
        give(command);
        EXPECT_EQ(places(stand()), places(tools::mirrored(tools::arrangement_of(workspace))));
    }
    give(Command::WorkspaceOil);
    give(Command::LeftHanded);
    EXPECT_EQ(places(stand()), places(tools::arrangement_of(Workspace::Oil)));
}

TEST_F(WorkspacesWindow, WhatThePainterMovedIsMirroredAsItStands) {
    window().addDockWidget(Qt::LeftDockWidgetArea, &dock("layers_panel"));
    dock("history_panel").close();
    dock("navigator_panel").setFloating(true);
    window().addDockWidget(Qt::BottomDockWidgetArea, &dock("paints_panel"));
    QApplication::processEvents();
    const PanelArrangement before = stand();
    EXPECT_THAT(places(before), HasSubstr("floating: navigator_panel"));
    give(Command::LeftHanded);
    EXPECT_EQ(places(stand()), places(tools::mirrored(before)));
    give(Command::LeftHanded);
    EXPECT_EQ(places(stand()), places(before));
}

TEST_F(WorkspacesWindow, OwnOnesStandInTheMenuAndComeBackAsSaved) {
    dock("easel_panel").close();
    QApplication::processEvents();
    const std::string mine = places(stand());
    workspaces().save(QStringLiteral(" Sea & sky "));
    EXPECT_TRUE(menu_words().contains(QStringLiteral("Sea && sky")));
    EXPECT_TRUE(action(Command::RenameWorkspace)->isEnabled());
    give(Command::WorkspaceExport);
    EXPECT_FALSE(action(Command::RenameWorkspace)->isEnabled());
    workspaces().use("Sea & sky");
    EXPECT_EQ(places(stand()), mine);

    workspaces().rename_in_use(QStringLiteral("Sea"));
    EXPECT_FALSE(menu_words().contains(QStringLiteral("Sea && sky")));
    give(Command::LeftHanded);
    workspaces().save(QStringLiteral("Other"));
    workspaces().rename_in_use(QStringLiteral("Sea"));
    EXPECT_THAT(told(), HasSubstr("already"));
    const auto& own = workspaces().workspaces().own;
    EXPECT_EQ(places(own[1].panels), places(own[0].panels)) << "kept as for right hands";
    give(Command::RemoveWorkspace);
    EXPECT_EQ(workspaces().workspaces().own.size(), 1U);
    EXPECT_FALSE(menu_words().contains(QStringLiteral("Other")));
    give(Command::MilkTea);
    EXPECT_FALSE(menu_words().contains(QStringLiteral("Sea")));
}

TEST_F(WorkspacesWindow, NamesOfTheProgramAreNotGiven) {
    workspaces().save(QStringLiteral("oil"));
    EXPECT_THAT(told(), HasSubstr("comes with the program"));
    workspaces().save(QStringLiteral("  "));
    EXPECT_TRUE(workspaces().workspaces().own.empty());
}

TEST_F(WorkspacesWindow, AreAsTheyWereAtTheNextStart) {
    give(Command::LeftHanded);
    give(Command::WorkspaceMixing);
    workspaces().save(QStringLiteral("Mine"));
    dock("paints_panel").close();
    QApplication::processEvents();
    const std::string before = places(stand());
    start_again();
    EXPECT_EQ(places(stand()), before);
    EXPECT_TRUE(action(Command::LeftHanded)->isChecked());
    EXPECT_EQ(workspaces().workspaces().in_use, "Mine");
    give(Command::ResetPanels);
    EXPECT_EQ(places(stand()), places(tools::mirrored(tools::arrangement_of(Workspace::Oil))));
}

TEST_F(WorkspacesWindow, WithoutWhatIsRememberedOfPanelsTheOneInUseIsPutUp) {
    give(Command::LeftHanded);
    give(Command::WorkspaceExport);
    window().close();
    std::filesystem::remove(settings_file());
    open_another();
    EXPECT_EQ(places(stand()), places(tools::mirrored(tools::arrangement_of(Workspace::Export))));
}

TEST_F(WorkspacesWindow, AFileThatCannotBeReadIsToldAndLeft) {
    const std::filesystem::path file = settings_file().parent_path() / "workspaces.json";
    window().close();
    core::write_text_file(file, "{\"version\": 1}");
    open_another();
    EXPECT_THAT(told(), HasSubstr("workspaces.json"));
    give(Command::WorkspaceSketch);
    EXPECT_EQ(core::read_text_file(file), "{\"version\": 1}");
}

TEST_F(WorkspacesWindow, FromCanvasOnlyAllIsThere) {
    give(Command::CanvasOnly);
    EXPECT_FALSE(dock("brushes_panel").isVisible());
    give(Command::WorkspaceOil);
    EXPECT_EQ(places(stand()), places(tools::arrangement_of(Workspace::Oil)));
    EXPECT_TRUE(window().menuBar()->isVisible());
    EXPECT_FALSE(action(Command::CanvasOnly)->isChecked());
}

TEST_F(WorkspacesWindow, TheToolBarGoesComesAndMoves) {
    auto* bar = window().findChild<QToolBar*>(QStringLiteral("tool_bar"));
    EXPECT_TRUE(action(Command::ToolBar)->isChecked());
    give(Command::ToolBar);
    EXPECT_FALSE(bar->isVisible());
    start_again();
    bar = window().findChild<QToolBar*>(QStringLiteral("tool_bar"));
    EXPECT_FALSE(bar->isVisible());
    EXPECT_FALSE(action(Command::ToolBar)->isChecked());
    give(Command::ToolBar);
    EXPECT_TRUE(bar->isVisible());
    window().addToolBar(Qt::BottomToolBarArea, bar);
    start_again();
    bar = window().findChild<QToolBar*>(QStringLiteral("tool_bar"));
    EXPECT_EQ(window().toolBarArea(bar), Qt::BottomToolBarArea);
    EXPECT_TRUE(bar->isMovable());
    EXPECT_TRUE(bar->isFloatable());
    give(Command::ToolBar);
    give(Command::ResetPanels);
    EXPECT_TRUE(bar->isVisible());
    EXPECT_EQ(window().toolBarArea(bar), Qt::TopToolBarArea);
}

TEST_F(WorkspacesWindow, TheToolBarStandsUprightAtASideAndChangesItWithTheHand) {
    const auto bar = [this] { return window().findChild<QToolBar*>(QStringLiteral("tool_bar")); };
    const auto slider = [&] { return bar()->findChild<QSlider*>(QStringLiteral("paint_share")); };
    EXPECT_EQ(slider()->orientation(), Qt::Horizontal);
    window().addToolBar(Qt::LeftToolBarArea, bar());
    EXPECT_EQ(slider()->orientation(), Qt::Vertical);
    start_again();
    EXPECT_EQ(window().toolBarArea(bar()), Qt::LeftToolBarArea);
    EXPECT_EQ(bar()->orientation(), Qt::Vertical);
    EXPECT_EQ(slider()->orientation(), Qt::Vertical);
    give(Command::WorkspaceSketch);
    EXPECT_EQ(window().toolBarArea(bar()), Qt::LeftToolBarArea) << "no part of a workspace";
    give(Command::LeftHanded);
    EXPECT_EQ(window().toolBarArea(bar()), Qt::RightToolBarArea);
    start_again();
    EXPECT_EQ(window().toolBarArea(bar()), Qt::RightToolBarArea) << "not turned once more";
    give(Command::LeftHanded);
    EXPECT_EQ(window().toolBarArea(bar()), Qt::LeftToolBarArea);
    give(Command::ResetPanels);
    EXPECT_EQ(window().toolBarArea(bar()), Qt::TopToolBarArea);
    EXPECT_EQ(slider()->orientation(), Qt::Horizontal);
}

TEST_F(WorkspacesWindow, FewLayersLeaveTheirRoomToTheTool) {
    const auto layers_px = [this] { return dock("layers_panel").height(); };
    const auto tool_px = [this] { return dock("tool_panel").height(); };
    const auto add_layers = [this](int count) {
        for (int i = 0; i < count; ++i)
            give(Command::AddLayer);
        session().wait_until_applied();
        settle();
        QApplication::processEvents();
    };
    const QSize high(1600, 1400);
    window().resize(high);
    wait_for([&] { return window().size() == high; });
    constexpr int kEdges_px = 8, kRow_px = 44;
    const auto asks_px = [this] { return dock("layers_panel").sizeHint().height(); };
    wait_for([&] { return std::abs(layers_px() - asks_px()) <= kEdges_px; });
    const int few_px = layers_px(), side_px = layers_px() + tool_px();
    EXPECT_LT(layers_px() * 100, side_px * 33) << "its share would be more than a third";
    add_layers(1);
    EXPECT_NEAR(layers_px(), few_px, kEdges_px) << "two rows are there at least";
    add_layers(2);
    wait_for([&] { return std::abs(layers_px() - few_px - 2 * kRow_px) <= kEdges_px; });
    EXPECT_NEAR(layers_px() + tool_px(), side_px, kEdges_px);
    add_layers(12);
    wait_for([&] { return layers_px() > few_px + 2 * kRow_px + kEdges_px; });
    EXPECT_LE(layers_px() * 100, side_px * 40) << "and no more than its share";
    const int most_px = layers_px();
    mouse_stroke(line_mm({12.0, 12.0}, {48.0, 30.0}));
    settle();
    EXPECT_EQ(layers_px(), most_px) << "nothing moves while one paints";
}

TEST_F(WorkspacesWindow, WhoDragsABorderKeepsHisHeights) {
    main::DockHeights& heights = parts().heights;
    EXPECT_TRUE(heights.follows());
    const QRect tool = dock("tool_panel").geometry();
    QPoint border(tool.center().x(), tool.bottom());
    while (!window().isSeparator(border) && border.y() < window().height())
        border.ry() += 1;
    ASSERT_TRUE(window().isSeparator(border));
    QTest::mousePress(&window(), Qt::LeftButton, {}, border);
    QTest::mouseRelease(&window(), Qt::LeftButton, {}, border);
    EXPECT_FALSE(heights.follows());
    start_again();
    EXPECT_FALSE(parts().heights.follows()) << "as they were left";
    give(Command::ResetPanels);
    EXPECT_TRUE(parts().heights.follows());
    start_again();
    EXPECT_TRUE(parts().heights.follows());
    workspaces().save(QStringLiteral("Mine"));
    EXPECT_FALSE(parts().heights.follows()) << "as they were saved";
    start_again();
    EXPECT_FALSE(parts().heights.follows());
}

TEST_F(WorkspacesWindow, EveryOneFitsEveryScreenInEveryLanguage) {
    for (const char* language : {"en", "ja", "sv", "zh_TW"}) {
        SCOPED_TRACE(language);
        main::speak(QString::fromLatin1(language));
        open_another();
        for (const QSize& size : {QSize(1024, 640), QSize(3840, 2160)})
            for (const auto& [command, workspace] : kShipped) {
                window().resize(size);
                wait_for([&] { return window().size() == size; });
                give(command);
                EXPECT_EQ(window().size(), size) << static_cast<int>(workspace);
                EXPECT_GE(canvas().width(), 300) << static_cast<int>(workspace);
                EXPECT_EQ(places(stand()), places(tools::arrangement_of(workspace)));
                for (const QDockWidget* one : window().findChildren<QDockWidget*>())
                    if (one->isVisible() && !one->visibleRegion().isEmpty()) {
                        EXPECT_TRUE(window().rect().contains(one->geometry()))
                            << one->objectName().toStdString();
                    }
            }
    }
}

}  // namespace
}  // namespace pastoso::tests
