#include "panels/parts/choice_list.hpp"

#include "panels/parts/section.hpp"

#include <algorithm>

#include <QKeyEvent>
#include <QScrollBar>
#include <QStyledItemDelegate>

namespace pastoso::panels {
namespace {

/// So much of a row's width is not for words and picture: the style sheet's edges of an entry.
constexpr int kRowEdges_px = 8;

/// How far an arrow moves an entry, in rows as in grids.
int places_on(int key) {
    if (key == Qt::Key_Up || key == Qt::Key_Left) return -1;
    return key == Qt::Key_Down || key == Qt::Key_Right ? 1 : 0;
}

bool removes(const QKeyEvent& event) {
    return (event.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier &&
           (event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace);
}

/// A row as high as its words are in the width of the list.
class WrappedRow : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const auto* list = qobject_cast<const QListView*>(option.widget);
        QStyleOptionViewItem row = option;
        if (list != nullptr)
            row.rect = QRect(0, 0, std::max(1, list->viewport()->width() - kRowEdges_px), 1);
        return QStyledItemDelegate::sizeHint(row, index);
    }
};

}  // namespace

ChoiceList::ChoiceList(QWidget* parent) : QListWidget(parent) {
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setWordWrap(true);
    setResizeMode(QListView::Adjust);
    setItemDelegate(new WrappedRow(this));
    take_keys_of_list(this);
    // What is chosen stays in view when the list becomes lower or its rows higher.
    connect(verticalScrollBar(), &QScrollBar::rangeChanged, this,
            [this] { scrollToItem(currentItem()); });
    connect(this, &QListWidget::itemClicked, this, &ChoiceList::taken);
    connect(this, &QListWidget::itemActivated, this, &ChoiceList::taken);
}

void ChoiceList::let_arrange() {
    setDragDropMode(QAbstractItemView::InternalMove);
    setDefaultDropAction(Qt::MoveAction);
    keep_own_keys(this, {Qt::ALT | Qt::Key_Up, Qt::ALT | Qt::Key_Down, Qt::ALT | Qt::Key_Left,
                         Qt::ALT | Qt::Key_Right});
}

void ChoiceList::dropEvent(QDropEvent* event) {
    QListWidget::dropEvent(event);
    Q_EMIT arranged();
}

void ChoiceList::move_current(int rows) {
    const int from = currentRow(), to = from + rows;
    if (from < 0 || to < 0 || to >= count()) return;
    QListWidgetItem* moved = takeItem(from);
    insertItem(to, moved);
    setCurrentItem(moved);
    scrollToItem(moved);
    Q_EMIT arranged();
}

void ChoiceList::keyPressEvent(QKeyEvent* event) {
    const bool moves = event->modifiers().testFlag(Qt::AltModifier) &&
                       dragDropMode() == QAbstractItemView::InternalMove;
    if (moves && places_on(event->key()) != 0) return move_current(places_on(event->key()));
    if (removes(*event)) {
        if (currentItem() != nullptr) Q_EMIT removal_wanted(currentItem());
        return;
    }
    const QListWidgetItem* before = currentItem();
    QListWidget::keyPressEvent(event);
    if (currentItem() != nullptr && currentItem() != before) Q_EMIT taken(currentItem());
}

}  // namespace pastoso::panels
