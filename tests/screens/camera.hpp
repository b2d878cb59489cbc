// Takes pictures of the window and of what it opens.
#pragma once

#include "main/main_window.hpp"

#include <functional>

#include <QPixmap>
#include <QString>

class QDockWidget;

namespace pastoso::screens {

/// The window, and where its pictures go.
class Camera {
  public:
    Camera(main::MainWindow& window, QString folder) : window_(window), folder_(std::move(folder)) {}

    main::MainWindow& window() { return window_; }
    void give(commands::Command command) { window_.studio().commands().action(command)->trigger(); }

    /// Until all that was posted is applied and the canvas stands there in full.
    void settle();

    /// Of the whole window once the canvas stands there in full.
    QPixmap look();

    /// The same of the canvas alone.
    QPixmap look_at_canvas();

    void take(const QString& name) { save(look(), name); }
    void take_canvas(const QString& name) { save(look_at_canvas(), name); }

    /// Of the dialog that the command opens, after `prepare` has had its way with it.
    void take_dialog(commands::Command command, const QString& name,
                     const std::function<void(QWidget&)>& prepare = {});

    /// Of a panel by its short name, "tool" for example, as tall as all that it holds.
    void take_panel(const char* short_name);

    void save(const QPixmap& picture, const QString& name);

    QString path_of(const QString& name) const;

    void complain(const QString& name);
    bool complete() const { return complete_; }

  private:
    main::MainWindow& window_;
    QString folder_;
    bool complete_ = true;
};

/// In few colours, and no wider than a page of the manual; false when it cannot.
bool write(const QPixmap& picture, const QString& path);

/// Goes on until the condition holds; false when it does not for long.
bool wait_for(const std::function<bool()>& condition);

/// Lets the window do what it does by itself for a moment.
void pass_time();

/// Until what is being opened or made stands on the easel.
void wait_for_painting(main::MainWindow& window);

/// A picture of what lies over a window put where it lies in one of the window.
QPixmap with(QPixmap below, const QWidget& ground, QWidget& above);

QPixmap middle_of(const QPixmap& picture, const QSize& size);

/// Pictures side by side, so many in a row, all as large as the first.
QPixmap sheet(const QList<QPixmap>& pictures, int columns);

}  // namespace pastoso::screens
