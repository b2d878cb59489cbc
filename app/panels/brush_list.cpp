#include "panels/brush_list.hpp"

#include <QPixmap>
#include <QScrollBar>

namespace pastoso::panels {
namespace {

constexpr int kEntryRole = Qt::UserRole;
constexpr int kNoEntry = -1;

int entry_of(const QListWidgetItem* item) {
    return item == nullptr ? kNoEntry : item->data(kEntryRole).toInt();
}

}  // namespace

BrushList::BrushList(const std::vector<BrushEntry>& entries, QWidget* parent)
    : QListWidget(parent), asked_(entries.size(), false) {
    setIconSize(kThumbnailSize);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setTextElideMode(Qt::ElideRight);
    QPixmap empty(kThumbnailSize);
    empty.fill(Qt::transparent);
    QString family;
    for (const BrushEntry& entry : entries) {
        if (entry.family != family) add_heading(family = entry.family);
        auto* item = new QListWidgetItem(QIcon(empty), entry.name, this);
        item->setData(kEntryRole, static_cast<int>(items_.size()));
        item->setToolTip(entry.name);
        items_.push_back(item);
    }
    connect(this, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) {
        if (entry_of(item) != kNoEntry) Q_EMIT entry_clicked(entry_of(item));
    });
    connect(verticalScrollBar(), &QScrollBar::valueChanged, this, &BrushList::ask_for_thumbnails);
}

void BrushList::add_heading(const QString& family) {
    auto* heading = new QListWidgetItem(family, this);
    heading->setData(kEntryRole, kNoEntry);
    heading->setFlags(Qt::NoItemFlags);
}

void BrushList::show_entry(int entry) {
    if (entry < 0 || entry >= static_cast<int>(items_.size())) return;
    setCurrentItem(items_[static_cast<std::size_t>(entry)]);
    scrollToItem(currentItem());
}

int BrushList::current_entry() const {
    return entry_of(currentItem());
}

void BrushList::set_thumbnail(int entry, const QImage& image) {
    items_.at(static_cast<std::size_t>(entry))->setIcon(QIcon(QPixmap::fromImage(image)));
}

void BrushList::showEvent(QShowEvent* event) {
    QListWidget::showEvent(event);
    ask_for_thumbnails();
}

void BrushList::resizeEvent(QResizeEvent* event) {
    QListWidget::resizeEvent(event);
    ask_for_thumbnails();
}

void BrushList::ask_for_thumbnails() {
    if (!isVisible()) return;
    for (std::size_t entry = 0; entry < items_.size(); ++entry) {
        if (asked_[entry] || !viewport()->rect().intersects(visualItemRect(items_[entry]))) continue;
        asked_[entry] = true;
        Q_EMIT thumbnail_wanted(static_cast<int>(entry));
    }
}

}  // namespace pastoso::panels
