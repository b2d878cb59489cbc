// A step of the tour, in a bubble beside what it speaks of.
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace pastoso::help {

struct TourStep {
    QString heading, words;
    int number = 1, of = 1;
};

/// Only tells what the painter wants. Of the keys that it has, Return goes on and Escape leaves the
/// tour.
class TourBubble : public QWidget {
    Q_OBJECT
  public:
    /// Hidden, over `parent`.
    explicit TourBubble(QWidget* parent);

    /// Shows the step beside `target`, a place in the parent that the bubble's tip points at, where
    /// there is room.
    void show_step(const TourStep& step, const QRect& target);

    void take_keys();

    /// What it speaks of, or the parent, has another place or size.
    void point_at(const QRect& target);

  Q_SIGNALS:
    void next_wanted();
    void left();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool focusNextPrevChild(bool next) override;

  private:
    void place();

    QLabel* heading_;
    QLabel* words_;
    QLabel* count_;
    QPushButton* next_;
    QPushButton* leave_;
    QRect target_;
    QPoint tip_;  ///< in the bubble; null: it points nowhere
};

}  // namespace pastoso::help
