// Another colour for the dry paint of the layer that is painted on.
#pragma once

#include "dialogs/adjust_dialog.hpp"
#include "main/studio.hpp"

#include <QObject>

namespace pastoso::main {

class DryAdjusting : public QObject {
    Q_OBJECT
  public:
    explicit DryAdjusting(Studio& studio);

  private:
    void ask();
    void adjust(const dialogs::ChosenAdjustment& chosen);
    bool is_lent();  ///< and says so

    Studio& studio_;
    dialogs::ChosenAdjustment chosen_;
};

}  // namespace pastoso::main
