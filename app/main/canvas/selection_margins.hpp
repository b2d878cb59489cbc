// Makes the selection wider or narrower, a band along its outline, or its edge soft, by a width that is
// asked for.
#pragma once

#include "main/studio.hpp"

#include <QObject>
#include <QPointer>

namespace pastoso::dialogs {
class MarginDialog;
struct AskedLength;
}  // namespace pastoso::dialogs

namespace pastoso::main {

class SelectionMargins : public QObject {
    Q_OBJECT
  public:
    explicit SelectionMargins(Studio& studio);

  private:
    /// `Margin` is the action.
    template <class Margin>
    void ask(const dialogs::AskedLength& asked);
    template <class Margin>
    void preview();

    Studio& studio_;
    double width_mm_ = 2.0;  ///< that was chosen last, of whichever
    QPointer<dialogs::MarginDialog> dialog_;
};

}  // namespace pastoso::main
