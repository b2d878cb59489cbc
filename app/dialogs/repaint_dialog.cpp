#include "dialogs/repaint_dialog.hpp"

#include "appearance/shown_message.hpp"
#include "appearance/shown_number.hpp"
#include "appearance/terms.hpp"
#include "core/error.hpp"
#include "core/memory.hpp"
#include "dialogs/length_box.hpp"
#include "document/canvas.hpp"

#include <algorithm>
#include <utility>

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace pastoso::dialogs {
namespace {

QString gibibytes(std::size_t bytes) {
    return appearance::shown_number(static_cast<double>(bytes) / (1 << 30), 1);
}

/// What the engine says of it.
QString sentences(const std::vector<core::Message>& notes) {
    QString lines;
    for (const core::Message& note : notes)
        lines += QLatin1Char('\n') + appearance::shown_sentence(note);
    return lines;
}

}  // namespace

RepaintDialog::RepaintDialog(document::Recording strokes, std::string name, QWidget* parent)
    : GrowingDialog(parent),
      strokes_(std::move(strokes)),
      name_(std::move(name)),
      px_per_mm_(new UnitBox(read_px_per_mm, QStringLiteral("px_per_mm"), tr(" px/mm"))),
      summary_(new QLabel),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
    setWindowTitle(tr("Paint it again"));
    px_per_mm_->setRange(document::kMinPxPerMm, document::kMaxPxPerMm);
    px_per_mm_->setToolTip(tr("Dots per inch may be typed as well: 127 dpi"));
    px_per_mm_->setValue(std::min(2.0 * strokes_.canvas.px_per_mm, document::kMaxPxPerMm));
    px_per_mm_->selectAll();
    connect(px_per_mm_, &QDoubleSpinBox::valueChanged, this, &RepaintDialog::show_outcome);
    buttons_->button(QDialogButtonBox::Ok)->setText(tr("Paint it again"));
    connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
    summary_->setObjectName(QStringLiteral("summary"));
    summary_->setWordWrap(true);
    summary_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    summary_->setMinimumHeight(4 * summary_->fontMetrics().lineSpacing());
    summary_->setMinimumWidth(48 * summary_->fontMetrics().averageCharWidth());

    auto* form = new QFormLayout;
    form->addRow(tr("&Pixels per millimetre"), px_per_mm_);
    appearance::explain(form->labelForField(px_per_mm_), appearance::Term::Resolution);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(18, 18, 18, 14);
    column->setSpacing(12);
    column->addLayout(form);
    column->addWidget(summary_);
    column->addWidget(buttons_);
    show_outcome();
}

void RepaintDialog::show_outcome() {
    try {
        strokes_.canvas.px_per_mm = px_per_mm_->value();
        const std::size_t free_bytes = core::available_memory_bytes();
        const project::RepaintingTerms terms = project::repainting_terms(strokes_, name_, free_bytes);
        show_possible(
            true, tr("%1 × %2 pixels, which take about %3 GB of memory; %4 GB are free. The strokes are "
                     "painted again beside the painting on the easel, which stays as it is.")
                          .arg(terms.cells.width)
                          .arg(terms.cells.height)
                          .arg(gibibytes(terms.memory_bytes), gibibytes(free_bytes)) +
                      sentences(terms.notes));
    } catch (const core::InputError& error) {
        show_possible(false, appearance::shown_message(error.message()));
    }
}

void RepaintDialog::show_possible(bool possible, const QString& words) {
    summary_->setText(words);
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(possible);
}

}  // namespace pastoso::dialogs
