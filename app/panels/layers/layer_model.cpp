#include "panels/layers/layer_model.hpp"

#include "appearance/shown_names.hpp"

#include <algorithm>
#include <utility>

#include <QCoreApplication>
#include <QDataStream>
#include <QIODevice>
#include <QMimeData>

namespace pastoso::panels {
namespace {

using tools::LayerRow;

constexpr const char* kMimeType = "application/x-pastoso-layer";

/// Indexes of a group's layers carry the number of its entry, others this.
constexpr quintptr kNoEntry = ~quintptr{0};

}  // namespace

void LayerModel::show(const document::LayerStack& stack) {
    std::vector<tools::LayerEntry> entries = tools::layer_entries(stack);
    const bool other_rows = entries != entries_;
    if (other_rows) beginResetModel();
    stack_ = stack;
    entries_ = std::move(entries);
    if (other_rows) return endResetModel();
    const auto tell = [this](int rows, const QModelIndex& parent) {
        if (rows > 0) Q_EMIT dataChanged(index(0, 0, parent), index(rows - 1, kColumns - 1, parent));
    };
    tell(rowCount(), {});
    for (int row = 0; row < rowCount(); ++row)
        tell(rowCount(index(row, 0)), index(row, 0));
}

void LayerModel::set_picture(document::LayerId layer, const QImage& picture, bool wet) {
    pictures_[layer] = {picture, wet};
    const QModelIndex changed = index_of({.layer = layer}, kName);
    if (changed.isValid()) Q_EMIT dataChanged(changed, changed);
}

void LayerModel::forget_pictures() {
    pictures_.clear();
}

LayerRow LayerModel::row_at(const QModelIndex& index) const {
    if (!index.isValid()) return {};
    const auto row = static_cast<std::size_t>(index.row());
    if (index.internalId() == kNoEntry) return entries_[row].row;
    return {.layer = entries_[index.internalId()].children[row]};
}

QModelIndex LayerModel::index_of(const LayerRow& row, Column column) const {
    if (row == LayerRow{}) return {};
    for (int entry = 0; entry < rowCount(); ++entry) {
        const QModelIndex above = index(entry, 0);
        if (row_at(above) == row) return index(entry, column);
        for (int child = 0; child < rowCount(above); ++child)
            if (row_at(index(child, 0, above)) == row) return index(child, column, above);
    }
    return {};
}

LayerModel::Item LayerModel::item(const QModelIndex& index) const {
    const LayerRow row = row_at(index);
    Item item{.is_group = row.group != 0, .look = tools::look_of(stack_, row)};
    if (item.is_group) {
        item.seen = item.look.visible;
        item.layers = rowCount(index.siblingAtColumn(0));
        return item;
    }
    const std::size_t place = document::place_of(stack_, row.layer);
    item.active = place == stack_.active;
    item.seen = document::effective_look(stack_, place).visible;
    item.has_base = document::clipped_to(stack_, place).has_value();
    const auto picture = pictures_.find(row.layer);
    item.inactive_wet = !item.active && picture != pictures_.end() && picture->second.wet;
    if (!index.parent().isValid()) return item;
    const document::LayerLook group = tools::look_of(stack_, row_at(index.parent()));
    item.group_locked = group.locked;
    item.group_bare_locked = group.bare_locked;
    return item;
}

QImage LayerModel::picture(const QModelIndex& index) const {
    const auto found = pictures_.find(row_at(index).layer);
    return found == pictures_.end() ? QImage() : found->second.image;
}

QModelIndex LayerModel::index(int row, int column, const QModelIndex& parent) const {
    if (!hasIndex(row, column, parent)) return {};
    return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row()) : kNoEntry);
}

QModelIndex LayerModel::parent(const QModelIndex& index) const {
    if (!index.isValid() || index.internalId() == kNoEntry) return {};
    return createIndex(static_cast<int>(index.internalId()), 0, kNoEntry);
}

int LayerModel::rowCount(const QModelIndex& parent) const {
    if (!parent.isValid()) return static_cast<int>(entries_.size());
    if (parent.internalId() != kNoEntry || parent.column() != 0) return 0;
    return static_cast<int>(entries_[static_cast<std::size_t>(parent.row())].children.size());
}

int LayerModel::columnCount(const QModelIndex&) const {
    return kColumns;
}

QString LayerModel::words(const Item& item) const {
    QStringList words;
    if (item.is_group) words += tr("a group of %1").arg(item.layers);
    if (item.active) words += tr("the layer that you paint on");
    if (!item.look.visible) words += tr("hidden");
    if (item.look.locked) words += tr("locked");
    if (item.look.bare_locked) words += tr("what is bare is locked");
    if (item.has_base) words += tr("clipped to the layer below");
    words += tr("opacity %1 %").arg(qRound(100.0 * item.look.opacity));
    return words.join(QStringLiteral(", "));
}

QVariant LayerModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.column() != kName) return {};
    const Item shown = item(index);
    const QString name = appearance::shown_name(shown.look.name);
    switch (role) {
        case Qt::DisplayRole:
        case Qt::EditRole:
            return name;
        case Qt::AccessibleTextRole:
            return QStringLiteral("%1, %2").arg(name, words(shown));
        default:
            return {};
    }
}

bool LayerModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    const QString name = value.toString().trimmed();
    const bool fits =
        !name.isEmpty() && static_cast<std::size_t>(name.toUtf8().size()) <= document::kMostLayerName;
    if (role != Qt::EditRole || !index.isValid() || !fits || name == index.data(role)) return false;
    Q_EMIT renamed(row_at(index), name);
    return true;
}

/// Layers are dropped between rows; a group takes them in too.
Qt::ItemFlags LayerModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) return Qt::ItemIsDropEnabled;
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled;
    if (index.column() == kName) flags |= Qt::ItemIsEditable;
    if (row_at(index).group != 0) flags |= Qt::ItemIsDropEnabled;
    return flags;
}

QStringList LayerModel::mimeTypes() const {
    return {QString::fromLatin1(kMimeType)};
}

QMimeData* LayerModel::mimeData(const QModelIndexList& indexes) const {
    if (indexes.isEmpty()) return nullptr;
    const LayerRow row = row_at(indexes.front());
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream << QCoreApplication::applicationPid() << row.layer << row.group;
    auto* data = new QMimeData;
    data->setData(QString::fromLatin1(kMimeType), bytes);
    return data;
}

/// False: the view has nothing to remove, the list changes when the layers do.
bool LayerModel::dropMimeData(const QMimeData* data, Qt::DropAction, int row, int,
                              const QModelIndex& parent) {
    const QString format = QString::fromLatin1(kMimeType);
    if (data == nullptr || !data->hasFormat(format)) return false;
    QDataStream stream(data->data(format));
    qint64 program = 0;
    LayerRow moved;
    stream >> program >> moved.layer >> moved.group;
    const bool ours = program == QCoreApplication::applicationPid();
    if (!ours || !index_of(moved).isValid()) return false;
    const document::GroupId group = row_at(parent).group;
    const int lowest = group != 0 ? 0 : rowCount();
    Q_EMIT dropped(moved, {group, row < 0 ? lowest : row});
    return false;
}

}  // namespace pastoso::panels
