// A picture of a liquid by the light's true ways: how large, how fine, and what becomes of it.
#pragma once

#include "dialogs/growing_dialog.hpp"
#include "pigment/image.hpp"
#include "session/liquid_picture.hpp"

#include <functional>
#include <memory>

#include <QImage>
#include <QSize>
#include <QString>

class QComboBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace pastoso::glass {

/// What differs from liquid to liquid.
struct LiquidPictureWords {
    QString name;         ///< of the dialog
    QString title, hint;  ///< the hint stands there until there is a picture
    QString file;         ///< to be saved as
    QSize size{800, 800};
    bool has_milk_body = true;  ///< there is milk that has not dissolved
};

class LiquidPictureDialog : public dialogs::GrowingDialog {
    Q_OBJECT
  public:
    /// What is to be seen: without a scene there is nothing to render. Size, samples and body are the
    /// dialog's.
    using Subject = std::function<session::LiquidPictureOrder()>;

    LiquidPictureDialog(LiquidPictureWords words, Subject subject, QWidget* parent);
    ~LiquidPictureDialog() override;

    /// Writes what there is so far, toned as it is shown; an EXR file holds the light itself. Throws
    /// core::InputError.
    void save(const QString& path) const;

    bool rendering() const;
    bool has_picture() const { return !shown_.isNull(); }

  Q_SIGNALS:
    /// The picture is to become paint.
    void wanted_on_canvas(const pastoso::pigment::Picture& picture);

    void rendering_begins();

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    QWidget* controls();
    QWidget* milk_body();
    QWidget* uses();
    void start_or_stop();
    void show_progress();
    void show_picture();
    void ask_save();
    void put_on_canvas();

    LiquidPictureWords words_;
    Subject subject_;
    QImage shown_;
    QLabel *picture_ = nullptr, *progress_ = nullptr;
    QSpinBox *width_ = nullptr, *height_ = nullptr, *samples_ = nullptr;
    QComboBox* body_ = nullptr;  ///< none without such milk
    QPushButton *start_ = nullptr, *save_ = nullptr, *use_ = nullptr;
    int wanted_samples_ = 0;
    std::unique_ptr<session::LiquidPicture> work_;
};

}  // namespace pastoso::glass
