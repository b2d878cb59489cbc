// Beside the tank: what is done with it, the ball that falls, the wind, and its numbers.
#pragma once

#include "session/tank_session.hpp"

#include <vector>

#include <QWidget>

class QAction;
class QLabel;

namespace pastoso::tea {

class GlassChooser;
class NumberRow;

/// The actions that stand on its buttons and beside the timeline.
struct TankActions {
    QAction *back, *restart, *open, *ball, *drain, *wind;
    QAction *left, *right, *stronger, *weaker;
    QAction *velocity, *export_mesh, *export_all;
    QAction *render, *record_pictures, *record_surfaces;
    QAction *pause, *full_speed, *front;
};

/// What a press lets fall.
struct TankBall {
    float radius_m = 0.0F;
    float milk = 0.0F;
};

class TankPanel : public QWidget {
    Q_OBJECT
  public:
    explicit TankPanel(const TankActions& actions, QWidget* parent = nullptr);

    GlassChooser& chooser() { return *chooser_; }

    /// Shows the numbers of another tank, without a signal; the ball becomes one that suits it.
    void show_scene(const tank::TankScene& scene);
    void show_wind(const session::TankWind& wind);
    const TankBall& ball() const { return ball_; }
    /// What is written of every step by now; nothing: none is.
    void show_recorded(const QString& words);

  Q_SIGNALS:
    void numbers_changed(const pastoso::tank::TankScene& numbers);
    void wind_changed(const pastoso::session::TankWind& wind);
    void ball_changed(const pastoso::tea::TankBall& ball);

  private:
    QWidget* tank_section(const TankActions& actions);
    QWidget* ball_section(const TankActions& actions);
    QWidget* wind_section(const TankActions& actions);
    QWidget* looks_section(const TankActions& actions);
    QWidget* steps_section(const TankActions& actions);
    QWidget* numbers();

    tank::TankScene scene_;
    session::TankWind wind_;
    TankBall ball_;
    GlassChooser* chooser_ = nullptr;
    NumberRow *radius_ = nullptr, *milk_ = nullptr;
    QLabel* recorded_ = nullptr;
    NumberRow *speed_ = nullptr, *direction_ = nullptr, *drag_ = nullptr;
    std::vector<NumberRow*> shown_;
};

}  // namespace pastoso::tea
