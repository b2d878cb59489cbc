// A light list of every command, found by a few letters of its words.
#pragma once

#include "commands/command_registry.hpp"

#include <QFrame>

class QLabel;
class QLineEdit;
class QListView;
class QStandardItemModel;

namespace pastoso::dialogs {

class CommandPalette : public QFrame {
    Q_OBJECT
  public:
    CommandPalette(const commands::CommandRegistry& commands, QWidget* parent);

    /// At the top of `place`, in the middle, with nothing typed: what was given last comes first.
    void open_over(const QWidget& place);

  protected:
    bool eventFilter(QObject* object, QEvent* event) override;

  private:
    void list();
    void add(commands::Command command);
    void fit_height();
    void show_hint();
    void run();

    const commands::CommandRegistry& commands_;
    QLineEdit* typed_;
    QListView* list_;
    QLabel* hint_;
    QStandardItemModel* model_;
};

}  // namespace pastoso::dialogs
