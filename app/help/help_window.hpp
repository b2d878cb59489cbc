// The manual in a window of its own, beside the painting.
#pragma once

#include "help/help_view.hpp"
#include "help/manual.hpp"

#include <QWidget>

class QLineEdit;
class QListWidget;
class QStackedWidget;
class QTreeWidget;
class QTreeWidgetItem;

namespace pastoso::help {

/// Its pages on the left, or what is found in them; the one that is read on the right.
class HelpWindow : public QWidget {
    Q_OBJECT
  public:
    /// The parent is the window that it belongs to.
    HelpWindow(Manual manual, QWidget* parent);

    /// Shows itself, in front, with that part of the manual (HelpView::show_topic).
    void open_at(const QString& topic);

    /// The same with what has changed.
    void open_news();

    HelpView& view() { return *view_; }

  protected:
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void come_up();
    void make_bar();
    void fill_contents();
    void mark_page();
    void search(const QString& words);

    const Manual manual_;
    HelpView* view_;
    QLineEdit* words_;
    QTreeWidget* contents_;
    QListWidget* found_;
    QStackedWidget* side_;
};

}  // namespace pastoso::help
