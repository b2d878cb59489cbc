// A heading that a click opens and folds, with what belongs to it below.
#pragma once

#include <QWidget>

class QToolButton;
class QVBoxLayout;

namespace pastoso::panels {

/// Folded at first. `name` is the button's object name.
class Fold : public QWidget {
    Q_OBJECT
  public:
    Fold(const QString& name, const QString& words, const QString& hint, QWidget* parent = nullptr);

    /// The column of what is seen while it is open.
    QVBoxLayout* column() { return column_; }

    void open(bool open);
    bool is_open() const;

    /// Folded it is as wide as open, so that nobody has to make room for it.
    QSize minimumSizeHint() const override;

  private:
    QToolButton* button_;
    QVBoxLayout* column_;
};

}  // namespace pastoso::panels
