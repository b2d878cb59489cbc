// The tour: three steps beside what they speak of, for a painter who has not been here.
#pragma once

#include "main/panel_set.hpp"
#include "main/studio.hpp"

#include <QObject>
#include <QPointer>

namespace pastoso::help {
class TourBubble;
}

namespace pastoso::main {

class TourCommands : public QObject {
    Q_OBJECT
  public:
    TourCommands(Studio& studio, const PanelSet& panels);

    /// From the first step on.
    void begin();
    /// The same as soon as nothing lies over the canvas, once: whoever has seen the tour, or left it,
    /// is not shown it again.
    void begin_at_first_start(bool canvas_is_free);
    /// The canvas can be seen now.
    void canvas_freed();
    void end();

    bool seen() const { return seen_; }
    void set_seen(bool seen) { seen_ = seen; }

    /// What it speaks of may move.
    bool eventFilter(QObject* object, QEvent* event) override;

  private:
    void show_step();
    QRect target() const;
    void go_on();

    Studio& studio_;
    const PanelSet& panels_;
    QPointer<help::TourBubble> bubble_;  ///< the window's, while the tour lasts
    int step_ = 0;
    bool seen_ = false;
    bool waits_ = false;  ///< for the canvas to be free
};

}  // namespace pastoso::main
