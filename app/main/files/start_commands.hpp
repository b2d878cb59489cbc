// The start page over the canvas: when it is there, and what becomes of what the painter chooses on it.
#pragma once

#include "main/studio.hpp"

#include <QObject>

namespace pastoso::start {
class StartPage;
}

namespace pastoso::main {

class MessagePlace;
class ProjectFiles;

class StartCommands : public QObject {
    Q_OBJECT
  public:
    /// The page leaves those messages free.
    StartCommands(Studio& studio, ProjectFiles& files, const MessagePlace& messages);

    /// Shows the page, with what was left unfinished.
    void show_page();

    /// What meets the painter who starts the program: the page, unless it is not wanted there; then
    /// only what was left unfinished is offered.
    void welcome();

    void set_shown_at_start(bool shown);
    bool shown_at_start() const;

    bool page_is_shown() const;

  Q_SIGNALS:
    /// The page lies over the canvas no more.
    void dismissed();

  private:
    start::StartPage& page();
    void connect_choices(start::StartPage& page);
    void dismiss();
    void place();

    Studio& studio_;
    ProjectFiles& files_;
    const MessagePlace& messages_;
    start::StartPage* page_ = nullptr;  ///< made when it is first wanted
    bool shown_at_start_ = true;
};

}  // namespace pastoso::main
