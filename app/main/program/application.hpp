// The event loop of the program, past which no exception gets.
#pragma once

#include <QApplication>
#include <QString>

namespace pastoso::main {

class Application : public QApplication {
    Q_OBJECT
  public:
    using QApplication::QApplication;

    /// What a slot or a widget throws ends the event alone; it is told and goes to the error stream.
    bool notify(QObject* receiver, QEvent* event) override;

  Q_SIGNALS:
    void failed(const QString& sentence);
};

}  // namespace pastoso::main
