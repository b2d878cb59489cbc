#include "dialogs/keys_column.hpp"

#include "dialogs/key_cap.hpp"

#include <QPainter>

namespace pastoso::dialogs {
namespace {

constexpr int kAround = 11, kGap = 5;

}  // namespace

void KeysColumn::paint(QPainter* painter, const QStyleOptionViewItem& option,
                       const QModelIndex& index) const {
    QStyledItemDelegate::paint(painter, option, index);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const QStringList keys = index.data().toString().split(QStringLiteral("; "), Qt::SkipEmptyParts);
    int left = option.rect.left() + kGap;
    for (const QString& key : keys) {
        draw_key_cap(*painter, key, option.rect, left, false);
        left += key_cap_width(painter->fontMetrics(), key, option.rect) + kGap;
    }
    painter->restore();
}

void KeysColumn::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
    QStyledItemDelegate::initStyleOption(option, index);
    option->text.clear();
}

QSize KeysColumn::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
    return {0, option.fontMetrics.height() + kAround};
}

}  // namespace pastoso::dialogs
