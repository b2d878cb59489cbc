// Beside the tank: what is done with it, the ball that falls, the wind, the liquid in words, and all
// numbers below.
#pragma once

#include "glass/panel_parts.hpp"
#include "session/tank_session.hpp"

#include <vector>

#include <QWidget>

class QLabel;

namespace pastoso::glass {

/// The actions that stand on its buttons and beside the timeline.
struct TankActions {
    GlassActions glass;
    QAction *restart, *open, *ball, *drain, *wind;
    QAction *left, *right, *stronger, *weaker;
    QAction *velocity, *export_mesh, *export_all;
    QAction *render, *record_pictures, *record_surfaces;
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
    void ball_changed(const pastoso::glass::TankBall& ball);

  private:
    void add_tank(QVBoxLayout* column, const TankActions& actions);
    void add_balls(QVBoxLayout* column, const TankActions& actions);
    void add_wind(QVBoxLayout* column, QVBoxLayout* numbers, const TankActions& actions);
    void add_looks(QVBoxLayout* column, const TankActions& actions);
    void add_steps(QVBoxLayout* column, const TankActions& actions);
    void add_feels(QVBoxLayout* column);
    void add_numbers(QVBoxLayout* column);
    void change(const tank::TankScene& scene);
    void show_numbers(const tank::TankScene& scene);

    tank::TankScene scene_;
    session::TankWind wind_;
    TankBall ball_;
    GlassChooser* chooser_ = nullptr;
    ValueRow *radius_ = nullptr, *milk_ = nullptr;
    QLabel* recorded_ = nullptr;
    ValueRow *speed_ = nullptr, *direction_ = nullptr, *drag_ = nullptr;
    std::vector<FeelRow*> feels_;
    std::vector<ValueRow*> shown_;
};

}  // namespace pastoso::glass
