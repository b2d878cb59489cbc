// Asks for a texture to lay; shows a piece of it, lit from the side.
#pragma once

#include "dialogs/growing_dialog.hpp"
#include "dialogs/stencil_reader.hpp"
#include "layers/texture/texture.hpp"

#include <QImage>
#include <QString>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace pastoso::dialogs {

/// What is chosen of each form, and which form it is. The picture is yet to be read; it is to lie in the
/// middle of its place, as large as it fits.
struct ChosenTexture {
    enum class Form { Sand, Knifed, Pressed };
    Form form = Form::Sand;
    layers::SandTexture sand{};
    layers::KnifedTexture knifed{};
    layers::PressedTexture pressed{};
    QString picture{};  ///< its path
};

class TextureDialog : public GrowingDialog {
    Q_OBJECT
  public:
    /// `proposal` stands there first; `picture_filter` is of the file dialog.
    TextureDialog(const ChosenTexture& proposal, const QString& picture_filter,
                  QWidget* parent = nullptr);

    const ChosenTexture& chosen() const { return chosen_; }

    void choose_picture(const QString& path);

  private:
    QDoubleSpinBox* add_length(const QString& name, const QString& words, double least_mm,
                               double most_mm, double value_mm);
    void add_direction();
    void add_picture();
    void ask_picture();
    void read();
    void take_others();  ///< of the seed
    void show_form();
    void show_piece();
    QImage piece() const;
    QImage pressed_piece() const;

    ChosenTexture chosen_;
    QString picture_filter_;
    QFormLayout* form_ = nullptr;
    QComboBox* forms_ = nullptr;
    QDoubleSpinBox *grain_ = nullptr, *height_ = nullptr, *spacing_ = nullptr, *direction_ = nullptr;
    QDoubleSpinBox* relief_ = nullptr;
    QPushButton *picture_ = nullptr, *others_ = nullptr;
    QCheckBox* dark_ = nullptr;
    QLabel* piece_ = nullptr;
    QDialogButtonBox* buttons_ = nullptr;
    QString wanted_;                  ///< path of the picture that was asked for last
    StencilReader::Picture stencil_;  ///< of it, small; null until it is there
    StencilReader reader_;
};

}  // namespace pastoso::dialogs
