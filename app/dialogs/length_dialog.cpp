#include "dialogs/length_dialog.hpp"

#include "dialogs/length_box.hpp"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

namespace pastoso::dialogs {

LengthDialog::LengthDialog(const AskedLength& asked, QWidget* parent)
    : GrowingDialog(parent),
      length_(new UnitBox(read_length_mm, QStringLiteral("length_mm"), tr(" mm"))) {
    setWindowTitle(asked.title);
    length_->setRange(asked.least_mm, asked.most_mm);
    length_->setValue(asked.proposal_mm);
    connect(length_, &QDoubleSpinBox::valueChanged, this, &LengthDialog::changed);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    takes_ = buttons->button(QDialogButtonBox::Ok);
    takes_->setText(asked.button);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto* form = new QFormLayout(this);
    form->setContentsMargins(18, 18, 18, 14);
    form->setSpacing(9);
    auto* words = new QLabel(asked.explanation);
    words->setWordWrap(true);
    words->setMinimumWidth(300);
    form->addRow(words);
    form->addRow(asked.name, length_);
    problem_ = new QLabel;
    problem_->setObjectName(QStringLiteral("problem"));
    problem_->setWordWrap(true);
    problem_->hide();
    form->addRow(problem_);
    form->addRow(buttons);
    length_->selectAll();
}

double LengthDialog::chosen_mm() const {
    return length_->value();
}

void LengthDialog::show_problem(const QString& sentence) {
    problem_->setText(sentence);
    problem_->setVisible(!sentence.isEmpty());
    takes_->setEnabled(sentence.isEmpty());
}

}  // namespace pastoso::dialogs
