#include "dialogs/canvas_size_dialog.hpp"

#include "appearance/shown_message.hpp"
#include "appearance/shown_number.hpp"
#include "core/error.hpp"
#include "core/memory.hpp"
#include "dialogs/canvas_size_preview.hpp"
#include "dialogs/length_box.hpp"
#include "document/canvas.hpp"

#include <cmath>

#include <QButtonGroup>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

namespace pastoso::dialogs {
namespace {

constexpr int kFields = 3;
constexpr int kMiddle = 4;

QString anchor_words(int field) {
    const QString words[] = {
        CanvasSizeDialog::tr("The upper left corner stays where it is"),
        CanvasSizeDialog::tr("The middle of the upper edge stays where it is"),
        CanvasSizeDialog::tr("The upper right corner stays where it is"),
        CanvasSizeDialog::tr("The middle of the left edge stays where it is"),
        CanvasSizeDialog::tr("The middle stays where it is"),
        CanvasSizeDialog::tr("The middle of the right edge stays where it is"),
        CanvasSizeDialog::tr("The lower left corner stays where it is"),
        CanvasSizeDialog::tr("The middle of the lower edge stays where it is"),
        CanvasSizeDialog::tr("The lower right corner stays where it is"),
    };
    return words[field];
}

/// "20 mm on the left, 5 mm at the top"; of all margins with that sign.
QString sides_words(const tools::Margins& margins, double sign) {
    QStringList sides;
    const auto note = [&](double margin_mm, const QString& words) {
        if (sign * margin_mm > 0.0)
            sides << words.arg(appearance::shown_number(in_hundredths(std::abs(margin_mm))));
    };
    note(margins.left_mm, CanvasSizeDialog::tr("%1 mm on the left"));
    note(margins.right_mm, CanvasSizeDialog::tr("%1 mm on the right"));
    note(margins.top_mm, CanvasSizeDialog::tr("%1 mm at the top"));
    note(margins.bottom_mm, CanvasSizeDialog::tr("%1 mm at the bottom"));
    return sides.join(QStringLiteral(", "));
}

QString changes_words(const tools::Margins& margins) {
    const QString added = sides_words(margins, 1.0), cut = sides_words(margins, -1.0);
    QStringList lines;
    if (!added.isEmpty()) lines << CanvasSizeDialog::tr("Added: %1.").arg(added);
    if (!cut.isEmpty())
        lines << CanvasSizeDialog::tr("Cut off: %1. What lies there is wiped off.").arg(cut);
    return lines.join(QLatin1Char('\n'));
}

}  // namespace

CanvasSizeDialog::CanvasSizeDialog(const document::CanvasSettings& canvas, const QImage& picture,
                                   QWidget* parent)
    : GrowingDialog(parent),
      canvas_(canvas),
      preview_(new CanvasSizePreview(picture, {canvas.width_mm, canvas.height_mm})),
      summary_(new QLabel),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
    setWindowTitle(tr("Canvas size"));
    width_ = add_side(QStringLiteral("width_mm"), canvas.width_mm);
    height_ = add_side(QStringLiteral("height_mm"), canvas.height_mm);
    buttons_->button(QDialogButtonBox::Ok)->setText(tr("Change the size"));
    connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto* form = new QFormLayout;
    form->setSpacing(9);
    form->addRow(tr("&Width"), width_);
    form->addRow(tr("&Height"), height_);
    form->addRow(tr("Stays in place"), make_anchors());
    summary_->setObjectName(QStringLiteral("summary"));
    summary_->setWordWrap(true);
    summary_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    summary_->setMinimumHeight(4 * summary_->fontMetrics().lineSpacing());

    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(18, 18, 18, 14);
    grid->setHorizontalSpacing(18);
    grid->setVerticalSpacing(12);
    grid->addLayout(form, 0, 0);
    grid->addWidget(preview_, 0, 1);
    grid->setColumnStretch(1, 1);
    grid->addWidget(summary_, 1, 0, 1, 2);
    grid->addWidget(buttons_, 2, 0, 1, 2);
    width_->selectAll();
    show_outcome();
}

QDoubleSpinBox* CanvasSizeDialog::add_side(const QString& name, double value_mm) {
    auto* box = new UnitBox(read_length_mm, name, tr(" mm"));
    box->setRange(document::kMinCanvasSide_mm, document::kMaxCanvasSide_mm);
    box->setValue(value_mm);
    box->read_pixels_at([this] { return canvas_.px_per_mm; });
    box->setToolTip(tr("Other units may be typed as well: 50 cm, 20 in, 3000 px"));
    connect(box, &QDoubleSpinBox::valueChanged, this, &CanvasSizeDialog::show_outcome);
    return box;
}

/// Arrow keys go from field to field.
QGridLayout* CanvasSizeDialog::make_anchors() {
    constexpr QSize kField(26, 22);
    auto* fields = new QGridLayout;
    fields->setSpacing(3);
    fields->setColumnStretch(kFields, 1);
    anchors_ = new QButtonGroup(this);
    for (int field = 0; field < kFields * kFields; ++field) {
        auto* button = new QToolButton;
        button->setCheckable(true);
        button->setAutoExclusive(true);  // or no arrow key would reach it
        button->setStyleSheet(QStringLiteral("QToolButton:focus { border-color: %1; }")
                                  .arg(palette().color(QPalette::ButtonText).name()));
        button->setFixedSize(kField);
        // Tab reaches the chosen one alone: Qt keeps it so from the first focus on.
        button->setFocusPolicy(field == kMiddle ? Qt::StrongFocus : Qt::ClickFocus);
        button->setToolTip(anchor_words(field));
        button->setAccessibleName(anchor_words(field));
        anchors_->addButton(button, field);
        fields->addWidget(button, field / kFields, field % kFields);
    }
    anchors_->button(kMiddle)->setChecked(true);
    connect(anchors_, &QButtonGroup::idToggled, this, [this](int, bool on) {
        if (on) show_outcome();
    });
    return fields;
}

document::ResizeCanvas CanvasSizeDialog::wanted() const {
    const int field = anchors_->checkedId();
    return tools::anchored(canvas_, unrounded(*width_, canvas_.width_mm),
                           unrounded(*height_, canvas_.height_mm), {field % kFields, field / kFields});
}

/// Why there can be no such canvas; empty where there can.
QString CanvasSizeDialog::problem() const {
    try {
        document::check_canvas_fits(document::resized(wanted(), canvas_),
                                    core::available_memory_bytes());
        return {};
    } catch (const core::InputError& error) {
        return appearance::shown_message(error.message());
    }
}

void CanvasSizeDialog::show_outcome() {
    const QString none = problem();
    if (!none.isEmpty()) return show_possible(false, none);
    const tools::Margins margins = tools::margins_of(wanted(), canvas_);
    preview_->show_margins(margins);
    if (margins == tools::Margins{}) return show_possible(false, tr("The canvas has this size."));
    const grid::Shape shape = document::extent_of(wanted(), canvas_).shape;
    show_possible(true, tr("A picture of %1 × %2 pixels.\n%3")
                            .arg(shape.width)
                            .arg(shape.height)
                            .arg(changes_words(margins)));
}

void CanvasSizeDialog::show_possible(bool possible, const QString& words) {
    summary_->setText(words);
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(possible);
}

}  // namespace pastoso::dialogs
