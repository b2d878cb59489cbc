// All that the pointer can do over one canvas, the first before the others.
#pragma once

#include "view/interaction.hpp"

#include <vector>

namespace pastoso::view {

/// Gives every event to whom it belongs.
class InteractionStack {
  public:
    /// Asked after those that are there. It has to live as long as this is told of events.
    void add(Interaction& interaction) { interactions_.push_back(&interaction); }

    /// A release that got lost on its way is made good at the next event.
    void handle(const input::PointerEvent& event);
    void cancel();

    bool key(const QKeyEvent& event);
    bool needs_key(const QKeyEvent& event) const;
    void keys_lost();
    void draw(const Overlay& overlay);

    QCursor cursor() const;

    /// Whether a press would not get as far as this one.
    bool is_behind_mode(const Interaction& interaction) const;

  private:
    void press(const input::PointerEvent& event);
    void release(const input::PointerEvent& event);

    std::vector<Interaction*> interactions_;
    Interaction* holder_ = nullptr;
    Qt::MouseButton held_by_ = Qt::NoButton;
};

}  // namespace pastoso::view
