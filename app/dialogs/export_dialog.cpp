#include "dialogs/export_dialog.hpp"

#include "dialogs/length_box.hpp"
#include "document/canvas.hpp"

#include <utility>

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace pastoso::dialogs {
namespace {

constexpr int kWidth = 500;

/// Shows no digits that say nothing.
class PlainNumber : public QDoubleSpinBox {
  public:
    QString textFromValue(double value) const override {
        QString text = QDoubleSpinBox::textFromValue(value);
        if (!text.contains(locale().decimalPoint())) return text;
        while (text.endsWith(locale().zeroDigit()))
            text.chop(1);
        if (text.endsWith(locale().decimalPoint())) text.chop(1);
        return text;
    }
};

}  // namespace

ExportDialog::ExportDialog(ExportSubject subject, const tools::ExportSettings& settings,
                           std::filesystem::path proposal, bool may_replace, QWidget* parent)
    : GrowingDialog(parent),
      subject_(std::move(subject)),
      settings_(settings),
      proposal_(std::move(proposal)),
      named_(may_replace) {
    setWindowTitle(tr("Export"));
    make_form_box();
    path_row_ = make_path_row();
    format_ = add_choice("format", tr("What the file is; its name ends accordingly"));
    connect(format_, &QComboBox::activated, this,
            [this](int row) { choose_format(static_cast<std::size_t>(row)); });
    make_picture_boxes();
    size_row_ = make_size_row();
    make_colour_box();
    make_numbers();
    lay_out();
    choose_form(settings_.form);
    path_->setFocus();
}

QComboBox* ExportDialog::add_choice(const char* name, const QString& hint) {
    auto* box = new QComboBox;
    box->setObjectName(QString::fromLatin1(name));
    box->setToolTip(hint);
    return box;
}

QDoubleSpinBox* ExportDialog::add_number(const Number& number, double& value) {
    return add_number(new PlainNumber, number, value);
}

QDoubleSpinBox* ExportDialog::add_number(QDoubleSpinBox* box, const Number& number, double& value) {
    box->setObjectName(QString::fromLatin1(number.name));
    box->setRange(number.least, number.most);
    box->setDecimals(number.decimals);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setSuffix(number.unit);
    box->setToolTip(number.hint);
    box->setValue(value);
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, &value](double chosen) {
        value = chosen;
        show_outcome();
    });
    return box;
}

void ExportDialog::make_form_box() {
    form_ = add_choice("form", tr("What is made of the painting"));
    form_->addItems({tr("Picture"), tr("Layers, for compositing"), tr("Maps, for 3D programs"),
                     tr("Relief, for 3D printing"), tr("Time-lapse")});
    connect(form_, &QComboBox::activated, this,
            [this](int row) { choose_form(static_cast<tools::ExportForm>(row)); });
    explanation_ = new QLabel;
    explanation_->setObjectName(QStringLiteral("reading"));
    explanation_->setWordWrap(true);
    explanation_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    explanation_->setMinimumHeight(2 * explanation_->fontMetrics().lineSpacing());
}

QWidget* ExportDialog::make_path_row() {
    auto* row = new QWidget;
    path_ = new QLineEdit;
    path_->setObjectName(QStringLiteral("path"));
    path_->setToolTip(tr("Where it is put; the ending of the name chooses the format"));
    connect(path_, &QLineEdit::textEdited, this, &ExportDialog::follow_name);
    auto* button = new QPushButton(tr("&Browse..."));
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, &ExportDialog::browse);
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(path_, 1);
    line->addWidget(button);
    return row;
}

void ExportDialog::make_picture_boxes() {
    quality_ = new QSpinBox;
    quality_->setObjectName(QStringLiteral("quality"));
    quality_->setRange(1, 100);
    quality_->setValue(settings_.quality);
    quality_->setToolTip(tr("1 is a small file, 100 a fine picture"));
    connect(quality_, &QSpinBox::valueChanged, this, [this](int quality) {
        settings_.quality = quality;
        show_outcome();
    });
    surface_ = add_choice("surface", tr("What the picture is of"));
    surface_->addItems({tr("The canvas"), tr("The mixing well")});
    surface_->setCurrentIndex(settings_.of_well ? 1 : 0);
    connect(surface_, &QComboBox::activated, this, [this](int row) {
        settings_.of_well = row == 1;
        show_size();
        show_outcome();
    });
    lit_ = new QCheckBox(tr("&Light and shade"));
    lit_->setObjectName(QStringLiteral("lit"));
    lit_->setToolTip(
        tr("As the window shows the painting; otherwise the paint's own colours, as a scan "
           "would have them"));
    lit_->setChecked(settings_.lit);
    connect(lit_, &QCheckBox::toggled, this, [this](bool lit) { settings_.lit = lit; });
}

/// The scale decides; the width shows what it comes to, and changes it.
QWidget* ExportDialog::make_size_row() {
    auto* row = new QWidget;
    scale_ = add_number({"scale", tools::kLeastExportScale, tools::kMostExportScale, 4, tr(" ×"),
                         tr("1 as the window paints it, 2 twice as wide and high: finer, not merely "
                            "enlarged")},
                        settings_.scale);
    connect(scale_, &QDoubleSpinBox::valueChanged, this, &ExportDialog::show_size);
    width_ = new QSpinBox;
    width_->setObjectName(QStringLiteral("width"));
    width_->setSuffix(tr(" px wide"));
    width_->setToolTip(tr("The width that the scale comes to, or the scale that gives this width"));
    width_->setAccessibleName(tr("Width of the picture in pixels"));
    connect(width_, &QSpinBox::valueChanged, this, [this](int width_px) {
        settings_.scale = static_cast<double>(width_px) / cells_across();
        const QSignalBlocker quiet(scale_);
        scale_->setValue(settings_.scale);
        show_outcome();
    });
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(scale_, 1);
    line->addWidget(width_, 1);
    return row;
}

void ExportDialog::make_colour_box() {
    colours_ =
        add_choice("colours", tr("What the numbers in the file mean; the file says so too. sRGB is "
                                 "for common screens, Display P3 for screens of wide gamut, an ICC "
                                 "profile for a printer"));
    list_colours();
    connect(colours_, &QComboBox::activated, this, &ExportDialog::choose_colours);
}

void ExportDialog::make_numbers() {
    recordings::ReliefOptions& relief = settings_.relief;
    base_ = add_number({"base_mm", 0.1, 100.0, 1, tr(" mm"),
                        tr("Thickness from the flat back to the lowest level of the canvas")},
                       relief.base_mm);
    exaggeration_ =
        add_number({"exaggeration", 0.01, 100.0, 2, tr(" times as high"),
                    tr("1 is the relief as it is painted, 2 twice as high; width and height stay")},
                   relief.exaggeration);
    resolution_ =
        add_number({"resolution_mm", 0.0, 100.0, 3, tr(" mm apart"),
                    tr("Distance between two points of the surface; 0 is as far as the pixels, "
                       "or farther where the canvas is large")},
                   relief.resolution_mm);
    resolution_->setSpecialValueText(tr("automatic"));
    speed_ = add_number({"speed", tools::kLeastSpeed, tools::kMostSpeed, 2, tr(" times as fast"),
                         tr("Seconds of painting in a second of film")},
                        settings_.speed);
    fps_ =
        add_number({"fps", 1.0, tools::kMostFps, 1, tr(" per second"), tr("Frames in a second of film")},
                   settings_.fps);
    film_cells_ =
        add_number(new UnitBox(read_px_per_mm, QString(), QString()),
                   {"film_px_per_mm", 0.0, document::kMaxPxPerMm, 2, tr(" px/mm"),
                    tr("Pixels in a millimetre of the canvas that it is painted on once more: more show "
                       "finer paint and take longer; 0 is as it was painted")},
                   settings_.film_px_per_mm);
    film_cells_->setSpecialValueText(tr("as it was painted"));
    connect(film_cells_, &QDoubleSpinBox::valueChanged, this, &ExportDialog::show_size);
}

void ExportDialog::add_row(const QString& words, QWidget* field, QWidget* buddy) {
    auto* label = new QLabel(words);
    label->setBuddy(buddy != nullptr ? buddy : field);
    // A screen reader looks for labels right beside a widget alone.
    if (buddy != nullptr) buddy->setAccessibleName(QString(words).remove(QLatin1Char('&')));
    const int row = rows_->rowCount();
    rows_->addWidget(label, row, 0);
    rows_->addWidget(field, row, 1);
    labels_[field] = label;
}

void ExportDialog::show_row(QWidget* field, bool shown) {
    labels_.at(field)->setVisible(shown);
    field->setVisible(shown);
}

void ExportDialog::lay_out() {
    rows_ = new QGridLayout(this);
    rows_->setContentsMargins(18, 18, 18, 14);
    rows_->setSpacing(9);
    rows_->setColumnStretch(1, 1);
    add_row(tr("&Make"), form_);
    add_row(QString(), explanation_);
    add_row(tr("&File name"), path_row_, path_);
    add_row(tr("F&ormat"), format_);
    add_row(tr("&Quality"), quality_);
    add_row(tr("Sho&w"), surface_);
    add_row(tr("&Scale"), size_row_, scale_);
    add_row(tr("&Colours"), colours_);
    add_row(QString(), lit_);
    add_row(tr("&Thickness"), base_);
    add_row(tr("&Heights"), exaggeration_);
    add_row(tr("&Points"), resolution_);
    add_row(tr("Sp&eed"), speed_);
    add_row(tr("F&rames"), fps_);
    add_row(tr("Canvas of &it"), film_cells_);
    outcome_ = new QLabel;
    outcome_->setObjectName(QStringLiteral("outcome"));
    outcome_->setWordWrap(true);
    outcome_->setMinimumHeight(2 * outcome_->fontMetrics().lineSpacing());
    outcome_->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    rows_->addWidget(outcome_, rows_->rowCount(), 0, 1, 2);
    buttons_ = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    export_ = buttons_->button(QDialogButtonBox::Ok);
    connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
    rows_->addWidget(buttons_, rows_->rowCount(), 0, 1, 2);
    setMinimumWidth(kWidth);
    resize(kWidth, height());
}

}  // namespace pastoso::dialogs
