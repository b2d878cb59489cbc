#include "dialogs/scale_dialog.hpp"

#include "appearance/shown_message.hpp"
#include "appearance/shown_number.hpp"
#include "appearance/terms.hpp"
#include "core/error.hpp"
#include "core/memory.hpp"
#include "core/units.hpp"
#include "dialogs/length_box.hpp"
#include "document/canvas.hpp"

#include <cmath>

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

namespace pastoso::dialogs {
namespace {

/// What becomes of the paint.
QString paint_words(const document::ScaleCanvas& scale) {
    const double area = scale.scale_x * scale.scale_y;
    if (area == 1.0) return {};
    return ScaleDialog::tr("Paint keeps its thickness, so that there is %1 times as much of it.")
        .arg(appearance::shown_number(in_hundredths(area)));
}

}  // namespace

double ScaleDialog::Number::change() const {
    const double as_set = set_change * before, now = unrounded(*box, as_set);
    return now == as_set ? set_change : now / before;
}

ScaleDialog::ScaleDialog(const document::CanvasSettings& canvas, QWidget* parent)
    : GrowingDialog(parent),
      canvas_(canvas),
      proportions_(new QCheckBox(tr("Keep the &proportions"))),
      summary_(new QLabel),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
    setWindowTitle(tr("Scale the image"));
    width_ = side(QStringLiteral("width_mm"), canvas.width_mm);
    height_ = side(QStringLiteral("height_mm"), canvas.height_mm);
    density_ =
        number(new UnitBox(read_px_per_mm, QStringLiteral("px_per_mm"), tr(" px/mm")), canvas.px_per_mm);
    density_.box->setToolTip(tr("Dots per inch may be typed as well: 127 dpi"));
    proportions_->setObjectName(QStringLiteral("proportions"));
    proportions_->setChecked(true);
    buttons_->button(QDialogButtonBox::Ok)->setText(tr("Scale the image"));
    connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(width_.box, &QDoubleSpinBox::valueChanged, this,
            [this] { keep_proportions(width_, height_); });
    connect(height_.box, &QDoubleSpinBox::valueChanged, this,
            [this] { keep_proportions(height_, width_); });
    connect(density_.box, &QDoubleSpinBox::valueChanged, this, &ScaleDialog::show_outcome);
    connect(proportions_, &QCheckBox::toggled, this, [this] { keep_proportions(width_, height_); });

    auto* form = new QFormLayout(this);
    form->setContentsMargins(18, 18, 18, 14);
    form->setSpacing(9);
    form->addRow(tr("Width"), width_.box);
    form->addRow(tr("Height"), height_.box);
    form->addRow(QString(), proportions_);
    form->addRow(tr("Resolution"), density_.box);
    appearance::explain(form->labelForField(density_.box), appearance::Term::Resolution);
    summary_->setWordWrap(true);
    summary_->setObjectName(QStringLiteral("summary"));
    summary_->setMinimumWidth(300);
    form->addRow(summary_);
    form->addRow(buttons_);
    width_.box->selectAll();
    show_outcome();
}

ScaleDialog::Number ScaleDialog::side(const QString& name, double value_mm) {
    auto* box = new UnitBox(read_length_mm, name, tr(" mm"));
    box->read_pixels_at([this] { return density_.box->value(); });
    box->setToolTip(tr("Other units may be typed as well: 50 cm, 20 in, 3000 px"));
    return number(box, value_mm);
}

ScaleDialog::Number ScaleDialog::number(QDoubleSpinBox* box, double value) {
    box->setRange(document::kLeastCanvasScale * value, document::kMostCanvasScale * value);
    box->setValue(value);
    return {box, value};
}

void ScaleDialog::keep_proportions(const Number& typed, Number& other) {
    if (proportions_->isChecked()) {
        const QSignalBlocker quiet(other.box);
        other.set_change = typed.change();
        other.box->setValue(other.before * other.set_change);
    }
    show_outcome();
}

document::ScaleCanvas ScaleDialog::wanted() const {
    return {width_.change(), height_.change(), density_.change()};
}

void ScaleDialog::show_outcome() {
    const document::ScaleCanvas scale = wanted();
    if (scale == document::ScaleCanvas{})
        return show_possible(false, tr("The image has this size and this resolution."));
    try {
        const document::CanvasSettings after = document::scaled(scale, canvas_);
        document::check_canvas_fits(after, core::available_memory_bytes());
        const grid::Shape shape = document::canvas_shape(after);
        const QString picture =
            tr("A picture of %1 × %2 pixels, %3 dpi; up to %4 MB of memory when all of it is wet.")
                .arg(shape.width)
                .arg(shape.height)
                .arg(std::lround(core::kInch_mm * after.px_per_mm))
                .arg(document::estimated_bytes(shape) >> 20U);
        show_possible(true, picture + QLatin1Char('\n') + paint_words(scale));
    } catch (const core::InputError& error) {
        show_possible(false, appearance::shown_message(error.message()));
    }
}

void ScaleDialog::show_possible(bool possible, const QString& words) {
    summary_->setText(words);
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(possible);
}

}  // namespace pastoso::dialogs
