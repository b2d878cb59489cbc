// The start page over the canvas: when it is there, and what becomes of what the painter chooses on it.
#pragma once

#include "main/studio.hpp"

#include <QObject>

namespace pastoso::start {
class StartPage;
}

namespace pastoso::main {

class ProjectFiles;

class StartCommands : public QObject {
    Q_OBJECT
  public:
    StartCommands(Studio& studio, ProjectFiles& files);

    /// Shows the page, with what was left unfinished.
    void show_page();

    /// What meets the painter who starts the program: the page, unless it is not wanted there; then
    /// only what was left unfinished is offered.
    void welcome();

    void set_shown_at_start(bool shown);
    bool shown_at_start() const;

  protected:
    bool eventFilter(QObject* object, QEvent* event) override;

  private:
    start::StartPage& page();
    void connect_choices(start::StartPage& page);
    void dismiss();

    Studio& studio_;
    ProjectFiles& files_;
    start::StartPage* page_ = nullptr;  ///< made when it is first wanted
    bool shown_at_start_ = true;
};

}  // namespace pastoso::main
