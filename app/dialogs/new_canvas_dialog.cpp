#include "dialogs/new_canvas_dialog.hpp"

#include "appearance/shown_message.hpp"
#include "appearance/shown_number.hpp"
#include "appearance/terms.hpp"
#include "core/error.hpp"
#include "core/memory.hpp"
#include "core/units.hpp"
#include "dialogs/length_box.hpp"
#include "dialogs/support_choices.hpp"
#include "document/canvas.hpp"

#include <cmath>

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

namespace pastoso::dialogs {
namespace {

constexpr QLatin1String kImage("image");

/// What of the paint can be seen on such cells.
QString shown_words(double px_per_mm) {
    if (px_per_mm < 3.0) return NewCanvasDialog::tr("For large forms: brush marks blur.");
    if (px_per_mm < 6.0)
        return NewCanvasDialog::tr("Bristle marks of broad brushes show; close up, edges are soft.");
    if (px_per_mm < 12.0) return NewCanvasDialog::tr("Bristle marks and the weave show.");
    return NewCanvasDialog::tr("Every bristle and thread shows close up, in fine brushes as well.");
}

}  // namespace

NewCanvasDialog::NewCanvasDialog(const document::CanvasSettings& proposal, double live_px_per_mm,
                                 QWidget* parent)
    : GrowingDialog(parent),
      live_px_per_mm_(live_px_per_mm),
      support_(new QComboBox),
      summary_(new QLabel),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
    setWindowTitle(tr("New canvas"));
    width_ = add_side(QStringLiteral("width_mm"), proposal.width_mm);
    height_ = add_side(QStringLiteral("height_mm"), proposal.height_mm);
    density_ = new UnitBox(read_px_per_mm, QStringLiteral("px_per_mm"), tr(" px/mm"));
    density_->setRange(document::kMinPxPerMm, document::kMaxPxPerMm);
    density_->setValue(proposal.px_per_mm);
    density_->setToolTip(tr("Dots per inch may be typed as well: 127 dpi"));
    for (const Support& support : supports())
        support_->addItem(support.name, QString::fromStdString(support.id));
    support_->addItem(tr("Height image..."), QString(kImage));
    connect(support_, &QComboBox::activated, this, [this] {
        if (support_->currentData().toString() == kImage) choose_image();
        write_summary();
    });
    add_ground();
    buttons_->button(QDialogButtonBox::Ok)->setText(tr("New canvas"));
    connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto* form = new QFormLayout(this);
    form->setContentsMargins(18, 18, 18, 14);
    form->setSpacing(9);
    form->addRow(tr("Width"), width_);
    form->addRow(tr("Height"), height_);
    form->addRow(tr("Resolution"), density_);
    form->addRow(tr("Support"), support_);
    form->addRow(toned_, ground_);
    appearance::explain(form->labelForField(density_), appearance::Term::Resolution);
    appearance::explain(form->labelForField(support_), appearance::Term::Support);
    summary_->setWordWrap(true);
    summary_->setObjectName(QStringLiteral("summary"));
    summary_->setMinimumWidth(300);
    form->addRow(summary_);
    form->addRow(buttons_);
    for (const QDoubleSpinBox* box : {width_, height_, density_})
        connect(box, &QDoubleSpinBox::valueChanged, this, &NewCanvasDialog::write_summary);
    write_summary();
    width_->selectAll();
}

QDoubleSpinBox* NewCanvasDialog::add_side(const QString& name, double value_mm) {
    auto* box = new UnitBox(read_length_mm, name, tr(" mm"));
    box->setRange(document::kMinCanvasSide_mm, document::kMaxCanvasSide_mm);
    box->setValue(value_mm);
    box->read_pixels_at([this] { return density_->value(); });
    box->setToolTip(tr("Other units may be typed as well: 50 cm, 20 in, 3000 px"));
    return box;
}

void NewCanvasDialog::add_ground() {
    toned_ = new QCheckBox(tr("Toned ground"));
    toned_->setObjectName(QStringLiteral("toned_ground"));
    toned_->setToolTip(
        tr("A dry coat of the paint in hand covers the whole canvas, on a layer of its own"));
    ground_ = new UnitBox(read_length_mm, QStringLiteral("ground_mm"), tr(" mm"));
    ground_->setRange(document::kLeastFill_mm, document::kMostFill_mm);
    ground_->setValue(document::ToneGround{}.thickness_mm);
    ground_->setToolTip(tr("0.02 mm tints the canvas, 0.1 mm covers it"));
    ground_->setAccessibleName(tr("Thickness of the toned ground"));
    ground_->setEnabled(false);
    connect(toned_, &QCheckBox::toggled, ground_, &QWidget::setEnabled);
}

std::optional<double> NewCanvasDialog::ground_mm() const {
    return toned_->isChecked() ? std::optional(ground_->value()) : std::nullopt;
}

void NewCanvasDialog::choose_image() {
    const QString path = QFileDialog::getOpenFileName(this, tr("Height image: white is high"));
    if (path.isEmpty()) {
        support_->setCurrentIndex(0);
        return;
    }
    image_path_ = path;
    support_->setItemText(support_->findData(QString(kImage)),
                          tr("Image: %1").arg(QFileInfo(path).fileName()));
}

document::CanvasSettings NewCanvasDialog::settings() const {
    document::CanvasSettings settings;
    settings.width_mm = width_->value();
    settings.height_mm = height_->value();
    settings.px_per_mm = density_->value();
    const QString support = support_->currentData().toString();
    settings.support = support.toStdString();
    if (support == kImage) settings.support_image = image_path_.toStdString();
    return settings;
}

/// Whether this machine keeps pace with the hand on such cells.
QString NewCanvasDialog::pace_words(double px_per_mm) const {
    if (px_per_mm <= live_px_per_mm_) return tr("This machine keeps pace with the hand.");
    return tr("This machine keeps pace with the hand up to %1 px/mm; what is painted can be painted "
              "again finer.")
        .arg(appearance::shown_number(live_px_per_mm_));
}

/// What the canvas will cost, or why there can be none.
void NewCanvasDialog::write_summary() {
    QString text;
    bool possible = true;
    try {
        const document::CanvasSettings wanted = settings();
        document::check_canvas_fits(wanted, core::available_memory_bytes());
        const grid::Shape shape = document::canvas_shape(wanted);
        text = tr("A picture of %1 × %2 pixels, %3 dpi; up to %4 MB of memory when all of it is wet.")
                   .arg(shape.width)
                   .arg(shape.height)
                   .arg(std::lround(core::kInch_mm * wanted.px_per_mm))
                   .arg(document::estimated_bytes(shape) >> 20U);
        text += QLatin1Char('\n') + shown_words(wanted.px_per_mm) + QLatin1Char(' ') +
                pace_words(wanted.px_per_mm);
    } catch (const core::InputError& error) {
        text = appearance::shown_message(error.message());
        possible = false;
    }
    summary_->setText(text);
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(possible);
}

}  // namespace pastoso::dialogs
