// The guide that lies on the canvas: which it is, its numbers, and how strongly it draws the pen.
#pragma once

#include "tools/laid_guide.hpp"

#include <vector>

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;

namespace pastoso::panels {

class ValueRow;

class LaidGuidePart : public QWidget {
    Q_OBJECT
  public:
    explicit LaidGuidePart(QWidget* parent = nullptr);

    /// Shows the numbers that a guide of its kind has, without a signal.
    void show_guide(const brush::PenGuide& guide);

  Q_SIGNALS:
    void kind_chosen(tools::GuideKind kind);
    void guide_chosen(const brush::PenGuide& guide);  ///< with another number

  private:
    void add_kinds(QFormLayout* form);

    brush::PenGuide shown_;
    QFormLayout* form_ = nullptr;
    QComboBox* kind_ = nullptr;
    std::vector<QDoubleSpinBox*> numbers_;  ///< of guide_numbers(), in their order
    ValueRow* strength_ = nullptr;
};

}  // namespace pastoso::panels
