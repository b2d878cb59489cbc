#include "glass/tank_panel.hpp"

#include "glass/glass_chooser.hpp"
#include "panels/parts/feel_row.hpp"
#include "panels/parts/fold.hpp"
#include "panels/parts/section.hpp"
#include "panels/parts/value_row.hpp"
#include "tools/feel.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QAction>
#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace pastoso::glass {
namespace {

using S = tank::TankScene;

struct TankRow {
    double S::*value;
    NumberWords shown;
};

constexpr TankRow kRows[] = {
    {&S::gravity_m_s2, QT_TR_NOOP("Gravity"), QT_TR_NOOP("How fast what falls gets faster"),
     QT_TR_NOOP(" m/s\u00b2"), 1.0, 2, 0.0, 20.0},
    {&S::viscosity_m2_s, QT_TR_NOOP("Viscosity"),
     QT_TR_NOOP("Kinematic viscosity: water 1, oil 80, honey 5000"), QT_TR_NOOP(" mm\u00b2/s"), 1e6, 1,
     0.1, 20000.0, true},
    {&S::confinement, QT_TR_NOOP("Whirls kept"), QT_TR_NOOP("Force that keeps small whirls alive"), "",
     1.0, 2, 0.0, 0.3},
    {&S::flip_share, QT_TR_NOOP("Lively"),
     QT_TR_NOOP("What of its own velocity a drop keeps from step to step: less is calmer"),
     QT_TR_NOOP(" %"), 100.0, 1, 0.0, 100.0},
    {&S::volume_rate, QT_TR_NOOP("Volume mended"),
     QT_TR_NOOP("How much of a wrong density a step mends"), QT_TR_NOOP(" %"), 100.0, 0, 0.0, 100.0},
    {&S::courant, QT_TR_NOOP("Way of a step"),
     QT_TR_NOOP(
         "The longest way of a step, against the finest detail of the liquid: longer is faster and "
         "coarser"),
     "", 1.0, 2, 0.1, 1.0},
    {&S::tolerance, QT_TR_NOOP("Pressure within"), QT_TR_NOOP("How exact the pressure is solved"), "",
     1.0, 6, 1e-5, 1e-2, true},
};

// From water to honey; and from a liquid that loses its swirls at once to one that keeps all of them.
constexpr std::pair<tools::FeelNumber<S>, FeelWords> kFeels[] = {
    {{&S::viscosity_m2_s, 1e-6, 5e-3, tools::FeelScale::Logarithmic},
     {"thin_to_thick", QT_TR_NOOP("thin as water"), QT_TR_NOOP("thick as honey"),
      QT_TR_NOOP("Its viscosity")}},
    {{&S::flip_share, 0.0, 1.0, tools::FeelScale::Linear},
     {"calm_to_lively", QT_TR_NOOP("calm"), QT_TR_NOOP("lively"),
      QT_TR_NOOP("How much of its own movement each drop keeps")}}};

constexpr double kBallShare = 0.11;  ///< of the shortest side: the radius of a usual ball

const tank::TankNumber& number_of(const TankRow& row) {
    const auto numbers = tank::tank_numbers();
    return *std::find_if(numbers.begin(), numbers.end(),
                         [&](const tank::TankNumber& number) { return number.value == row.value; });
}

}  // namespace

TankPanel::TankPanel(const TankActions& actions, QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("tank_panel"));
    QVBoxLayout* column = column_of(this);
    Fold* fold = new_numbers_fold();
    add_tank(column, actions);
    add_balls(column, actions);
    add_wind(column, fold->column(), actions);
    add_feels(column);
    add_looks(column, actions);
    add_steps(column, actions);
    add_numbers(fold->column());
    column->addWidget(fold);
    column->addStretch(1);
    show_scene({});
    show_wind({});
}

void TankPanel::add_tank(QVBoxLayout* column, const TankActions& actions) {
    chooser_ = new GlassChooser;
    QVBoxLayout* section = glass_section_under(column, tr("Tank"), actions.glass.back, chooser_);
    section->addWidget(panels::button_row({actions.restart, actions.open}));
}

void TankPanel::add_balls(QVBoxLayout* column, const TankActions& actions) {
    QVBoxLayout* section = section_under(column, tr("Balls and drain"));
    section->addWidget(panels::button_row({actions.ball, actions.drain}));
    QGridLayout* grid = rows_under(section);
    radius_ = new ValueRow(grid, QStringLiteral("ball_radius"), tr("Ball's radius"),
                           tr("How large the ball is that falls where you press"),
                           {0.1, 1e4, 1, tr(" mm"), true, {{5.0, 100.0}}});
    milk_ = new ValueRow(grid, QStringLiteral("ball_milk"), tr("Milk in it"),
                         tr("How much of the ball is milk"), {0.0, 100.0, 0, tr(" %")});
    connect(radius_, &ValueRow::chosen, this, [this](double value) {
        ball_.radius_m = static_cast<float>(1e-3 * value);
        Q_EMIT ball_changed(ball_);
    });
    connect(milk_, &ValueRow::chosen, this, [this](double value) {
        ball_.milk = static_cast<float>(1e-2 * value);
        Q_EMIT ball_changed(ball_);
    });
}

void TankPanel::add_wind(QVBoxLayout* column, QVBoxLayout* numbers, const TankActions& actions) {
    QVBoxLayout* section = section_under(column, tr("Wind"));
    section->addWidget(panels::button_row({actions.wind}));
    section->addWidget(
        panels::icon_row({actions.left, actions.right, actions.stronger, actions.weaker}));
    QGridLayout* grid = rows_under(section);
    speed_ = new ValueRow(grid, QStringLiteral("wind_speed"), tr("Speed"), tr("How fast the air goes"),
                          {0.0, tank::kMostSpeed_m_s, 1, tr(" m/s"), false, {{0.0, 20.0}}});
    direction_ = new ValueRow(grid, QStringLiteral("wind_direction"), tr("Blows to"),
                              tr("0 to the right along the front, 90 away from it"),
                              {-360.0, 360.0, 0, tr("°"), false, {{-180.0, 180.0}}});
    drag_ = new ValueRow(rows_under(numbers), QStringLiteral("wind_drag"), tr("Drags"),
                         tr("How firmly it takes the liquid's surface along"),
                         {0.0, 1e4, 1, tr(" /s"), false, {{0.0, 50.0}}});
    const auto take = [this](ValueRow* row, double session::TankWind::*number) {
        connect(row, &ValueRow::chosen, this, [this, number](double value) {
            wind_.*number = value;
            Q_EMIT wind_changed(wind_);
        });
    };
    take(speed_, &session::TankWind::speed_m_s);
    take(direction_, &session::TankWind::direction_deg);
    take(drag_, &session::TankWind::drag_per_s);
}

void TankPanel::add_looks(QVBoxLayout* column, const TankActions& actions) {
    QVBoxLayout* section = section_under(column, tr("Look and export"));
    section->addWidget(panels::button_row({actions.velocity}));
    section->addWidget(panels::button_row({actions.render}));
    section->addWidget(panels::button_row({actions.export_mesh}));
    section->addWidget(panels::button_row({actions.export_all}));
}

void TankPanel::add_steps(QVBoxLayout* column, const TankActions& actions) {
    QVBoxLayout* section = section_under(column, tr("Every step into a folder"));
    section->addWidget(panels::button_row({actions.record_pictures, actions.record_surfaces}));
    recorded_ = new QLabel;
    recorded_->setObjectName(QStringLiteral("reading"));
    recorded_->hide();
    section->addWidget(recorded_);
}

void TankPanel::show_recorded(const QString& words) {
    recorded_->setText(words);
    recorded_->setVisible(!words.isEmpty());
}

void TankPanel::add_feels(QVBoxLayout* column) {
    QGridLayout* grid = rows_under(section_under(column, tr("Liquid")));
    for (const auto& [number, words] : kFeels) {
        FeelRow* row = add_feel(grid, words);
        connect(row, &FeelRow::chosen, this, [this, &number](double place) {
            change(tools::feel_moved(scene_, std::span(&number, 1), place));
        });
        feels_.push_back(row);
    }
}

void TankPanel::add_numbers(QVBoxLayout* column) {
    QGridLayout* grid = rows_under(column);
    for (const TankRow& row : kRows) {
        const tank::TankNumber& number = number_of(row);
        ValueRow* shown = add_number(grid, row.shown, number.key, number.least, number.most);
        connect(shown, &ValueRow::chosen, this, [this, &row](double value) {
            tank::TankScene scene = scene_;
            scene.*row.value = value / row.shown.scale;
            change(scene);
        });
        shown_.push_back(shown);
    }
}

void TankPanel::change(const tank::TankScene& scene) {
    show_numbers(scene);
    Q_EMIT numbers_changed(scene_);
}

void TankPanel::show_numbers(const tank::TankScene& scene) {
    scene_ = scene;
    for (std::size_t i = 0; i < feels_.size(); ++i)
        feels_[i]->show_place(tools::feel_place(scene, {&kFeels[i].first, 1}));
    for (std::size_t i = 0; i < shown_.size(); ++i)
        shown_[i]->show_value(kRows[i].shown.scale * scene.*kRows[i].value);
}

void TankPanel::show_scene(const tank::TankScene& scene) {
    const bool other_size = scene.size_m() != scene_.size_m() || ball_.radius_m <= 0.0F;
    show_numbers(scene);
    if (other_size) {
        const glm::vec3 size_m = scene.size_m();
        ball_.radius_m = static_cast<float>(kBallShare) * std::min({size_m.x, size_m.y, size_m.z});
        Q_EMIT ball_changed(ball_);
    }
    radius_->show_value(1e3 * static_cast<double>(ball_.radius_m));
    milk_->show_value(1e2 * static_cast<double>(ball_.milk));
}

void TankPanel::show_wind(const session::TankWind& wind) {
    wind_ = wind;
    speed_->show_value(wind.speed_m_s);
    direction_->show_value(wind.direction_deg);
    drag_->show_value(wind.drag_per_s);
}

}  // namespace pastoso::glass
