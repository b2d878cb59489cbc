// Draws the rows of the list of layers, and says in tool tips what their parts mean.
#pragma once

#include "panels/layers/layer_model.hpp"

#include <QColor>
#include <QStyledItemDelegate>

namespace pastoso::panels {

/// Room for a layer's picture, in pixels of the layout.
inline constexpr QSize kLayerPicture(52, 36);
inline constexpr int kLayerIconColumn = 26;
inline constexpr int kLayerRow = 44;  ///< how high one is

class LayerDelegate : public QStyledItemDelegate {
    Q_OBJECT
  public:
    LayerDelegate(const LayerModel* model, QObject* parent);

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    /// Only once: what is typed stays when the row changes meanwhile, a picture of the paint that has
    /// run for example.
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;
    bool helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                   const QModelIndex& index) override;

  private:
    void paint_eye(QPainter* painter, const QRect& place, const LayerModel::Item& item) const;
    void paint_name(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index,
                    const LayerModel::Item& item) const;

    struct Lock {
        const char *closed, *open;  ///< names of its icons
        bool own, of_group;         ///< whether the row is locked itself, or its group is
    };
    void paint_lock(QPainter* painter, const QStyleOptionViewItem& option, const Lock& lock) const;

    const LayerModel* model_;
};

}  // namespace pastoso::panels
