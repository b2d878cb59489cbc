// Selecting by the height and the wetness of the paint.
#pragma once

#include "main/studio.hpp"

#include <QObject>
#include <QPointer>

namespace pastoso::dialogs {
class SelectRangeDialog;
}

namespace pastoso::main {

class RangeSelection : public QObject {
    Q_OBJECT
  public:
    explicit RangeSelection(Studio& studio);

  private:
    void ask(bool wetness);
    void preview(bool wetness);

    Studio& studio_;
    QPointer<dialogs::SelectRangeDialog> dialog_;
};

}  // namespace pastoso::main
