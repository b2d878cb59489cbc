// A button that is a patch of paint.
#pragma once

#include "tools/drawdown.hpp"

#include <optional>

#include <QColor>
#include <QPushButton>

namespace pastoso::panels {

class PaintSwatch : public QPushButton {
    Q_OBJECT
  public:
    explicit PaintSwatch(QWidget* parent = nullptr);

    /// `words` name it, in the tool tip and for those who hear the screen read.
    void show_paint(const QColor& colour, const QString& words);
    /// Beside the colour, how well the paint hides.
    void show_drawdown(const tools::Drawdown& drawdown);
    const QColor& colour() const { return colour_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

  Q_SIGNALS:
    void removal_wanted();  ///< by the right button, or by Delete

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    QColor colour_;
    std::optional<tools::Drawdown> drawdown_;
};

}  // namespace pastoso::panels
