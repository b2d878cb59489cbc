#include "glass/liquid_picture_dialog.hpp"

#include "appearance/picture_view.hpp"
#include "appearance/screen_colours.hpp"
#include "appearance/shown_message.hpp"
#include "appearance/shown_number.hpp"
#include "core/error.hpp"
#include "core/fault.hpp"
#include "liquid_files/traced_picture.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

namespace pastoso::glass {
namespace {

constexpr int kSmallest_px = 16, kLargest_px = 8192;
constexpr int kMostSamples = 4096, kFirstSamples = 48;
/// From so many on a picture whose noise was taken out hardly changes any more: 200 x 200 pixels of the
/// usual glass at 1.8 s differ from those of 512 samples by 6.2 % of white (RMS) at 2 samples, 2.9 at 8,
/// 2.4 at 16, 2.0 at 32 and 1.8 at 48.
constexpr int kSamplesWithoutNoise = 16;

QSpinBox* number(const char* name, int least, int most, int value, const QString& hint) {
    auto* box = new QSpinBox;
    box->setObjectName(QString::fromLatin1(name));
    box->setRange(least, most);
    box->setValue(value);
    box->setToolTip(hint);
    return box;
}

}  // namespace

LiquidPictureDialog::LiquidPictureDialog(LiquidPictureWords words, Subject subject, QWidget* parent)
    : dialogs::GrowingDialog(parent), words_(std::move(words)), subject_(std::move(subject)) {
    setObjectName(words_.name);
    setWindowTitle(words_.title);
    picture_ = new QLabel(words_.hint);
    picture_->setAlignment(Qt::AlignCenter);
    picture_->setWordWrap(true);
    picture_->setMinimumSize(420, 420);
    picture_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
    auto* side = new QVBoxLayout;
    side->setSpacing(12);
    side->addWidget(controls());
    side->addStretch(1);
    side->addWidget(uses());
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(16, 16, 16, 14);
    row->setSpacing(16);
    row->addWidget(picture_, 1);
    row->addLayout(side);
    resize(820, 560);
    connect(&appearance::screen_colours(), &appearance::ScreenColours::changed, this,
            &LiquidPictureDialog::show_picture);
    show_progress();
}

LiquidPictureDialog::~LiquidPictureDialog() = default;

QWidget* LiquidPictureDialog::controls() {
    auto* widget = new QWidget;
    auto* form = new QFormLayout(widget);
    form->setContentsMargins(0, 0, 0, 0);
    width_ = number("picture_width", kSmallest_px, kLargest_px, words_.size.width(),
                    tr("Pixels from left to right"));
    height_ = number("picture_height", kSmallest_px, kLargest_px, words_.size.height(),
                     tr("Pixels from top to bottom"));
    samples_ = number("picture_samples", 1, kMostSamples, kFirstSamples,
                      tr("Ways of light for each pixel: four times as many, half the noise"));
    form->addRow(tr("Width"), width_);
    form->addRow(tr("Height"), height_);
    form->addRow(tr("Samples"), samples_);
    if (words_.has_milk_body) form->addRow(tr("Milk"), milk_body());
    start_ = new QPushButton;
    start_->setObjectName(QStringLiteral("picture_start"));
    start_->setDefault(true);
    connect(start_, &QPushButton::clicked, this, &LiquidPictureDialog::start_or_stop);
    progress_ = new QLabel;
    progress_->setObjectName(QStringLiteral("picture_progress"));
    progress_->setWordWrap(true);
    progress_->setFixedWidth(220);
    form->addRow(start_);
    form->addRow(progress_);
    return widget;
}

QWidget* LiquidPictureDialog::milk_body() {
    body_ = new QComboBox;
    body_->setObjectName(QStringLiteral("picture_body"));
    body_->addItem(tr("As a cloud"), static_cast<int>(trace::MilkBody::Medium));
    body_->addItem(tr("As a surface"), static_cast<int>(trace::MilkBody::Surface));
    body_->setToolTip(tr("How milk that has not dissolved is seen: a cloud is softer and takes longer"));
    return body_;
}

QWidget* LiquidPictureDialog::uses() {
    auto* widget = new QWidget;
    auto* column = new QVBoxLayout(widget);
    column->setContentsMargins(0, 0, 0, 0);
    use_ = new QPushButton(tr("Use on the canvas"));
    use_->setObjectName(QStringLiteral("picture_use"));
    use_->setToolTip(tr("Puts the picture onto the painting as a layer of dry paint, and goes there"));
    save_ = new QPushButton(tr("Save..."));
    save_->setObjectName(QStringLiteral("picture_save"));
    save_->setToolTip(tr("As PNG and others as it is shown, or as EXR with the light itself"));
    auto* close = new QPushButton(tr("Close"));
    connect(use_, &QPushButton::clicked, this, &LiquidPictureDialog::put_on_canvas);
    connect(save_, &QPushButton::clicked, this, &LiquidPictureDialog::ask_save);
    connect(close, &QPushButton::clicked, this, &QDialog::hide);
    for (QPushButton* button : {use_, save_, close}) {
        button->setAutoDefault(false);
        column->addWidget(button);
    }
    return widget;
}

bool LiquidPictureDialog::rendering() const {
    return work_ != nullptr && !work_->progress().finished;
}

void LiquidPictureDialog::start_or_stop() {
    if (rendering()) {
        work_->stop();
        return progress_->setText(tr("Taking the noise out..."));
    }
    session::LiquidPictureOrder order = subject_();
    if (!order.scene) return;
    order.width = width_->value();
    order.height = height_->value();
    order.samples = wanted_samples_ = samples_->value();
    if (body_ != nullptr) order.body = static_cast<trace::MilkBody>(body_->currentData().toInt());
    Q_EMIT rendering_begins();
    work_.reset();
    work_ = std::make_unique<session::LiquidPicture>(std::move(order), [this] {
        QMetaObject::invokeMethod(this, &LiquidPictureDialog::show_progress, Qt::QueuedConnection);
    });
    show_progress();
}

void LiquidPictureDialog::show_progress() {
    const bool busy = rendering();
    start_->setText(busy ? tr("Stop") : tr("Render"));
    start_->setToolTip(busy ? tr("Keep the picture as fine as it is by now") : QString());
    if (work_ != nullptr) {
        const session::LiquidPicture::Progress progress = work_->progress();
        if (!progress.error.empty())
            progress_->setText(appearance::shown_message(progress.error));
        else if (progress.finished)
            progress_->setText(
                (progress.samples >= kSamplesWithoutNoise
                     ? tr("%n sample(s) in %1 s, without noise", nullptr, progress.samples)
                     : tr("%n sample(s) in %1 s: too few to take all noise out", nullptr,
                          progress.samples))
                    .arg(appearance::shown_number(progress.seconds, 1)));
        else if (progress.samples == 0)
            progress_->setText(tr("Finding the surface..."));
        else
            progress_->setText(tr("%1 of %n sample(s)", nullptr, wanted_samples_).arg(progress.samples));
        if (const auto shown = work_->shown()) {
            shown_ = appearance::view_of(*shown).copy();
            show_picture();
        }
    }
    for (QPushButton* button : {save_, use_})
        button->setEnabled(has_picture());
}

void LiquidPictureDialog::show_picture() {
    if (shown_.isNull()) return;
    const double ratio = devicePixelRatioF();
    QPixmap pixmap = QPixmap::fromImage(appearance::shown(
        shown_.scaled(picture_->size() * ratio, Qt::KeepAspectRatio, Qt::SmoothTransformation)));
    pixmap.setDevicePixelRatio(ratio);
    picture_->setPixmap(pixmap);
}

void LiquidPictureDialog::resizeEvent(QResizeEvent* event) {
    QDialog::resizeEvent(event);
    show_picture();
}

void LiquidPictureDialog::save(const QString& path) const {
    const auto radiance = work_ != nullptr ? work_->radiance() : nullptr;
    if (radiance == nullptr) throw core::InputError("There is no picture yet that could be saved.");
    liquid_files::write_traced_picture(path.toStdString(), *radiance);
}

void LiquidPictureDialog::ask_save() {
    const QString path = QFileDialog::getSaveFileName(
        this, tr("Save the picture"), words_.file,
        tr("Pictures (%1)").arg(QStringLiteral("*.png *.exr *.tif *.tiff *.jpg *.jpeg *.webp")));
    if (path.isEmpty()) return;
    const core::Message fault = core::fault_of([&] { save(path); });
    if (!fault.empty())
        QMessageBox::warning(this, tr("Save the picture"), appearance::shown_message(fault));
}

void LiquidPictureDialog::put_on_canvas() {
    const QImage rgba = shown_.convertToFormat(QImage::Format_RGBA8888);
    pigment::Picture picture{rgba.width(), rgba.height(), {}};
    for (int y = 0; y < rgba.height(); ++y)
        picture.rgba.insert(picture.rgba.end(), rgba.constScanLine(y),
                            rgba.constScanLine(y) + 4 * std::ptrdiff_t{rgba.width()});
    hide();
    Q_EMIT wanted_on_canvas(picture);
}

}  // namespace pastoso::glass
