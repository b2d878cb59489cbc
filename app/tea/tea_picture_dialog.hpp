// A picture of the glass by the light's true ways: how large, how fine, and what becomes of it.
#pragma once

#include "layers/picture.hpp"
#include "session/tea_picture.hpp"

#include <functional>
#include <memory>

#include <QDialog>
#include <QImage>

class QComboBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace pastoso::tea {

class TeaPictureDialog : public QDialog {
    Q_OBJECT
  public:
    /// What is to be seen: without a moment there is nothing to render.
    using Subject = std::function<session::TeaPictureOrder()>;

    TeaPictureDialog(Subject subject, QWidget* parent);
    ~TeaPictureDialog() override;

    /// Writes what there is so far, toned as it is shown; an EXR file holds the light itself. Throws
    /// core::InputError.
    void save(const QString& path) const;

    bool rendering() const;
    bool has_picture() const { return !shown_.isNull(); }

  Q_SIGNALS:
    /// The picture is to become paint.
    void wanted_on_canvas(const pastoso::layers::Picture& picture);

    void rendering_begins();

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    QWidget* controls();
    QWidget* uses();
    void start_or_stop();
    void show_progress();
    void show_picture();
    void ask_save();
    void put_on_canvas();

    Subject subject_;
    QImage shown_;
    QLabel *picture_ = nullptr, *progress_ = nullptr;
    QSpinBox *width_ = nullptr, *height_ = nullptr, *samples_ = nullptr;
    QComboBox* body_ = nullptr;
    QPushButton *start_ = nullptr, *save_ = nullptr, *use_ = nullptr;
    int wanted_samples_ = 0;
    std::unique_ptr<session::TeaPicture> work_;
};

}  // namespace pastoso::tea
