// Draws the tiles of a gallery: a picture, a name, and small words below it.
#pragma once

#include <QStyledItemDelegate>

namespace pastoso::panels {

class GalleryDelegate : public QStyledItemDelegate {
    Q_OBJECT
  public:
    /// What a tile holds besides its name (Qt::DisplayRole), picture (Qt::DecorationRole, a QPixmap) and
    /// hint (Qt::ToolTipRole).
    enum Role {
        kDetail = Qt::UserRole,  ///< QString, its lines apart
        kFaint,                  ///< bool: it cannot be had now
        kRemovable,              ///< bool: it has a cross to remove it
    };

    GalleryDelegate(const QSize& picture, int detail_lines, QObject* parent);

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

    /// Where the cross of a tile is.
    static QRect cross(const QRect& tile);

  private:
    void paint_picture(QPainter& painter, const QStyleOptionViewItem& option,
                       const QModelIndex& index) const;
    void paint_words(QPainter& painter, const QStyleOptionViewItem& option,
                     const QModelIndex& index) const;

    QSize picture_;  ///< the room for it
    int detail_lines_;
};

}  // namespace pastoso::panels
