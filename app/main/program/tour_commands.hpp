// The tour: three steps beside what they speak of, for a painter who has not been here. Each goes on
// once the painter has done what it says.
#pragma once

#include "main/panel_set.hpp"
#include "main/studio.hpp"

#include <cstdint>
#include <set>

#include <QObject>
#include <QPointer>

namespace pastoso::help {
class TourBubble;
class TourFrame;
}  // namespace pastoso::help

namespace pastoso::main {

class TourCommands : public QObject {
    Q_OBJECT
  public:
    enum class Deed { Stroke, MoveCanvas, PickPaint, ChoosePaint, TakeBack };

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
    void show_frames();
    QRect target() const;
    const QWidget* place_of(Deed deed) const;
    bool moves_canvas(const QEvent& event) const;
    void take(const session::Status& status);
    void note(Deed deed);
    void go_on();

    Studio& studio_;
    const PanelSet& panels_;
    /// The window's, while the tour lasts.
    QPointer<help::TourBubble> bubble_;
    QPointer<help::TourFrame> frame_;
    std::set<Deed> open_;  ///< what of the step is not done yet
    std::int64_t strokes_ = 0;
    int step_ = 0;
    bool seen_ = false;
    bool waits_ = false;  ///< for the canvas to be free
};

}  // namespace pastoso::main
