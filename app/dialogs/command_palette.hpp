// A light list of every command, found by a few letters of its words, and of what else can be taken by
// name.
#pragma once

#include "commands/command_registry.hpp"

#include <functional>
#include <utility>
#include <vector>

#include <QFrame>
#include <QString>

class QLabel;
class QLineEdit;
class QListView;
class QStandardItemModel;

namespace pastoso::dialogs {

/// What is no command but is found like one: a tool, a paint, a medium, a control of a panel.
struct Offer {
    QString words;
    QString kind;
    QString hint;
    std::function<void()> take;
    QString synonyms{};  ///< what else it is found by
    bool can = true;     ///< be taken now
};

class CommandPalette : public QFrame {
    Q_OBJECT
  public:
    CommandPalette(const commands::CommandRegistry& commands, QWidget* parent);

    /// Once something is typed, what fits of these is found as well; they are asked for when the list
    /// opens.
    void offer_also(std::function<std::vector<Offer>()> offers) { offers_of_ = std::move(offers); }

    /// At the top of `place`, in the middle, with nothing typed: what was given last comes first.
    void open_over(const QWidget& place);

  protected:
    bool eventFilter(QObject* object, QEvent* event) override;

  private:
    void list();
    void add(commands::Command command);
    void add(std::size_t offer);
    void list_found();
    void fit_height();
    void show_hint();
    void run();

    const commands::CommandRegistry& commands_;
    std::function<std::vector<Offer>()> offers_of_;
    std::vector<Offer> offers_;
    QLineEdit* typed_;
    QListView* list_;
    QLabel* hint_;
    QStandardItemModel* model_;
};

}  // namespace pastoso::dialogs
