// Which harmony and which gamut mask the colour wheel shows.
#pragma once

#include "panels/parts/fold.hpp"
#include "tools/colour_aids.hpp"

class QComboBox;
class QSpinBox;

namespace pastoso::panels {

class AidsPart : public Fold {
    Q_OBJECT
  public:
    explicit AidsPart(QWidget* parent = nullptr);

    const tools::ColourAids& aids() const { return aids_; }

    /// Without a signal; unfolded where there is something to see.
    void show_aids(const tools::ColourAids& aids);

  Q_SIGNALS:
    void changed(const tools::ColourAids& aids);

  private:
    void take();

    tools::ColourAids aids_;
    QComboBox* harmony_ = nullptr;
    QComboBox* shape_ = nullptr;
    QSpinBox* turn_ = nullptr;
};

}  // namespace pastoso::panels
