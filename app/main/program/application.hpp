// The event loop of the program, past which no exception gets.
#pragma once

#include <QApplication>
#include <QString>

namespace pastoso::main {

class Application : public QApplication {
    Q_OBJECT
  public:
    /// Numbers keep the notation of C for all libraries, whatever the desktop's language: Qt takes over
    /// the locale of the environment, and files are no place for its commas.
    Application(int& argc, char** argv);

    /// What a slot or a widget throws ends the event alone; it is told and goes to the error stream.
    /// Shift+F10 opens the menu of what has the keyboard, as the Menu key does.
    bool notify(QObject* receiver, QEvent* event) override;

  Q_SIGNALS:
    void failed(const QString& sentence);
};

}  // namespace pastoso::main
