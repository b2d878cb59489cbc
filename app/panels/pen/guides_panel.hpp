// Mirrors, copies, ruler and ellipse in numbers, for those who want them exact or work by keys alone.
#pragma once

#include "tools/hand.hpp"

#include <vector>

#include <QWidget>

class QAction;
class QDoubleSpinBox;
class QFormLayout;

namespace pastoso::panels {

struct GuideActions {
    QAction *upright, *level, *ruler, *ellipse, *handles, *remove;
};

class GuidesPanel : public QWidget {
    Q_OBJECT
  public:
    explicit GuidesPanel(const GuideActions& actions, QWidget* parent = nullptr);

    /// Shows the guides, without a signal.
    void show_hand(const tools::Hand& hand);

  Q_SIGNALS:
    void symmetry_chosen(const brush::Symmetry& symmetry);
    void ruler_chosen(const brush::Ruler& ruler);
    void ellipse_chosen(const brush::EllipseCurve& ellipse);

  private:
    QDoubleSpinBox* add_number(QFormLayout* form, const QString& name, const QString& words,
                               double least, double most, const QString& unit);
    QWidget* symmetry_part(const GuideActions& actions);
    QWidget* ruler_part(const GuideActions& actions);
    QWidget* ellipse_part(const GuideActions& actions);
    brush::Symmetry symmetry() const;
    brush::Ruler ruler() const;
    brush::EllipseCurve ellipse() const;

    tools::Hand shown_;
    QDoubleSpinBox *copies_ = nullptr, *centre_x_ = nullptr, *centre_y_ = nullptr, *axis_ = nullptr;
    QDoubleSpinBox *ruler_x_ = nullptr, *ruler_y_ = nullptr, *ruler_angle_ = nullptr;
    QDoubleSpinBox *ellipse_x_ = nullptr, *ellipse_y_ = nullptr, *ellipse_width_ = nullptr,
                   *ellipse_height_ = nullptr, *ellipse_turn_ = nullptr;
};

}  // namespace pastoso::panels
