// A round button that is a paint, a thumbnail, or a few letters.
#pragma once

#include <QAbstractButton>
#include <QColor>
#include <QImage>

namespace pastoso::panels {

class RoundButton : public QAbstractButton {
    Q_OBJECT
  public:
    RoundButton(int diameter, QWidget* parent);

    /// `words` name it, in the tool tip and for those who hear the screen read.
    void show_colour(const QColor& colour, const QString& words);
    void show_picture(const QImage& picture);
    void show_words(const QString& words);
    const QColor& colour() const { return colour_; }

    /// Around that point of its parent.
    void move_middle(const QPointF& place);

    QSize sizeHint() const override { return size(); }

  protected:
    void paintEvent(QPaintEvent* event) override;
    bool hitButton(const QPoint& place) const override;
    void focusInEvent(QFocusEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void paint_face(QPainter& painter, const QRectF& disc);

    QColor colour_;
    QImage picture_;
};

}  // namespace pastoso::panels
