// What stands in the middle of the window in place of the canvas: the glass, its timeline below it and
// its panel beside it.
#pragma once

#include "tea/tea_panel.hpp"
#include "tea/tea_view.hpp"

#include <QWidget>

class QLabel;
class QSlider;

namespace pastoso::tea {

class TeaPage : public QWidget {
    Q_OBJECT
  public:
    explicit TeaPage(const TeaActions& actions, QWidget* parent = nullptr);

    TeaView& view() { return *view_; }
    TeaPanel& panel() { return *panel_; }

    void show_status(const session::TeaStatus& status);

  Q_SIGNALS:
    /// The moment at that step is to be shown.
    void step_wanted(int step);

  private:
    QWidget* timeline(const TeaActions& actions);

    TeaView* view_;
    TeaPanel* panel_;
    QSlider* time_ = nullptr;
    QLabel *time_words_ = nullptr, *readings_ = nullptr;
};

}  // namespace pastoso::tea
