#include "dialogs/command_delegate.hpp"

#include "appearance/theme.hpp"
#include "dialogs/key_cap.hpp"

#include <algorithm>

#include <QApplication>
#include <QPainter>

namespace pastoso::dialogs {
namespace {

constexpr int kMargin = 9, kCapGap = 5;

}  // namespace

void CommandDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const {
    QStyleOptionViewItem line = option;
    initStyleOption(&line, index);
    line.text.clear();
    const QWidget* widget = option.widget;
    (widget != nullptr ? widget->style() : QApplication::style())
        ->drawControl(QStyle::CE_ItemViewItem, &line, painter, widget);

    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const bool enabled = index.flags().testFlag(Qt::ItemIsEnabled);
    const bool chosen = option.state.testFlag(QStyle::State_Selected);
    const appearance::ThemeColours& colours = appearance::colours();
    const QRect row = option.rect.adjusted(kMargin, 0, -kMargin, 0);
    int right = row.right();
    QStringList keys = index.data(kKeys).toString().split(QStringLiteral("; "), Qt::SkipEmptyParts);
    std::reverse(keys.begin(), keys.end());
    for (const QString& key : keys) {
        right -= key_cap_width(painter->fontMetrics(), key, row);
        draw_key_cap(*painter, key, row, right, !enabled);
        right -= kCapGap;
    }

    const QString mark = index.data(kChecked).toBool() ? QStringLiteral("✓  ") : QString();
    const QString words = mark + index.data(Qt::DisplayRole).toString();
    painter->setPen(!enabled ? colours.faint_text : chosen ? colours.chosen_text : colours.text);
    painter->drawText(row, Qt::AlignVCenter | Qt::AlignLeft, words);
    const int words_end = row.left() + painter->fontMetrics().horizontalAdvance(words) + 12;
    painter->setPen(chosen && enabled ? colours.chosen_text : colours.quiet_text);
    painter->drawText(QRect(QPoint(words_end, row.top()), QPoint(right - kCapGap, row.bottom())),
                      Qt::AlignVCenter | Qt::AlignLeft, index.data(kMenu).toString());
    painter->restore();
}

int CommandDelegate::row_height(const QFontMetrics& metrics) {
    constexpr int kAround = 13;
    return metrics.height() + kAround;
}

QSize CommandDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
    return {0, row_height(option.fontMetrics)};
}

}  // namespace pastoso::dialogs
