// A list of which the painter takes one entry: by a click, or by keys while the list has the keyboard.
#pragma once

#include <QListWidget>

namespace pastoso::panels {

/// A click gives it the keyboard until the pointer is over the canvas again. Then arrows take the next
/// entry and letters the one whose name begins with them, also with digits behind them. Names are never
/// cut: a row is as high as its name needs in the width of the list.
class ChoiceList : public QListWidget {
    Q_OBJECT
  public:
    explicit ChoiceList(QWidget* parent = nullptr);

    /// Entries can be dragged to other places, or moved there with Alt and the arrows.
    void let_arrange();

  Q_SIGNALS:
    void taken(QListWidgetItem* item);
    void arranged();                             ///< the entries stand in another order
    void removal_wanted(QListWidgetItem* item);  ///< by Delete or Backspace

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    void move_current(int rows);
};

}  // namespace pastoso::panels
