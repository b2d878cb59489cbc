#include "panels/colour/colour_picker.hpp"

#include "panels/colour/aids_part.hpp"
#include "panels/colour/channel_slider.hpp"
#include "panels/colour/colour_wheel.hpp"
#include "panels/parts/section.hpp"

#include <cmath>

#include <QButtonGroup>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

using tools::ColourModel;

constexpr int kSliderSteps = 360;
constexpr int kRampColours = 25;

QColor qcolor(const pigment::Srgb8& rgb) {
    return {rgb[0], rgb[1], rgb[2]};
}

}  // namespace

ColourPicker::ColourPicker(QWidget* nearest, QWidget* parent)
    : QWidget(parent), wheel_(new ColourWheel), aids_(new AidsPart), models_(new QButtonGroup(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(wheel_);
    column->addWidget(nearest);
    column->addWidget(models_row());
    column->addWidget(channel_rows());
    column->addWidget(aids_);
    connect(aids_, &AidsPart::changed, this, [this](const tools::ColourAids& aids) {
        wheel_->show_aids(aids);
        Q_EMIT aids_changed();
    });
    connect(wheel_, &ColourWheel::mask_moved, this, [this](const tools::GamutMask& mask) {
        tools::ColourAids aids = aids_->aids();
        aids.mask = mask;
        aids_->show_aids(aids);
        Q_EMIT aids_changed();
    });
    connect(wheel_, &ColourWheel::moved, this, &ColourPicker::take_wheel);
    connect(wheel_, &ColourWheel::released, this, [this] { Q_EMIT chosen(colour_); });
    use_model(model_);
}

QWidget* ColourPicker::models_row() {
    auto* widget = new QWidget;
    auto* row = new QHBoxLayout(widget);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    const auto add = [&](ColourModel model, const QString& words, const QString& hint) {
        auto* button = new QToolButton;
        button->setText(words);
        button->setObjectName(QStringLiteral("model_") + words.toLower());
        button->setToolTip(hint);
        button->setCheckable(true);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        keep_keys_for_canvas(button);
        models_->addButton(button, static_cast<int>(model));
        row->addWidget(button);
    };
    add(ColourModel::Oklch, tr("OKLCh"), tr("Lightness, chroma and hue as the eye sees them"));
    add(ColourModel::Hsv, tr("HSV"), tr("Hue, saturation and value"));
    add(ColourModel::Rgb, tr("RGB"), tr("Red, green and blue of the screen"));
    connect(models_, &QButtonGroup::idClicked, this,
            [this](int id) { use_model(static_cast<ColourModel>(id)); });
    return widget;
}

QWidget* ColourPicker::channel_rows() {
    auto* widget = new QWidget;
    auto* grid = new QGridLayout(widget);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(1, 1);
    for (int i = 0; i < 3; ++i) {
        Row& row = rows_[static_cast<std::size_t>(i)];
        row = {new QLabel, new ChannelSlider, new QDoubleSpinBox};
        row.letter->setObjectName(QStringLiteral("reading"));
        row.slider->setObjectName(QStringLiteral("channel_slider_%1").arg(i));
        row.slider->setRange(0, kSliderSteps);
        row.number->setObjectName(QStringLiteral("channel_%1").arg(i));
        row.number->setButtonSymbols(QAbstractSpinBox::NoButtons);
        row.number->setAlignment(Qt::AlignRight);
        row.number->setKeyboardTracking(false);
        grid->addWidget(row.letter, i, 0);
        grid->addWidget(row.slider, i, 1);
        grid->addWidget(row.number, i, 2);
        connect(row.slider, &QSlider::valueChanged, this, [this, i](int step) {
            const double most = tools::channels_of(model_)[static_cast<std::size_t>(i)].most;
            set_channel(i, most * step / kSliderSteps);
        });
        connect(row.slider, &QSlider::sliderReleased, this, [this] { Q_EMIT chosen(colour_); });
        connect(row.number, &QDoubleSpinBox::valueChanged, this,
                [this, i](double value) { set_channel(i, value); });
    }
    hex_ = new QLineEdit;
    hex_->setObjectName(QStringLiteral("hex"));
    hex_->setToolTip(tr("The colour as it is written, for example #c03020"));
    hex_->setAccessibleName(tr("Colour as written"));
    connect(hex_, &QLineEdit::editingFinished, this, &ColourPicker::take_typed_colour);
    grid->addWidget(hex_, 3, 1, 1, 2);
    return widget;
}

void ColourPicker::use_model(ColourModel model) {
    model_ = model;
    channels_ = tools::channels_from(model, colour_);
    models_->button(static_cast<int>(model))->setChecked(true);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const tools::ChannelText& text = tools::channels_of(model)[i];
        const QSignalBlocker quiet(rows_[i].number);
        const QString name = QCoreApplication::translate("pastoso::tools", text.name);
        rows_[i].letter->setText(QString::fromLatin1(text.letter));
        rows_[i].letter->setToolTip(name);
        rows_[i].slider->setToolTip(name);
        rows_[i].slider->setAccessibleName(name);
        rows_[i].number->setAccessibleName(name);
        rows_[i].number->setToolTip(name);
        rows_[i].number->setDecimals(text.decimals);
        rows_[i].number->setRange(0.0, text.most);
        rows_[i].number->setSingleStep(text.most > 1.0 ? 1.0 : 0.005);
    }
    write_rows();
}

void ColourPicker::set_channel(int channel, double value) {
    channels_[static_cast<std::size_t>(channel)] = value;
    colour_ = tools::colour_from(model_, channels_);
    write_rows();
    Q_EMIT looked_at(colour_);
    if (!rows_[static_cast<std::size_t>(channel)].slider->isSliderDown()) Q_EMIT chosen(colour_);
}

/// By keys it is chosen at once, by mouse when it is let go.
void ColourPicker::take_wheel(const tools::Channels& oklch) {
    colour_ = tools::colour_from(ColourModel::Oklch, oklch);
    channels_ = model_ == ColourModel::Oklch ? oklch : tools::channels_from(model_, colour_);
    write_rows();
    Q_EMIT looked_at(colour_);
    if (!wheel_->dragging()) Q_EMIT chosen(colour_);
}

void ColourPicker::show_colour(const pigment::Srgb8& colour) {
    if (colour == colour_) return;
    colour_ = colour;
    channels_ = tools::channels_from(model_, colour);
    write_rows();
    Q_EMIT looked_at(colour_);
}

const tools::ColourAids& ColourPicker::aids() const {
    return aids_->aids();
}

void ColourPicker::show_aids(const tools::ColourAids& aids) {
    aids_->show_aids(aids);
    wheel_->show_aids(aids);
}

void ColourPicker::take_typed_colour() {
    QString text = hex_->text().trimmed();
    if (!text.startsWith('#')) text.prepend('#');
    const auto typed = pigment::parse_hex_colour(text.toStdString());
    if (!typed) {
        Q_EMIT refused(tr("\"%1\" is no colour; write it for example as #c03020.").arg(hex_->text()));
        hex_->setText(QString::fromStdString(pigment::hex_colour(colour_)));
        return;
    }
    if (*typed == colour_) return;
    show_colour(*typed);
    Q_EMIT chosen(colour_);
}

void ColourPicker::write_rows() {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const QSignalBlocker quiet_slider(rows_[i].slider), quiet_number(rows_[i].number);
        const double most = tools::channels_of(model_)[i].most;
        if (!rows_[i].slider->isSliderDown())
            rows_[i].slider->setValue(static_cast<int>(std::lround(kSliderSteps * channels_[i] / most)));
        rows_[i].number->setValue(channels_[i]);
    }
    hex_->setText(QString::fromStdString(pigment::hex_colour(colour_)));
    show_on_wheel();
    paint_ramps();
}

/// The wheel keeps what it showed of a colour: screens have too few to tell every hue and chroma.
void ColourPicker::show_on_wheel() {
    if (model_ == ColourModel::Oklch)
        wheel_->show_colour(channels_);
    else if (tools::colour_from(ColourModel::Oklch, wheel_->oklch()) != colour_)
        wheel_->show_colour(tools::channels_from(ColourModel::Oklch, colour_));
}

void ColourPicker::paint_ramps() {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        QVector<QColor> ramp;
        tools::Channels along = channels_;
        for (int k = 0; k < kRampColours; ++k) {
            along[i] = tools::channels_of(model_)[i].most * k / (kRampColours - 1);
            ramp.push_back(qcolor(tools::colour_from(model_, along)));
        }
        rows_[i].slider->show_ramp(ramp);
    }
}

}  // namespace pastoso::panels
