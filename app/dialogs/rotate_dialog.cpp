#include "dialogs/rotate_dialog.hpp"

#include "appearance/shown_message.hpp"
#include "appearance/shown_number.hpp"
#include "core/error.hpp"
#include "core/memory.hpp"
#include "dialogs/canvas_size_preview.hpp"
#include "dialogs/length_box.hpp"
#include "document/canvas.hpp"
#include "tools/canvas_resizing.hpp"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

namespace pastoso::dialogs {

RotateDialog::RotateDialog(const document::CanvasSettings& canvas, const QImage& picture,
                           const std::optional<brush::Ruler>& ruler, QWidget* parent)
    : GrowingDialog(parent),
      canvas_(canvas),
      preview_(new CanvasSizePreview(picture, {canvas.width_mm, canvas.height_mm})),
      turn_(new QDoubleSpinBox),
      keeps_size_(new QCheckBox(tr("&Keep the size of the canvas"))),
      summary_(new QLabel),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
    setWindowTitle(tr("Rotate the image"));
    turn_->setObjectName(QStringLiteral("turn"));
    turn_->setRange(-180.0, 180.0);
    turn_->setDecimals(2);
    turn_->setWrapping(true);
    turn_->setSuffix(tr("°"));
    turn_->setToolTip(tr("Clockwise, about the middle of the canvas"));
    keeps_size_->setObjectName(QStringLiteral("keeps_size"));
    keeps_size_->setToolTip(tr("What comes beyond the canvas is wiped off"));
    buttons_->button(QDialogButtonBox::Ok)->setText(tr("Rotate the image"));
    connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(turn_, &QDoubleSpinBox::valueChanged, this, &RotateDialog::show_outcome);
    connect(keeps_size_, &QCheckBox::toggled, this, &RotateDialog::show_outcome);

    auto* straighten = new QPushButton(tr("Put the &ruler straight"));
    straighten->setObjectName(QStringLiteral("straighten"));
    straighten->setAutoDefault(false);
    straighten->setEnabled(ruler.has_value());
    straighten->setToolTip(ruler ? tr("Turns until the ruler is level or upright, whichever is nearer")
                                 : tr("Lay a ruler along the horizon first"));
    if (ruler)
        connect(straighten, &QPushButton::clicked, this,
                [this, turn_deg = tools::straightening_deg(*ruler)] { turn_->setValue(turn_deg); });

    auto* form = new QFormLayout(this);
    form->setContentsMargins(18, 18, 18, 14);
    form->setSpacing(9);
    form->addRow(preview_);
    form->addRow(tr("Turn"), turn_);
    form->addRow(QString(), straighten);
    form->addRow(QString(), keeps_size_);
    summary_->setWordWrap(true);
    summary_->setObjectName(QStringLiteral("summary"));
    summary_->setMinimumWidth(300);
    form->addRow(summary_);
    form->addRow(buttons_);
    turn_->selectAll();
    show_outcome();
}

document::RotateCanvas RotateDialog::wanted() const {
    return {turn_->value(), keeps_size_->isChecked()};
}

void RotateDialog::show_outcome() {
    const document::RotateCanvas rotate = wanted();
    try {
        const document::CanvasSettings after = document::rotated(rotate, canvas_);
        document::check_canvas_fits(after, core::available_memory_bytes());
        preview_->show_rotated({after.width_mm, after.height_mm}, rotate.turn_deg);
        if (rotate.turn_deg == 0.0) return show_possible(false, tr("The image stands like this."));
        const QString size = tr("A canvas of %1 × %2 mm.")
                                 .arg(appearance::shown_number(in_hundredths(after.width_mm)),
                                      appearance::shown_number(in_hundredths(after.height_mm)));
        const QString rest = rotate.keeps_size ? tr("What comes beyond it is wiped off.")
                                               : tr("What is new in its corners is bare.");
        show_possible(true, size + QLatin1Char(' ') + rest + QLatin1Char('\n') +
                                tr("The weave turns with the paint."));
    } catch (const core::InputError& error) {
        show_possible(false, appearance::shown_message(error.message()));
    }
}

void RotateDialog::show_possible(bool possible, const QString& words) {
    summary_->setText(words);
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(possible);
}

}  // namespace pastoso::dialogs
