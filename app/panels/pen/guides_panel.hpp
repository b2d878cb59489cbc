// Mirrors, copies and the guide on the canvas in numbers, for those who want them exact or work by keys
// alone.
#pragma once

#include "tools/hand.hpp"
#include "tools/laid_guide.hpp"

#include <QWidget>

class QAction;
class QDoubleSpinBox;

namespace pastoso::panels {

class LaidGuidePart;

struct GuideActions {
    QAction *upright, *level, *snap, *handles, *remove;
};

class GuidesPanel : public QWidget {
    Q_OBJECT
  public:
    explicit GuidesPanel(const GuideActions& actions, QWidget* parent = nullptr);

    /// Shows the guides, without a signal.
    void show_hand(const tools::Hand& hand);

  Q_SIGNALS:
    void symmetry_chosen(const brush::Symmetry& symmetry);
    void kind_chosen(tools::GuideKind kind);
    void guide_chosen(const brush::PenGuide& guide);

  private:
    QWidget* symmetry_part(const GuideActions& actions);
    brush::Symmetry symmetry() const;

    tools::Hand shown_;
    QDoubleSpinBox *copies_ = nullptr, *centre_x_ = nullptr, *centre_y_ = nullptr, *axis_ = nullptr;
    LaidGuidePart* laid_ = nullptr;
};

}  // namespace pastoso::panels
