// Panels that stand where the painter has them: workspaces by name, left and right changed for left
// hands, the tool bar.
#pragma once

#include "main/panel_set.hpp"
#include "main/program/remembered_file.hpp"
#include "main/studio.hpp"
#include "tools/workspaces.hpp"

#include <QObject>

class QMenu;

namespace pastoso::main {

class DockHeights;

class WorkspaceCommands : public QObject {
    Q_OBJECT
  public:
    WorkspaceCommands(Studio& studio, const PanelSet& panels, DockHeights& heights);

    /// Where `stand` is false, the panels do not stand yet as they were left, and are put up as in the
    /// workspace in use. A file that cannot be read is told, and left as it is.
    void recall(bool stand);

    void use(tools::Workspace shipped);
    /// An own one that there is.
    void use(const std::string& own);

    /// Keeps the panels as they stand, in place of an own workspace of that name. Names of those that
    /// come with the program are refused, as empty ones are; that is told.
    void save(const QString& name);
    /// Of the own one in use. A name that another one has is refused, too.
    void rename_in_use(const QString& name);

    /// Left and right change places.
    void set_left_handed(bool left_handed);

    const tools::Workspaces& workspaces() const { return workspaces_; }

  Q_SIGNALS:
    /// The panels are going to stand otherwise: all of them have to be there.
    void arranging();

  private:
    void connect_commands();
    void ask_save();
    void ask_rename();
    void remove();
    void reset();
    bool may_be(const QString& name);
    void put_up(const tools::PanelArrangement& right_handed);
    void size_panels();
    void remember();
    void show();
    void fill_menu();

    Studio& studio_;
    const PanelSet& panels_;
    DockHeights& heights_;
    QMenu* menu_;
    QList<QAction*> own_;  ///< in the menu
    tools::Workspaces workspaces_;
    RememberedFile file_;
};

}  // namespace pastoso::main
