// Which keys give which command: a set to start from, and the painter's own over it.
#pragma once

#include "commands/key_bindings.hpp"
#include "dialogs/growing_dialog.hpp"

#include <functional>
#include <map>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace pastoso::dialogs {

class KeyCatcher;

class KeysDialog : public GrowingDialog {
    Q_OBJECT
  public:
    explicit KeysDialog(commands::KeyBindings bindings, QWidget* parent = nullptr);

  Q_SIGNALS:
    /// At every change: there is nothing to be accepted at the end.
    void changed(const pastoso::commands::KeyBindings& bindings);

  private:
    QWidget* make_head();
    QWidget* make_tree();
    QWidget* make_chosen();
    QWidget* make_question();
    QWidget* make_foot();
    void add_key_button(const QKeySequence& key);
    void filter();
    void show_keys();
    void show_chosen();
    std::optional<commands::Command> chosen() const;
    void listen_for_chosen();
    void catch_key(const QKeySequence& key, const QKeySequence& instead_of);
    void give(const commands::KeyBindings::Keys& keys);
    void drop(const QKeySequence& key);
    void reset_chosen();
    void reset_all();
    void tell(const QString& sentence);
    void ask(const QString& sentence, const QString& action, std::function<void()> yes);
    void change();

    commands::KeyBindings bindings_;
    std::map<commands::Command, QTreeWidgetItem*> rows_;
    std::function<void()> yes_;  ///< what the question is about
    QComboBox* sets_ = nullptr;
    QLineEdit* typed_ = nullptr;
    QTreeWidget* tree_ = nullptr;
    QTreeWidgetItem* none_ = nullptr;  ///< is seen where nothing is found
    QLabel* name_ = nullptr;
    QLabel* hint_ = nullptr;
    QHBoxLayout* keys_ = nullptr;
    KeyCatcher* add_ = nullptr;
    KeyCatcher* first_ = nullptr;  ///< of the buttons for keys that are there; null without one
    QLabel* sentence_ = nullptr;
    QPushButton* take_ = nullptr;
    QPushButton* leave_ = nullptr;
    QPushButton* reset_ = nullptr;
    QPushButton* reset_all_ = nullptr;
};

}  // namespace pastoso::dialogs
