#include "dialogs/texture_dialog.hpp"

#include "dialogs/length_box.hpp"
#include "dialogs/texture_picture.hpp"
#include "document/actions/texture_actions.hpp"

#include <algorithm>
#include <initializer_list>

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPixmap>
#include <QPushButton>

namespace pastoso::dialogs {
namespace {

using Form = ChosenTexture::Form;

constexpr QSize kPiece_px(300, 170);
constexpr double kPiecePxPerMm = 8.0;

}  // namespace

TextureDialog::TextureDialog(const ChosenTexture& proposal, const QString& picture_filter,
                             QWidget* parent)
    : GrowingDialog(parent),
      chosen_(proposal),
      picture_filter_(picture_filter),
      form_(new QFormLayout(this)),
      forms_(new QComboBox),
      others_(new QPushButton(tr("A&nother"))),
      piece_(new QLabel),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)),
      reader_(kPiece_px) {
    setWindowTitle(tr("Texture paste"));
    form_->setContentsMargins(18, 18, 18, 14);
    form_->setSpacing(9);
    auto* words =
        new QLabel(tr("A dry coat of the paint in hand lies on the layer that you paint on, "
                      "where it is selected or all over. Brushes then catch on it."));
    words->setWordWrap(true);
    words->setMinimumWidth(kPiece_px.width());
    form_->addRow(words);
    forms_->setObjectName(QStringLiteral("form"));
    forms_->addItems({tr("Sand"), tr("Modelling paste"), tr("A picture pressed in")});
    forms_->setCurrentIndex(static_cast<int>(proposal.form));
    form_->addRow(tr("Texture"), forms_);
    grain_ = add_length(QStringLiteral("grain_mm"), tr("Grains"), document::kLeastGrain_mm,
                        document::kMostGrain_mm, proposal.sand.grain_mm);
    height_ = add_length(QStringLiteral("height_mm"), tr("Height"), document::kLeastTexture_mm,
                         document::kMostTexture_mm, proposal.knifed.height_mm);
    spacing_ = add_length(QStringLiteral("spacing_mm"), tr("Between ridges"), document::kLeastRidges_mm,
                          document::kMostRidges_mm, proposal.knifed.spacing_mm);
    add_direction();
    add_picture();
    piece_->setObjectName(QStringLiteral("piece"));
    form_->addRow(piece_);
    others_->setObjectName(QStringLiteral("another"));
    others_->setToolTip(tr("Other grains or other passes of the knife"));
    form_->addRow(QString(), others_);
    buttons_->button(QDialogButtonBox::Ok)->setText(tr("Lay the paste"));
    form_->addRow(buttons_);
    connect(forms_, &QComboBox::currentIndexChanged, this, [this] {
        read();
        show_form();
    });
    connect(others_, &QPushButton::clicked, this, &TextureDialog::take_others);
    connect(&reader_, &StencilReader::was_read, this, [this](const StencilReader::Picture& picture) {
        stencil_ = picture;
        show_piece();
    });
    connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
    show_form();
}

QDoubleSpinBox* TextureDialog::add_length(const QString& name, const QString& words, double least_mm,
                                          double most_mm, double value_mm) {
    auto* box = new UnitBox(read_length_mm, name, tr(" mm"));
    box->setRange(least_mm, most_mm);
    box->setSingleStep(least_mm);
    box->setValue(value_mm);
    connect(box, &QDoubleSpinBox::valueChanged, this, &TextureDialog::read);
    form_->addRow(words, box);
    return box;
}

void TextureDialog::add_direction() {
    direction_ = new QDoubleSpinBox;
    direction_->setObjectName(QStringLiteral("direction"));
    direction_->setRange(-180.0, 180.0);
    direction_->setWrapping(true);
    direction_->setDecimals(0);
    direction_->setSingleStep(15.0);
    direction_->setSuffix(tr("°"));
    direction_->setToolTip(tr("Which way the knife went: 0 to the right, 90 down"));
    direction_->setValue(chosen_.knifed.direction_deg);
    connect(direction_, &QDoubleSpinBox::valueChanged, this, &TextureDialog::read);
    form_->addRow(tr("Direction"), direction_);
}

void TextureDialog::add_picture() {
    picture_ = new QPushButton;
    picture_->setObjectName(QStringLiteral("picture"));
    connect(picture_, &QPushButton::clicked, this, &TextureDialog::ask_picture);
    form_->addRow(tr("Picture"), picture_);
    relief_ = add_length(QStringLiteral("relief_mm"), tr("Height"), document::kLeastTexture_mm,
                         document::kMostTexture_mm, chosen_.pressed.height_mm);
    dark_ = new QCheckBox(tr("What is &dark stands up"));
    dark_->setObjectName(QStringLiteral("dark_raised"));
    dark_->setChecked(chosen_.pressed.dark_raised);
    connect(dark_, &QCheckBox::toggled, this, &TextureDialog::read);
    form_->addRow(QString(), dark_);
}

void TextureDialog::ask_picture() {
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Picture to press in"), chosen_.picture, picture_filter_);
    if (!path.isEmpty()) choose_picture(path);
}

void TextureDialog::choose_picture(const QString& path) {
    chosen_.picture = path;
    show_form();
}

void TextureDialog::read() {
    chosen_.form = static_cast<Form>(forms_->currentIndex());
    chosen_.sand.grain_mm = grain_->value();
    chosen_.knifed.height_mm = height_->value();
    chosen_.knifed.spacing_mm = spacing_->value();
    chosen_.knifed.direction_deg = direction_->value();
    chosen_.pressed.height_mm = relief_->value();
    chosen_.pressed.dark_raised = dark_->isChecked();
    show_piece();
}

void TextureDialog::take_others() {
    ++chosen_.sand.seed;
    ++chosen_.knifed.seed;
    show_piece();
}

void TextureDialog::show_form() {
    form_->setRowVisible(grain_, chosen_.form == Form::Sand);
    for (QWidget* of_knife : {height_, spacing_, direction_})
        form_->setRowVisible(of_knife, chosen_.form == Form::Knifed);
    const bool pressed = chosen_.form == Form::Pressed;
    for (QWidget* of_picture : std::initializer_list<QWidget*>{picture_, relief_, dark_})
        form_->setRowVisible(of_picture, pressed);
    form_->setRowVisible(others_, !pressed);
    if (pressed && chosen_.picture != wanted_) {
        wanted_ = chosen_.picture;
        stencil_.reset();
        reader_.want(wanted_.toStdString());
    }
    picture_->setText(chosen_.picture.isEmpty() ? tr("Choose a picture...")
                                                : QFileInfo(chosen_.picture).fileName());
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(!pressed || !chosen_.picture.isEmpty());
    show_piece();
}

void TextureDialog::show_piece() {
    const bool there = chosen_.form != Form::Pressed || stencil_;
    if (there) piece_->setPixmap(QPixmap::fromImage(piece()));
    form_->setRowVisible(piece_, there);
}

QImage TextureDialog::piece() const {
    if (chosen_.form == Form::Sand) return texture_picture(chosen_.sand, kPiece_px, kPiecePxPerMm);
    if (chosen_.form == Form::Knifed) return texture_picture(chosen_.knifed, kPiece_px, kPiecePxPerMm);
    return pressed_piece();
}

/// All of it, its slopes as steep as they will be.
QImage TextureDialog::pressed_piece() const {
    const QSize size_px =
        QSize(stencil_->width, stencil_->height).scaled(kPiece_px, Qt::KeepAspectRatio);
    const layers::PicturePlace& room = chosen_.pressed.place;
    const double px_per_mm =
        std::max(size_px.width() / room.width_mm, size_px.height() / room.height_mm);
    layers::PressedTexture pressed = chosen_.pressed;
    pressed.picture = stencil_;
    pressed.place = {0.0, 0.0, size_px.width() / px_per_mm, size_px.height() / px_per_mm};
    return texture_picture(pressed, size_px, px_per_mm);
}

}  // namespace pastoso::dialogs
