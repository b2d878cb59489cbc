// The manual, by what the painter points at; what is new; and what the program is.
#pragma once

#include "help/help_window.hpp"
#include "main/studio.hpp"

#include <QPointer>

namespace pastoso::main {

class HelpCommands : public QObject {
    Q_OBJECT
  public:
    explicit HelpCommands(Studio& studio);

    /// The manual's key is heard in dialogs too.
    bool eventFilter(QObject* receiver, QEvent* event) override;

  private:
    help::HelpWindow& window();
    void open();
    void show_news();
    void show_about();

    Studio& studio_;
    QPointer<help::HelpWindow>
        window_;  ///< the program's window's, or that of the dialog it is read beside
};

}  // namespace pastoso::main
