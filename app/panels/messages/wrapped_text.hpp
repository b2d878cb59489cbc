// A text of as many lines as its width asks for.
#pragma once

#include <QString>
#include <QWidget>

namespace pastoso::panels {

/// Breaks within words where it must, as in long paths: nothing of it is ever cut off.
class WrappedText : public QWidget {
    Q_OBJECT
  public:
    explicit WrappedText(const QString& text, QWidget* parent = nullptr);

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QString text_;
};

}  // namespace pastoso::panels
