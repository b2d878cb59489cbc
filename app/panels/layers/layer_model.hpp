// The layers of a painting as a tree for Qt's views: groups hold their layers, the uppermost first.
#pragma once

#include "tools/layer_list.hpp"

#include <map>
#include <vector>

#include <QAbstractItemModel>
#include <QImage>

namespace pastoso::panels {

class LayerModel : public QAbstractItemModel {
    Q_OBJECT
  public:
    enum Column { kEye, kName, kBare, kLock, kColumns };

    /// What is shown of a row.
    struct Item {
        bool is_group = false;
        document::LayerLook look{};  ///< what it says itself
        bool active = false;
        bool inactive_wet = false;  ///< its wet paint waits until it is active
        bool seen = true;           ///< with what its group says, and what it is clipped to
        bool has_base = false;      ///< it is clipped, and there is what it is clipped to
        bool group_locked = false, group_bare_locked = false;  ///< what its group says
        int layers = 0;  ///< of a group
    };

    using QAbstractItemModel::QAbstractItemModel;

    /// A change of anything but looks and the active layer resets the model.
    void show(const document::LayerStack& stack);
    void set_picture(document::LayerId layer, const QImage& picture, bool wet);
    void forget_pictures();

    const document::LayerStack& stack() const { return stack_; }
    tools::LayerRow row_at(const QModelIndex& index) const;  ///< of an invalid index: none of either
    QModelIndex index_of(const tools::LayerRow& row, Column column = kName) const;
    Item item(const QModelIndex& index) const;
    QImage picture(const QModelIndex& index) const;

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& index) const override;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
    QStringList mimeTypes() const override;
    QMimeData* mimeData(const QModelIndexList& indexes) const override;
    bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                      const QModelIndex& parent) override;

  Q_SIGNALS:
    // What the painter asks for; nothing is changed here.
    void renamed(const tools::LayerRow& row, const QString& name);
    void dropped(const tools::LayerRow& row, const tools::LayerGap& gap);

  private:
    struct Picture {
        QImage image;
        bool wet = false;
    };

    QString words(const Item& item) const;

    document::LayerStack stack_;
    std::vector<tools::LayerEntry> entries_;
    std::map<document::LayerId, Picture> pictures_;
};

}  // namespace pastoso::panels
