#include "dialogs/select_range_dialog.hpp"

#include "appearance/shown_number.hpp"
#include "dialogs/length_box.hpp"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

namespace pastoso::dialogs {

SelectRangeDialog::SelectRangeDialog(const QString& title, const QString& explanation,
                                     const SelectedRange& proposal, QWidget* parent)
    : GrowingDialog(parent), how_(new QComboBox), outcome_(new QLabel) {
    setWindowTitle(title);
    least_ = add_thickness(QStringLiteral("least_mm"), proposal.least_mm);
    most_ = add_thickness(QStringLiteral("most_mm"), proposal.most_mm);
    // Neither may pass the other.
    connect(least_, &QDoubleSpinBox::valueChanged, most_, &QDoubleSpinBox::setMinimum);
    most_->setMinimum(least_->value());
    how_->setObjectName(QStringLiteral("how"));
    how_->addItems({tr("Select it"), tr("Add it to the selection"), tr("Take it out of the selection"),
                    tr("Keep what is in both")});
    how_->setCurrentIndex(static_cast<int>(proposal.how));
    connect(how_, &QComboBox::currentIndexChanged, this, &SelectRangeDialog::changed);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Select"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto* form = new QFormLayout(this);
    form->setContentsMargins(18, 18, 18, 14);
    form->setSpacing(9);
    auto* words = new QLabel(explanation);
    words->setWordWrap(true);
    words->setMinimumWidth(300);
    form->addRow(words);
    form->addRow(tr("From"), least_);
    form->addRow(tr("To"), most_);
    form->addRow(tr("Do"), how_);
    outcome_->setObjectName(QStringLiteral("outcome"));
    form->addRow(outcome_);
    form->addRow(buttons);
}

QDoubleSpinBox* SelectRangeDialog::add_thickness(const QString& name, double value_mm) {
    constexpr double kMost_mm = 1000.0;
    auto* box = new UnitBox(read_length_mm, name, tr(" mm"));
    box->setRange(0.0, kMost_mm);
    box->setDecimals(3);
    box->setSingleStep(0.01);
    box->setValue(value_mm);
    connect(box, &QDoubleSpinBox::valueChanged, this, &SelectRangeDialog::changed);
    return box;
}

SelectedRange SelectRangeDialog::chosen() const {
    return {least_->value(), most_->value(), static_cast<grid::Combination>(how_->currentIndex())};
}

void SelectRangeDialog::show_outcome(double share, bool nothing) {
    const double percent = 100.0 * share;
    outcome_->setText(nothing ? tr("Nothing is there to be selected.")
                              : tr("Then %1 % of the canvas is selected.")
                                    .arg(appearance::shown_number(percent, percent < 9.95 ? 1 : 0)));
}

}  // namespace pastoso::dialogs
