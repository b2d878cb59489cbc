#include "start/unfinished_section.hpp"

#include "appearance/shown_message.hpp"
#include "dialogs/unfinished_words.hpp"
#include "start/section.hpp"

#include <algorithm>

#include <QHBoxLayout>
#include <QPushButton>

namespace pastoso::start {
namespace {

constexpr std::size_t kMostRows = 2;
constexpr int kPicture_px = 56;

}  // namespace

UnfinishedSection::UnfinishedSection(QWidget* parent) : QWidget(parent), rows_(section_column(this)) {
    setVisible(false);
    connect(&pictures_, &dialogs::UnfinishedPictures::painted, this, &UnfinishedSection::show_picture);
}

void UnfinishedSection::show_paintings(const std::vector<journal::Unfinished>& paintings) {
    delete shown_;
    pictures_of_.clear();
    shown_ = new QWidget;
    auto* column = section_column(shown_);
    auto* head = new QHBoxLayout;
    head->addWidget(heading(tr("Not closed last time")));
    head->addStretch(1);
    auto* all = new QPushButton(tr("Choose or discard..."));
    all->setObjectName(QStringLiteral("all_unfinished"));
    all->setToolTip(tr("All paintings that were left unfinished"));
    connect(all, &QPushButton::clicked, this, &UnfinishedSection::all_wanted);
    head->addWidget(all);
    column->addLayout(head);
    for (std::size_t i = 0; i < std::min(kMostRows, paintings.size()); ++i)
        column->addWidget(row(paintings[i]));
    rows_->addWidget(shown_);
    setVisible(!paintings.empty());
}

void UnfinishedSection::show_picture(const journal::Unfinished& painting) {
    const auto picture = pictures_of_.find(painting.folder);
    if (picture != pictures_of_.end())
        picture->second->setPixmap(
            dialogs::unfinished_picture(painting, kPicture_px, devicePixelRatioF()));
}

QWidget* UnfinishedSection::row(const journal::Unfinished& painting) {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(12);
    auto* picture = new QLabel;
    pictures_of_[painting.folder] = picture;
    show_picture(painting);
    pictures_.want(painting);
    layout->addWidget(picture);
    auto* words = new QLabel(dialogs::unfinished_words(painting));
    words->setToolTip(appearance::shown_message(painting.fault));
    layout->addWidget(words, 1);
    auto* recover = new QPushButton(tr("Recover"));
    recover->setObjectName(QStringLiteral("recover"));
    recover->setEnabled(painting.fault.empty());
    connect(recover, &QPushButton::clicked, this,
            [this, folder = painting.folder] { Q_EMIT wanted(folder); });
    layout->addWidget(recover);
    return row;
}

}  // namespace pastoso::start
