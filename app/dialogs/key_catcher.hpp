// A button that takes the next key that is pressed.
#pragma once

#include <QKeySequence>
#include <QPushButton>

namespace pastoso::dialogs {

class KeyCatcher : public QPushButton {
    Q_OBJECT
  public:
    /// Shows `words` while it does not listen.
    explicit KeyCatcher(const QString& words, QWidget* parent = nullptr);

    bool listening() const { return listening_; }
    void listen();
    void stop();  ///< takes none

  Q_SIGNALS:
    void caught(const QKeySequence& key);

  protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    const QString words_;
    bool listening_ = false;
};

}  // namespace pastoso::dialogs
