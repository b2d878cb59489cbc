// Chooses a colour on a wheel, by red, green and blue, by hue, saturation and value, or by Oklch.
#pragma once

#include "tools/colour_aids.hpp"

#include <array>

#include <QWidget>

class QButtonGroup;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;

namespace pastoso::panels {

class AidsPart;
class ChannelSlider;
class ColourWheel;

class ColourPicker : public QWidget {
    Q_OBJECT
  public:
    /// `nearest` stands between the wheel and the numbers.
    explicit ColourPicker(QWidget* nearest, QWidget* parent = nullptr);

    const pigment::Srgb8& colour() const { return colour_; }

    /// Without a signal.
    void show_colour(const pigment::Srgb8& colour);

    const tools::ColourAids& aids() const;
    void show_aids(const tools::ColourAids& aids);

  Q_SIGNALS:
    void looked_at(const pigment::Srgb8& colour);  ///< while a slider is being dragged, too
    void chosen(const pigment::Srgb8& colour);     ///< once it is let go
    void refused(const QString& sentence);         ///< what was typed is no colour
    void aids_changed();

  private:
    struct Row {
        QLabel* letter = nullptr;
        ChannelSlider* slider = nullptr;
        QDoubleSpinBox* number = nullptr;
    };

    QWidget* models_row();
    QWidget* channel_rows();
    void use_model(tools::ColourModel model);
    void set_channel(int channel, double value);
    void take_wheel(const tools::Channels& oklch);
    void take_typed_colour();
    void write_rows();
    void show_on_wheel();
    void paint_ramps();

    tools::ColourModel model_ = tools::ColourModel::Oklch;
    tools::Channels channels_{};
    pigment::Srgb8 colour_{};
    ColourWheel* wheel_ = nullptr;
    AidsPart* aids_ = nullptr;
    QButtonGroup* models_ = nullptr;
    std::array<Row, 3> rows_;
    QLineEdit* hex_ = nullptr;
};

}  // namespace pastoso::panels
