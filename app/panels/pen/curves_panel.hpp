// How the tool in hand answers to the hand, to its way, its load and chance: its curves, one at a time,
// which are bent, added and removed.
#pragma once

#include "brush/preset.hpp"

#include <QWidget>

class QComboBox;
class QLabel;
class QMenu;
class QToolButton;

namespace pastoso::panels {

class CurveEditor;

class CurvesPanel : public QWidget {
    Q_OBJECT
  public:
    explicit CurvesPanel(QWidget* parent = nullptr);

    /// Shows the curves of the tool in hand, without a signal; `kept` is the preset as it is kept, which
    /// reset returns to.
    void show_preset(const brush::Preset& in_hand, const brush::Preset& kept);

  Q_SIGNALS:
    void edited(const brush::Preset& preset);

  private:
    void list_curves(int chosen);
    void list_addable();
    void add(brush::DynamicsInput input, brush::DynamicsTarget target);
    void remove_current();
    void show_current();
    void read_at(double input);
    void reset_current();
    const brush::DynamicsCurve* kept_curve() const;
    void emit_points(const std::vector<brush::CurvePoint>& points);

    brush::Preset preset_, kept_;
    QComboBox* which_ = nullptr;
    CurveEditor* editor_ = nullptr;
    QLabel* reading_ = nullptr;
    QMenu* addable_ = nullptr;
    QToolButton *add_ = nullptr, *remove_ = nullptr, *reset_ = nullptr;
};

}  // namespace pastoso::panels
