#include "dialogs/recovery_dialog.hpp"

#include <filesystem>
#include <utility>

#include <QDateTime>
#include <QDialogButtonBox>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QMessageBox>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

namespace pastoso::dialogs {
namespace {

constexpr int kPicture_px = 96;

/// The picture in the middle of a square, so that the texts of all rows stand in line.
QIcon picture_of(const journal::Unfinished& painting) {
    QPixmap square(kPicture_px, kPicture_px);
    square.fill(Qt::transparent);
    QPixmap picture;
    const std::string& file = painting.thumbnail;
    if (picture.loadFromData(reinterpret_cast<const uchar*>(file.data()),
                             static_cast<uint>(file.size()))) {
        picture = picture.scaled(square.size(), Qt::KeepAspectRatio, Qt::SmoothTransformation);
        QPainter(&square).drawPixmap((kPicture_px - picture.width()) / 2,
                                     (kPicture_px - picture.height()) / 2, picture);
    }
    return square;
}

QString name_of(const journal::Unfinished& painting) {
    if (painting.painting.empty()) return RecoveryDialog::tr("A painting without a name");
    return QString::fromStdString(std::filesystem::path(painting.painting).filename().string());
}

QString time_of(const journal::Unfinished& painting) {
    const auto seconds = std::chrono::system_clock::to_time_t(painting.last_painted);
    return QLocale().toString(QDateTime::fromSecsSinceEpoch(seconds), QLocale::ShortFormat);
}

QString text_of(const journal::Unfinished& painting) {
    if (!painting.fault.empty())
        return RecoveryDialog::tr("A painting that cannot be read\n%1").arg(time_of(painting));
    return RecoveryDialog::tr("%1\n%2\n%3 × %4 mm, %n change(s) not saved", nullptr,
                              static_cast<int>(painting.changes))
        .arg(name_of(painting), time_of(painting))
        .arg(painting.canvas.width_mm)
        .arg(painting.canvas.height_mm);
}

}  // namespace

RecoveryDialog::RecoveryDialog(std::vector<journal::Unfinished> paintings, QWidget* parent,
                               Confirm confirm)
    : QDialog(parent),
      paintings_(std::move(paintings)),
      confirm_(std::move(confirm)),
      list_(new QListWidget),
      fault_(new QLabel) {
    setWindowTitle(tr("Unfinished paintings"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(18, 18, 18, 14);
    layout->setSpacing(9);
    layout->addWidget(new QLabel(tr("Pastoso ended before these were saved.")));
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
}

const journal::Unfinished& RecoveryDialog::chosen() const {
    return paintings_.at(static_cast<std::size_t>(list_->currentRow()));
}

void RecoveryDialog::list_paintings() {
    list_->clear();
    for (const journal::Unfinished& painting : paintings_)
        list_->addItem(new QListWidgetItem(picture_of(painting), text_of(painting)));
    list_->setCurrentRow(0);
}

void RecoveryDialog::show_chosen() {
    if (list_->currentRow() < 0) return;
    const std::string& fault = chosen().fault;
    recover_->setEnabled(fault.empty());
    fault_->setText(QString::fromStdString(fault));
    fault_->setVisible(!fault.empty());
}

/// Another window may have taken it meanwhile; then it is no longer ours to discard.
void RecoveryDialog::discard_chosen() {
    const QString question = tr("Discard %1 for good? It is nowhere else.").arg(name_of(chosen()));
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
