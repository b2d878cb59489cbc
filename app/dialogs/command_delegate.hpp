// One line for a command: its words, where it stands in the menus, and its keys at the right.
#pragma once

#include <QStyledItemDelegate>

namespace pastoso::dialogs {

class CommandDelegate : public QStyledItemDelegate {
    Q_OBJECT
  public:
    /// In pixels, of words in that font.
    static int row_height(const QFontMetrics& metrics);

    /// Of the model; the words are its display role. A row that is not enabled is drawn faint.
    enum Role { kCommand = Qt::UserRole + 1, kMenu, kKeys, kChecked, kHint, kOffer };

    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace pastoso::dialogs
