// What stands in the middle of the window in place of the canvas: a liquid, its timeline below it and
// its panel beside it.
#pragma once

#include "glass/panel_parts.hpp"
#include "session/liquid_session.hpp"

#include <QWidget>

class QLabel;
class QSlider;

namespace pastoso::glass {

class GlassView;

/// Of the timeline.
struct TimelineWords {
    QString name;  ///< of its widgets: NAME_time, NAME_time_words
    QString what;  ///< "Moment of the tea"
    QString hint;
    QString readings_hint;
    QString busy;  ///< while the glass is filled
};

class GlassPage : public QWidget {
    Q_OBJECT
  public:
    GlassPage(GlassView* view, QWidget* panel, const GlassActions& actions, const TimelineWords& words,
              QWidget* parent = nullptr);

    virtual GlassView& view() = 0;

  Q_SIGNALS:
    /// The moment at that step is to be shown.
    void step_wanted(int step);

  protected:
    /// The timeline, and beside it how much liquid there is and how fast it goes. Times have that many
    /// decimals. Over the view stands that it is paused, or else `note`: what to do with a liquid at
    /// rest.
    void show_time(const session::LiquidStatus& status, const QString& amount, int decimals,
                   const QString& note = {});

  private:
    QWidget* timeline(const GlassActions& actions, const TimelineWords& words);

    QSlider* time_ = nullptr;
    QLabel *time_words_ = nullptr, *readings_ = nullptr;
    QLabel* note_;  ///< over the view
    QString busy_;
};

}  // namespace pastoso::glass
