// Keys in a table, each drawn as the cap of one.
#pragma once

#include <QStyledItemDelegate>

namespace pastoso::dialogs {

class KeysColumn : public QStyledItemDelegate {
    Q_OBJECT
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    /// The text is that of QKeySequence::listToString().
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

  protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

}  // namespace pastoso::dialogs
