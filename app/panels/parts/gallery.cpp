#include "panels/parts/gallery.hpp"

#include "panels/parts/gallery_delegate.hpp"

#include <algorithm>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QStandardItemModel>

namespace pastoso::panels {
namespace {

void fill(QStandardItem& item, const Tile& tile) {
    item.setText(tile.name);
    item.setToolTip(tile.hint);
    item.setData(tile.picture, Qt::DecorationRole);
    item.setData(tile.detail, GalleryDelegate::kDetail);
    item.setData(tile.faint, GalleryDelegate::kFaint);
    item.setData(tile.removable, GalleryDelegate::kRemovable);
    item.setData(QStringLiteral("%1, %2").arg(tile.name, tile.detail), Qt::AccessibleTextRole);
}

}  // namespace

Gallery::Gallery(const QSize& picture, int detail_lines, QWidget* parent)
    : QListView(parent), model_(new QStandardItemModel(this)) {
    setModel(model_);
    setItemDelegate(new GalleryDelegate(picture, detail_lines, this));
    setViewMode(QListView::IconMode);
    setMovement(QListView::Static);
    setResizeMode(QListView::Adjust);
    setUniformItemSizes(true);
    setSelectionMode(QAbstractItemView::NoSelection);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setMouseTracking(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setTabKeyNavigation(false);
    setStyleSheet(QStringLiteral("QListView { background: transparent; border: none; padding: 0px; }"));
}

void Gallery::show_tiles(const std::vector<Tile>& tiles) {
    model_->clear();
    for (const Tile& tile : tiles) {
        auto* item = new QStandardItem;
        fill(*item, tile);
        model_->appendRow(item);
    }
}

void Gallery::show_tile(int number, const Tile& tile) {
    if (QStandardItem* item = model_->item(number)) fill(*item, tile);
}

int Gallery::count() const {
    return model_->rowCount();
}

/// The tiles share the width evenly, so that their columns stand in line with the edges.
void Gallery::fit(int width) {
    const QSize tile = itemDelegate()->sizeHint(
        [this] {
            QStyleOptionViewItem option;
            initViewItemOption(&option);
            return option;
        }(),
        {});
    // Tiles that fill the width to the last pixel would break into one row more.
    constexpr int kSlack_px = 8;
    const int columns = std::max(1, (width - kSlack_px) / tile.width());
    const int rows = (count() + columns - 1) / columns;
    setGridSize({(width - kSlack_px) / columns, tile.height()});
    setFixedHeight(std::max(1, rows) * tile.height() + 2);
}

QPoint Gallery::middle(int number) const {
    return visualRect(model_->index(number, 0)).center();
}

void Gallery::mouseReleaseEvent(QMouseEvent* event) {
    const QModelIndex tile = indexAt(event->position().toPoint());
    QListView::mouseReleaseEvent(event);
    if (event->button() != Qt::LeftButton || !tile.isValid() || tile != currentIndex()) return;
    const QRect cross = GalleryDelegate::cross(visualRect(tile));
    const bool removes =
        tile.data(GalleryDelegate::kRemovable).toBool() && cross.contains(event->position().toPoint());
    if (removes)
        Q_EMIT removal_wanted(tile.row());
    else
        Q_EMIT chosen(tile.row());
}

void Gallery::keyPressEvent(QKeyEvent* event) {
    if (!take_key(event->key())) QListView::keyPressEvent(event);
}

bool Gallery::take_key(int key) {
    const QModelIndex tile = currentIndex();
    if (!tile.isValid()) return false;
    if (key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Space) {
        Q_EMIT chosen(tile.row());
        return true;
    }
    if (key == Qt::Key_Delete && tile.data(GalleryDelegate::kRemovable).toBool()) {
        Q_EMIT removal_wanted(tile.row());
        return true;
    }
    return false;
}

/// Whoever comes by keys sees where they are.
void Gallery::focusInEvent(QFocusEvent* event) {
    QListView::focusInEvent(event);
    if (!currentIndex().isValid() && count() > 0) setCurrentIndex(model_->index(0, 0));
}

}  // namespace pastoso::panels
