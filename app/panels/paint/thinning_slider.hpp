// Paint : medium on one slider, from paste to stain.
#pragma once

#include "tools/hand.hpp"

#include <QTimer>
#include <QWidget>

class QLabel;
class QSlider;

namespace pastoso::panels {

class ThinningSlider : public QWidget {
    Q_OBJECT
  public:
    /// The words stand beside the slider, or above it where it lies `Qt::Vertical`.
    explicit ThinningSlider(Qt::Orientation direction, QWidget* parent = nullptr);

    /// In a bar that stands upright: the slider, too, with the medium above, and its words below it, in
    /// two lines. Back again for one that lies.
    void set_upright(bool upright);

    /// Shows how the medium in hand is thinned, without a signal; disabled where nothing thins it. A
    /// slider that moves is let go only for another medium.
    void show_hand(const tools::Hand& hand);

    QSlider* slider() const { return slider_; }

    /// Says at once what was set a moment ago.
    void finish();

  Q_SIGNALS:
    void share_chosen(double share);  ///< of paint; the slider rests: paint is poured only then

  private:
    void show_share(double share);
    void show_hint();

    document::UseMedium in_hand_;
    film::Medium unthinned_;
    double share_ = 1.0;  ///< as shown
    QTimer resting_;
    QSlider* slider_ = nullptr;
    QLabel* words_ = nullptr;
};

}  // namespace pastoso::panels
