#include "panels/layers/layer_tree.hpp"

#include "appearance/icon.hpp"
#include "appearance/theme.hpp"
#include "panels/layers/layer_delegate.hpp"
#include "panels/parts/section.hpp"

#include <algorithm>
#include <utility>

#include <QApplication>
#include <QDrag>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

namespace pastoso::panels {
namespace {

constexpr int kDraggedWidth = 150;
constexpr int kBesidePointer = 12;

}  // namespace

LayerTree::LayerTree(QWidget* parent) : QTreeView(parent) {
    setModel(&model_);
    setItemDelegate(new LayerDelegate(&model_, this));
    setTreePosition(LayerModel::kName);
    setHeaderHidden(true);
    setIndentation(14);
    setExpandsOnDoubleClick(false);
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setDragDropMode(QAbstractItemView::DragDrop);
    setDefaultDropAction(Qt::MoveAction);
    setAllColumnsShowFocus(true);
    header()->setStretchLastSection(false);
    header()->setMinimumSectionSize(kLayerIconColumn);
    header()->setSectionResizeMode(QHeaderView::Fixed);
    header()->setSectionResizeMode(LayerModel::kName, QHeaderView::Stretch);
    header()->resizeSection(LayerModel::kEye, kLayerIconColumn);
    header()->resizeSection(LayerModel::kBare, kLayerIconColumn);
    header()->resizeSection(LayerModel::kLock, kLayerIconColumn);
    keep_keys_for_canvas(this);
    keep_own_keys(this, {Qt::Key_F2, Qt::Key_Space, Qt::Key_Backspace});
    connect(this, &QTreeView::collapsed, this,
            [this](const QModelIndex& index) { folded_.insert(model_.row_at(index).group); });
    connect(this, &QTreeView::expanded, this,
            [this](const QModelIndex& index) { folded_.erase(model_.row_at(index).group); });
    connect(&model_, &QAbstractItemModel::modelReset, this, &LayerTree::unfold);
}

/// To a row as high as the view Qt does not scroll down.
QSize LayerTree::minimumSizeHint() const {
    constexpr int kHigher_px = 2;
    return {QTreeView::minimumSizeHint().width(), kLayerRow + kHigher_px + 2 * frameWidth()};
}

QSize LayerTree::sizeHint() const {
    constexpr int kFewestRows = 2;
    return {QTreeView::sizeHint().width(),
            std::max(kFewestRows, shown_rows()) * kLayerRow + 2 * frameWidth()};
}

int LayerTree::shown_rows() const {
    int rows = model_.rowCount();
    for (int entry = 0; entry < model_.rowCount(); ++entry) {
        const QModelIndex index = model_.index(entry, 0);
        if (isExpanded(index)) rows += model_.rowCount(index);
    }
    return rows;
}

/// Groups stand open unless the painter has folded them.
void LayerTree::unfold() {
    for (int entry = 0; entry < model_.rowCount(); ++entry) {
        const QModelIndex index = model_.index(entry, 0);
        setExpanded(index, !folded_.contains(model_.row_at(index).group));
    }
    updateGeometry();
}

void LayerTree::show(const document::LayerStack& stack, const tools::LayerRow& chosen) {
    showing_ = true;
    model_.show(stack);
    if (current() != chosen) {
        setCurrentIndex(model_.index_of(chosen));
        scrollTo(currentIndex());
    }
    showing_ = false;
}

std::vector<tools::LayerRow> LayerTree::selected() const {
    std::vector<tools::LayerRow> rows;
    for (const QModelIndex& index : selectionModel()->selectedRows())
        rows.push_back(model_.row_at(index));
    return rows;
}

void LayerTree::edit_name(const tools::LayerRow& row) {
    const QModelIndex index = model_.index_of(row);
    scrollTo(index);
    edit(index, AllEditTriggers, nullptr);
}

void LayerTree::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
    QTreeView::currentChanged(current, previous);
    if (!showing_ && current.isValid()) Q_EMIT chosen(model_.row_at(current));
}

// ---- keys

void LayerTree::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space && currentIndex().isValid())
        Q_EMIT eye_clicked(current());
    else if (event->key() == Qt::Key_F2 && currentIndex().isValid())
        edit_name(current());
    else
        QTreeView::keyPressEvent(event);
}

/// Once the name is there, the keys belong again to what they belonged to before.
bool LayerTree::edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) {
    QWidget* before = QApplication::focusWidget();
    const bool edits = QTreeView::edit(index, trigger, event);
    if (edits && state() == EditingState) focus_before_ = before;
    return edits;
}

void LayerTree::closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) {
    QTreeView::closeEditor(editor, hint);
    if (focus_before_ != nullptr) std::exchange(focus_before_, nullptr)->setFocus();
}

// ---- mouse

/// A click on the eye or a lock does not choose the row.
bool LayerTree::click_icon(const QMouseEvent& event) {
    const QModelIndex index = indexAt(event.position().toPoint());
    if (event.button() != Qt::LeftButton || !index.isValid()) return false;
    if (index.column() == LayerModel::kEye) Q_EMIT eye_clicked(model_.row_at(index));
    if (index.column() == LayerModel::kBare) Q_EMIT bare_clicked(model_.row_at(index));
    if (index.column() == LayerModel::kLock) Q_EMIT lock_clicked(model_.row_at(index));
    return icon_pressed_ = index.column() != LayerModel::kName;
}

void LayerTree::mousePressEvent(QMouseEvent* event) {
    if (!click_icon(*event)) QTreeView::mousePressEvent(event);
}

/// Nor does a hand that trembles on them.
void LayerTree::mouseMoveEvent(QMouseEvent* event) {
    if (!icon_pressed_) QTreeView::mouseMoveEvent(event);
}

void LayerTree::mouseReleaseEvent(QMouseEvent* event) {
    if (!std::exchange(icon_pressed_, false)) QTreeView::mouseReleaseEvent(event);
}

void LayerTree::mouseDoubleClickEvent(QMouseEvent* event) {
    if (!click_icon(*event)) QTreeView::mouseDoubleClickEvent(event);
}

/// On the row's own colour, an arrow that a click folds and unfolds.
void LayerTree::drawBranches(QPainter* painter, const QRect& place, const QModelIndex& index) const {
    const bool chosen = selectionModel()->isRowSelected(index.row(), index.parent());
    if (chosen) painter->fillRect(place, appearance::colours().chosen);
    if (model_.row_at(index).group == 0) return;
    const QRectF box(place.right() - indentation(), place.top(), indentation(), place.height());
    appearance::draw_icon(*painter, box,
                          isExpanded(index) ? QStringLiteral("unfolded") : QStringLiteral("folded"),
                          palette().color(QPalette::Text));
}

/// The picture and the beginning of the name, beside the pointer, so that the gap that it is dragged to
/// is seen.
QPixmap LayerTree::dragged_picture(const QModelIndex& index) {
    QRect place = visualRect(index.siblingAtColumn(LayerModel::kName));
    place.setWidth(std::min(place.width(), kDraggedWidth));
    const QPixmap row = viewport()->grab(place);
    QPixmap faint(row.size());
    faint.setDevicePixelRatio(row.devicePixelRatio());
    faint.fill(Qt::transparent);
    QPainter painter(&faint);
    painter.setOpacity(0.75);
    painter.drawPixmap(0, 0, row);
    return faint;
}

std::unique_ptr<QMimeData> LayerTree::dragged(const QModelIndex& index) const {
    std::unique_ptr<QMimeData> row(model_.mimeData({index}));
    std::unique_ptr<QMimeData> carried(carried_ ? carried_(model_.row_at(index)) : nullptr);
    if (carried == nullptr) return row;
    for (const QString& format : row->formats())
        carried->setData(format, row->data(format));
    return carried;
}

/// Of several chosen rows the one that is grabbed is dragged.
void LayerTree::startDrag(Qt::DropActions actions) {
    const QModelIndex grabbed = currentIndex();
    selectionModel()->select(grabbed, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    auto* drag = new QDrag(this);
    drag->setMimeData(dragged(grabbed).release());
    drag->setPixmap(dragged_picture(grabbed));
    drag->setHotSpot({-kBesidePointer, -kBesidePointer});
    drag->exec(actions | Qt::CopyAction, Qt::MoveAction);
}

/// Just below the name of an open group is the uppermost place in it, where the line is drawn; Qt takes
/// it for the place below the group.
void LayerTree::dropEvent(QDropEvent* event) {
    const QModelIndex there = indexAt(event->position().toPoint()).siblingAtColumn(0);
    const bool below_name = dropIndicatorPosition() == BelowItem && isExpanded(there);
    if (!below_name || model_.row_at(there).group == 0) return QTreeView::dropEvent(event);
    model_.dropMimeData(event->mimeData(), event->dropAction(), 0, 0, there);
    event->accept();
    stopAutoScroll();
    setState(NoState);
    viewport()->update();
}

}  // namespace pastoso::panels
