// A list of which the painter takes one entry: by a click, or by keys while the list has the keyboard.
#pragma once

#include <QListWidget>

namespace pastoso::panels {

/// A click gives it the keyboard until the pointer is over the canvas again. Then arrows take the next
/// entry and letters the one whose name begins with them. Names are never cut: a row is as high as its
/// name needs in the width of the list.
class ChoiceList : public QListWidget {
    Q_OBJECT
  public:
    explicit ChoiceList(QWidget* parent = nullptr);

  Q_SIGNALS:
    void taken(QListWidgetItem* item);

  protected:
    void keyPressEvent(QKeyEvent* event) override;
};

}  // namespace pastoso::panels
