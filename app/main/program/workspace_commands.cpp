#include "main/program/workspace_commands.hpp"

#include "commands/command_words.hpp"
#include "core/user_data.hpp"
#include "dialogs/name_question.hpp"
#include "main/dock_arrangement.hpp"
#include "main/dock_heights.hpp"
#include "panels/parts/tool_bar.hpp"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

namespace pastoso::main {
namespace {

using commands::Command;
using tools::PanelArrangement;
using tools::Workspace;

constexpr std::pair<Command, Workspace> kShipped[] = {{Command::WorkspaceSketch, Workspace::Sketch},
                                                      {Command::WorkspaceOil, Workspace::Oil},
                                                      {Command::WorkspaceMixing, Workspace::Mixing},
                                                      {Command::WorkspaceExport, Workspace::Export}};

/// In which that command stands.
QMenu* menu_of(const QMenuBar* bar, QAction* command) {
    for (const QAction* title : bar->actions())
        if (title->menu() != nullptr && title->menu()->actions().contains(command)) return title->menu();
    return nullptr;
}

/// A bar on the left comes to stand on the right, and the other way round.
void mirror(QMainWindow& window, QToolBar* bar) {
    if (bar->isFloating()) return;
    const Qt::ToolBarArea area = window.toolBarArea(bar);
    if (area == Qt::LeftToolBarArea) window.addToolBar(Qt::RightToolBarArea, bar);
    if (area == Qt::RightToolBarArea) window.addToolBar(Qt::LeftToolBarArea, bar);
}

}  // namespace

WorkspaceCommands::WorkspaceCommands(Studio& studio, const PanelSet& panels, DockHeights& heights)
    : studio_(studio),
      panels_(panels),
      heights_(heights),
      menu_(menu_of(studio.window().menuBar(), studio.commands().action(Command::SaveWorkspace))),
      file_(studio, core::user_config_path("workspaces.json"),
            [](const auto& file) { tools::read_workspaces(file); }) {
    connect_commands();
    // What stands in the canvas' place has no panels.
    connect(menu_, &QMenu::aboutToShow, this, [this] {
        for (QAction* own : own_)
            own->setVisible(studio_.commands().action(Command::SaveWorkspace)->isVisible());
    });
    QAction* shown = studio_.commands().action(Command::ToolBar);
    studio_.commands().on(Command::ToolBar, [this](bool wanted) { panels_.bar->setVisible(wanted); });
    connect(panels_.bar, &QToolBar::visibilityChanged, this,
            [this, shown] { shown->setChecked(!panels_.bar->isHidden()); });
}

void WorkspaceCommands::connect_commands() {
    commands::CommandRegistry& commands = studio_.commands();
    for (const auto& [command, workspace] : kShipped)
        commands.on(command, [this, workspace = workspace](bool) { use(workspace); });
    commands.on(Command::SaveWorkspace, [this](bool) { ask_save(); });
    commands.on(Command::RenameWorkspace, [this](bool) { ask_rename(); });
    commands.on(Command::RemoveWorkspace, [this](bool) { remove(); });
    commands.on(Command::ResetPanels, [this](bool) { reset(); });
    commands.on(Command::LeftHanded, [this](bool left_handed) { set_left_handed(left_handed); });
}

void WorkspaceCommands::recall(bool stand) {
    file_.recall([this](const auto& file) { workspaces_ = tools::read_workspaces(file); });
    if (!stand) put_up(tools::arrangement_in_use(workspaces_));
    if (!stand || heights_.follows()) size_panels();
    show();
}

void WorkspaceCommands::use(Workspace shipped) {
    tools::use(shipped, workspaces_);
    put_up(tools::arrangement_of(shipped));
    size_panels();
    remember();
}

void WorkspaceCommands::use(const std::string& name) {
    const tools::OwnWorkspace* own = tools::find_own(workspaces_, name);
    tools::use(*own, workspaces_);
    put_up(own->panels);
    size_panels();
    remember();
}

void WorkspaceCommands::put_up(const PanelArrangement& right_handed) {
    Q_EMIT arranging();
    const auto turned = [this](const PanelArrangement& panels) {
        return workspaces_.left_handed ? tools::mirrored(panels) : panels;
    };
    arrange_docks(studio_.window(), turned(right_handed), turned(tools::panels_at_home()));
    studio_.canvas().setFocus();
}

/// In an own one they are as they were saved.
void WorkspaceCommands::size_panels() {
    if (workspaces_.in_use.empty())
        heights_.follow(tools::arrangement_in_use(workspaces_));
    else
        heights_.leave_as_they_are();
}

void WorkspaceCommands::set_left_handed(bool left_handed) {
    if (left_handed == workspaces_.left_handed) return;
    Q_EMIT arranging();
    const PanelArrangement stand = read_docks(studio_.window());
    const bool was_left_handed = std::exchange(workspaces_.left_handed, left_handed);
    mirror(studio_.window(), panels_.bar);
    put_up(was_left_handed ? tools::mirrored(stand) : stand);
    if (heights_.follows()) size_panels();
    remember();
}

void WorkspaceCommands::save(const QString& name) {
    if (!may_be(name)) return;
    Q_EMIT arranging();
    const PanelArrangement stand = read_docks(studio_.window());
    tools::keep(name.trimmed().toStdString(), workspaces_.left_handed ? tools::mirrored(stand) : stand,
                workspaces_);
    size_panels();
    remember();
}

void WorkspaceCommands::rename_in_use(const QString& name) {
    const std::string wanted = name.trimmed().toStdString();
    if (!may_be(name)) return;
    const bool is_taken =
        wanted != workspaces_.in_use && tools::find_own(workspaces_, wanted) != nullptr;
    if (is_taken) return studio_.report(tr("There is a workspace \"%1\" already.").arg(name.trimmed()));
    tools::rename_in_use(wanted, workspaces_);
    remember();
}

bool WorkspaceCommands::may_be(const QString& name) {
    if (name.trimmed().isEmpty()) return false;
    const bool is_shipped = std::ranges::any_of(kShipped, [&](const auto& shipped) {
        const QString words = commands::plain_words(commands::text_of(shipped.first).words);
        return words.compare(name.trimmed(), Qt::CaseInsensitive) == 0;
    });
    if (is_shipped)
        studio_.report(
            tr("The workspace \"%1\" comes with the program: choose another name.").arg(name.trimmed()));
    return !is_shipped;
}

void WorkspaceCommands::remove() {
    tools::remove_in_use(workspaces_);
    remember();
}

/// The tool bar is above, too.
void WorkspaceCommands::reset() {
    studio_.window().addToolBar(Qt::TopToolBarArea, panels_.bar);
    panels_.bar->setVisible(true);
    use(Workspace::Oil);
}

/// An own one may be chosen to be replaced.
void WorkspaceCommands::ask_save() {
    QStringList names;
    for (const tools::OwnWorkspace& own : workspaces_.own)
        names.push_back(QString::fromStdString(own.name));
    const int in_use = static_cast<int>(names.indexOf(QString::fromStdString(workspaces_.in_use)));
    if (in_use < 0) names.push_front(QString());
    const auto name = dialogs::ask_name(
        {.title = tr("Save the workspace"),
         .label = tr("Name of the workspace; one of your own with this name is replaced:"),
         .proposal = names[std::max(0, in_use)],
         .choices = names},
        &studio_.window());
    if (name) save(*name);
}

void WorkspaceCommands::ask_rename() {
    const auto name = dialogs::ask_name({.title = tr("Rename the workspace"),
                                         .label = tr("Name of the workspace:"),
                                         .proposal = QString::fromStdString(workspaces_.in_use)},
                                        &studio_.window());
    if (name) rename_in_use(*name);
}

void WorkspaceCommands::remember() {
    file_.remember([this](const auto& file) { tools::write_workspaces(workspaces_, file); });
    show();
}

void WorkspaceCommands::show() {
    const commands::CommandRegistry& commands = studio_.commands();
    for (const auto& [command, workspace] : kShipped)
        commands.action(command)->setChecked(workspaces_.in_use.empty() &&
                                             workspaces_.shipped == workspace);
    for (const Command command : {Command::RenameWorkspace, Command::RemoveWorkspace})
        commands.action(command)->setEnabled(!workspaces_.in_use.empty());
    commands.action(Command::LeftHanded)->setChecked(workspaces_.left_handed);
    fill_menu();
}

/// Behind those that come with the program.
void WorkspaceCommands::fill_menu() {
    // The one that was chosen tells this.
    for (QAction* own : std::exchange(own_, {})) {
        menu_->removeAction(own);
        own->deleteLater();
    }
    const QList<QAction*> actions = menu_->actions();
    QAction* line = actions[actions.indexOf(studio_.commands().action(Command::SaveWorkspace)) - 1];
    for (const tools::OwnWorkspace& own : workspaces_.own) {
        const QString name = QString::fromStdString(own.name);
        auto* action = new QAction(QString(name).replace(QLatin1Char('&'), QStringLiteral("&&")), this);
        action->setCheckable(true);
        action->setChecked(own.name == workspaces_.in_use);
        connect(action, &QAction::triggered, this, [this, name = own.name] { use(name); });
        menu_->insertAction(line, action);
        own_.push_back(action);
    }
}

}  // namespace pastoso::main
