// The panels that stand around the canvas, each in a dock of its own.

#include "main/dock_arrangement.hpp"
#include "main/panel_set.hpp"
#include "main/studio.hpp"
#include "panels/canvas/easel_panel.hpp"
#include "panels/canvas/light_panel.hpp"
#include "panels/canvas/navigator_panel.hpp"
#include "panels/colour/colour_panel.hpp"
#include "panels/history/history_panel.hpp"
#include "panels/history/recorder_panel.hpp"
#include "panels/layers/layer_panel.hpp"
#include "panels/layers/tracing_panel.hpp"
#include "panels/messages/message_panel.hpp"
#include "panels/paint/load_panel.hpp"
#include "panels/paint/medium_panel.hpp"
#include "panels/paint/paint_panel.hpp"
#include "panels/parts/section.hpp"
#include "panels/pen/brush_panel.hpp"
#include "panels/pen/curves_panel.hpp"
#include "panels/pen/guides_panel.hpp"
#include "panels/references/reference_panel.hpp"
#include "tools/workspaces.hpp"

#include <initializer_list>
#include <utility>

#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QScrollArea>
#include <QTabWidget>
#include <QVBoxLayout>

namespace pastoso::main {

namespace {

using commands::Command;

panels::LayerPanel* make_layer_panel(Studio& studio) {
    const auto action = [&](Command command) { return studio.commands().action(command); };
    return new panels::LayerPanel(
        {action(Command::AddLayer), action(Command::DuplicateLayer), action(Command::GroupLayers),
         action(Command::MergeDown), action(Command::RemoveLayer)},
        {action(Command::RenameLayer), action(Command::ShowLayer), action(Command::LockLayer),
         action(Command::LockBare), action(Command::ClipLayer), nullptr, action(Command::AddLayer),
         action(Command::DuplicateLayer), action(Command::ClearLayer), action(Command::RemoveLayer),
         nullptr, action(Command::MergeDown), action(Command::FlattenLayers),
         action(Command::GroupLayers), action(Command::UngroupLayers)});
}

/// Of actions that stand on buttons.
constexpr std::pair<Command, const char*> kButtonWords[] = {
    {Command::TopUpBrush, QT_TR_NOOP("Top up")},
    {Command::BlotBrush, QT_TR_NOOP("Blot")},
    {Command::SwapPaints, QT_TR_NOOP("Swap")},
    {Command::PickPaint, QT_TR_NOOP("Pick paint")},
    {Command::PickColour, QT_TR_NOOP("Pick colour")},
    {Command::MirrorSymmetry, QT_TR_NOOP("Left, right")},
    {Command::MirrorLevel, QT_TR_NOOP("Above, below")},
    {Command::SnapToGuide, QT_TR_NOOP("Snap")},
    {Command::TracePicture, QT_TR_NOOP("Choose...")},
    {Command::RemoveTracing, QT_TR_NOOP("Take away")},
    {Command::ShowTracing, QT_TR_NOOP("Below the paint")},
    {Command::FitTracing, QT_TR_NOOP("Fit")},
    {Command::AddReference, QT_TR_NOOP("Add...")},
    {Command::FloatReferences, QT_TR_NOOP("Own window")},
    {Command::FitCanvas, QT_TR_NOOP("Fit")},
    {Command::ActualPixels, QT_TR_NOOP("100 %")},
    {Command::TurnUpright, QT_TR_NOOP("Upright")},
    {Command::MirrorView, QT_TR_NOOP("Mirror")},
    {Command::Play, QT_TR_NOOP("Watch it grow...")},
    {Command::MakeTimelapse, QT_TR_NOOP("Make a time-lapse...")},
    {Command::PaintAgain, QT_TR_NOOP("Paint it again, finer...")},
    {Command::SaveRecording, QT_TR_NOOP("Save the recording...")},
};

/// All but the tool's panel, which is made of two.
void make_panels(Studio& studio, PanelSet& panels) {
    for (const auto& [command, words] : kButtonWords)
        studio.commands().action(command)->setIconText(
            QCoreApplication::translate("pastoso::main", words));
    const auto action = [&](Command command) { return studio.commands().action(command); };
    panels.colours = new panels::ColourPanel({action(Command::PickPaint), action(Command::PickColour)});
    panels.physics = new panels::MediumPanel;
    panels.guides = new panels::GuidesPanel(
        {action(Command::MirrorSymmetry), action(Command::MirrorLevel), action(Command::SnapToGuide),
         action(Command::GuideHandles), action(Command::RemoveGuides)});
    panels.lights = new panels::LightPanel;
    panels.layers = make_layer_panel(studio);
    panels.tracing =
        new panels::TracingPanel({action(Command::TracePicture), action(Command::RemoveTracing)},
                                 {action(Command::ShowTracing), action(Command::FitTracing)});
    panels.references =
        new panels::ReferencePanel({action(Command::AddReference), action(Command::FloatReferences)});
    panels.history = new panels::HistoryPanel;
    panels.navigator =
        new panels::NavigatorPanel({action(Command::FitCanvas), action(Command::ActualPixels)},
                                   {action(Command::TurnUpright), action(Command::MirrorView)},
                                   screen::kSmallestZoom, screen::kLargestZoom);
    panels.messages = new panels::MessagePanel;
    panels.messages->follow(studio.messages());
    panels.recorder =
        new panels::RecorderPanel({action(Command::Play), action(Command::MakeTimelapse),
                                   action(Command::PaintAgain), action(Command::SaveRecording)});
}

QWidget* make_tool_panel(Studio& studio, PanelSet& panels) {
    const auto action = [&](Command command) { return studio.commands().action(command); };
    panels.load = new panels::LoadPanel({action(Command::TopUpBrush), action(Command::BlotBrush)},
                                        action(Command::SwapPaints));
    panels.curves = new panels::CurvesPanel;
    auto* tool = new QWidget;
    auto* column = new QVBoxLayout(tool);
    column->setSpacing(12);
    column->addWidget(panels.load);
    column->addWidget(panels.curves);
    column->addStretch(1);
    return tool;
}

struct Dock {
    Command command;   ///< that shows it
    const char* name;  ///< in what is remembered of the panels
    const char* title;
    QWidget* content;
    bool is_whole = false;  ///< nothing of it is scrolled away where the window is low
};

/// That the Tab key would reach; null where there is none.
QWidget* first_control(const QWidget* content) {
    for (QWidget* one = content->nextInFocusChain(); one != content; one = one->nextInFocusChain()) {
        const bool takes_keys =
            one->isVisible() && one->isEnabled() && (one->focusPolicy() & Qt::TabFocus);
        if (takes_keys && content->isAncestorOf(one)) return one;
    }
    return nullptr;
}

/// One that has room enough does not take that of others.
QWidget* kept_low(QWidget* panel) {
    auto* low = new QWidget;
    auto* column = new QVBoxLayout(low);
    column->addWidget(panel);
    column->addStretch(1);
    return low;
}

QDockWidget* add_dock(Studio& studio, PanelSet& panels, const Dock& added) {
    QWidget* content = added.content;
    content->layout()->setContentsMargins(10, 4, 10, 4);
    auto* dock =
        new QDockWidget(QCoreApplication::translate("pastoso::main", added.title), &studio.window());
    dock->setObjectName(QString::fromLatin1(added.name));
    dock->setWidget(added.is_whole ? content : panels::scrolled(content));
    studio.window().addDockWidget(Qt::RightDockWidgetArea, dock);
    panels.docks[added.command] = dock;
    studio.commands().on(added.command, [dock, content](bool) {
        dock->show();
        dock->raise();
        if (QWidget* first = first_control(content)) first->setFocus(Qt::TabFocusReason);
    });
    return dock;
}

}  // namespace

void add_docks(Studio& studio, PanelSet& panels) {
    make_panels(studio, panels);
    QMainWindow& window = studio.window();
    for (const Qt::DockWidgetArea side : {Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea})
        window.setTabPosition(side, QTabWidget::North);
    for (const Dock& dock : std::initializer_list<Dock>{
             {Command::BrushesPanel, "brushes_panel", QT_TR_NOOP("Brushes"), panels.brushes},
             {Command::PaintsPanel, "paints_panel", QT_TR_NOOP("Paints"), panels.paints},
             {Command::EaselPanel, "easel_panel", QT_TR_NOOP("Easel"), kept_low(panels.stand)},
             {Command::ToolPanel, "tool_panel", QT_TR_NOOP("Tool"), make_tool_panel(studio, panels)},
             {Command::ColourPanel, "colour_panel", QT_TR_NOOP("Colour"), panels.colours},
             {Command::PhysicsPanel, "physics_panel", QT_TR_NOOP("Physics"), panels.physics},
             {Command::GuidesPanel, "guides_panel", QT_TR_NOOP("Guides"), panels.guides},
             {Command::LightPanel, "light_panel", QT_TR_NOOP("Lights"), panels.lights},
             {Command::LayersPanel, "layers_panel", QT_TR_NOOP("Layers"), panels.layers, true},
             {Command::TracingPanel, "tracing_panel", QT_TR_NOOP("Tracing"), panels.tracing},
             {Command::ReferencesPanel, "references_panel", QT_TR_NOOP("References"), panels.references},
             {Command::HistoryPanel, "history_panel", QT_TR_NOOP("History"), panels.history},
             {Command::NavigatorPanel, "navigator_panel", QT_TR_NOOP("Navigator"), panels.navigator},
             {Command::RecorderPanel, "recorder_panel", QT_TR_NOOP("Recorder"), panels.recorder},
             {Command::MessagesPanel, "messages_panel", QT_TR_NOOP("Messages"), panels.messages}})
        add_dock(studio, panels, dock);
    // So many names would not fit beside one another: the others are opened when they are needed.
    arrange_docks(window, tools::arrangement_of(tools::Workspace::Oil), tools::panels_at_home());
}

}  // namespace pastoso::main
