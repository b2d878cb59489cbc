// The last messages, to be read again and copied.
#pragma once

#include "panels/messages/message_log.hpp"

#include <QWidget>

class QPlainTextEdit;

namespace pastoso::panels {

class MessagePanel : public QWidget {
    Q_OBJECT
  public:
    explicit MessagePanel(QWidget* parent = nullptr);

    /// From now on it lists what that tells.
    void follow(MessageLog& log);

    /// All that stands there, each message with its time before it.
    QString text() const;

  private:
    void add(const QString& sentence);

    QPlainTextEdit* list_;
};

}  // namespace pastoso::panels
