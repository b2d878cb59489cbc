#include "dialogs/recovery_dialog.hpp"

#include "appearance/shown_message.hpp"
#include "dialogs/unfinished_words.hpp"

#include <utility>

#include <QDialogButtonBox>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

namespace pastoso::dialogs {
namespace {

constexpr int kPicture_px = 96;

}  // namespace

RecoveryDialog::RecoveryDialog(std::vector<journal::Unfinished> paintings, QWidget* parent,
                               Confirm confirm)
    : GrowingDialog(parent),
      paintings_(std::move(paintings)),
      confirm_(std::move(confirm)),
      list_(new QListWidget),
      fault_(new QLabel) {
    setWindowTitle(tr("Unfinished paintings"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(18, 18, 18, 14);
    layout->setSpacing(9);
    layout->addWidget(new QLabel(tr("Pastoso ended before these were saved.")));
    list_->setAccessibleName(windowTitle());
    list_->setIconSize({kPicture_px, kPicture_px});
    list_->setMinimumSize(420, 260);
    layout->addWidget(list_);
    fault_->setWordWrap(true);
    layout->addWidget(fault_);

    auto* buttons = new QDialogButtonBox;
    recover_ = buttons->addButton(tr("Recover"), QDialogButtonBox::AcceptRole);
    buttons->addButton(tr("Not now"), QDialogButtonBox::RejectRole);
    discard_ = buttons->addButton(tr("Discard"), QDialogButtonBox::DestructiveRole);
    layout->addWidget(buttons);
    recover_->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(discard_, &QPushButton::clicked, this, &RecoveryDialog::discard_chosen);
    connect(list_, &QListWidget::currentRowChanged, this, &RecoveryDialog::show_chosen);
    connect(list_, &QListWidget::itemDoubleClicked, this, [this] {
        if (recover_->isEnabled()) accept();
    });
    list_paintings();
    connect(&pictures_, &UnfinishedPictures::painted, this, &RecoveryDialog::show_picture);
    for (const journal::Unfinished& painting : paintings_)
        pictures_.want(painting);
}

const journal::Unfinished& RecoveryDialog::chosen() const {
    return paintings_.at(static_cast<std::size_t>(list_->currentRow()));
}

void RecoveryDialog::list_paintings() {
    list_->clear();
    for (const journal::Unfinished& painting : paintings_)
        list_->addItem(new QListWidgetItem(unfinished_picture(painting, kPicture_px), unfinished_words(painting)));
    list_->setCurrentRow(0);
}

void RecoveryDialog::show_picture(const journal::Unfinished& painting) {
    for (std::size_t i = 0; i < paintings_.size(); ++i) {
        if (paintings_[i].folder != painting.folder) continue;
        paintings_[i].thumbnail = painting.thumbnail;
        list_->item(static_cast<int>(i))->setIcon(unfinished_picture(painting, kPicture_px));
    }
}

void RecoveryDialog::show_chosen() {
    if (list_->currentRow() < 0) return;
    const core::Message& fault = chosen().fault;
    recover_->setEnabled(fault.empty());
    fault_->setText(appearance::shown_message(fault));
    fault_->setVisible(!fault.empty());
}

/// Another window may have taken it meanwhile; then it is no longer ours to discard.
void RecoveryDialog::discard_chosen() {
    const QString question = tr("Discard %1 for good? It is nowhere else.").arg(unfinished_name(chosen()));
    const bool agreed = confirm_ ? confirm_(question)
                                 : QMessageBox::question(this, windowTitle(), question,
                                                         QMessageBox::Discard | QMessageBox::Cancel,
                                                         QMessageBox::Cancel) == QMessageBox::Discard;
    if (!agreed) return;
    if (auto claim = journal::Claim::on(chosen().folder)) claim->discard();
    paintings_.erase(paintings_.begin() + list_->currentRow());
    if (paintings_.empty())
        reject();
    else
        list_paintings();
}

}  // namespace pastoso::dialogs
