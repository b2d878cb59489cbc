#include "panels/history/history_panel.hpp"

#include "panels/history/history_model.hpp"
#include "panels/parts/section.hpp"

#include <cmath>

#include <QLabel>
#include <QListView>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

/// What was done, and faintly at the right with what; undone steps are faint altogether.
class StepDelegate : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        QStyleOptionViewItem item = option;
        initStyleOption(&item, index);
        const QString words = std::exchange(item.text, QString());
        option.widget->style()->drawControl(QStyle::CE_ItemViewItem, &item, painter, option.widget);
        constexpr int kMargin = 6;
        constexpr double kFaint = 0.55;
        const QRect room = option.rect.adjusted(kMargin, 0, -kMargin, 0);
        const bool undone = index.data(HistoryModel::kUndoneRole).toBool();
        painter->save();
        painter->setFont(item.font);
        painter->setPen(item.palette.color(QPalette::Text));
        painter->setOpacity(undone ? kFaint : 1.0);
        painter->drawText(room, Qt::AlignLeft | Qt::AlignVCenter, words);
        const int taken = item.fontMetrics.horizontalAdvance(words) + 2 * kMargin;
        const QString detail = item.fontMetrics.elidedText(
            index.data(HistoryModel::kDetailRole).toString(), Qt::ElideRight, room.width() - taken);
        painter->setOpacity(undone ? kFaint * kFaint : kFaint);
        painter->drawText(room, Qt::AlignRight | Qt::AlignVCenter, detail);
        painter->restore();
    }
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override {
        return {0, option.fontMetrics.height() + 8};
    }
};

double mebibytes(const std::vector<document::KeptStep>& steps) {
    double bytes = 0.0;
    for (const document::KeptStep& step : steps)
        bytes += static_cast<double>(step.bytes);
    return bytes / (1 << 20);
}

}  // namespace

HistoryPanel::HistoryPanel(QWidget* parent)
    : QWidget(parent), model_(new HistoryModel(this)), list_(new QListView), memory_(new QLabel) {
    list_->setObjectName(QStringLiteral("history_list"));
    list_->setAccessibleName(tr("What was done"));
    list_->setModel(model_);
    list_->setItemDelegate(new StepDelegate(list_));
    list_->setUniformItemSizes(true);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    take_keys_of_list(list_);
    memory_->setObjectName(QStringLiteral("reading"));
    memory_->setToolTip(
        tr("What the steps take; \"Memory for undo\" in the Edit menu says how much "
           "they may"));
    auto* column = new QVBoxLayout(this);
    column->setSpacing(6);
    column->addWidget(list_, 1);
    column->addWidget(memory_);
    const auto go = [this](const QModelIndex& index) {
        const int back = model_->present_row() - index.row();
        if (back != 0) Q_EMIT steps_back(back);
    };
    connect(list_, &QListView::clicked, this, go);
    connect(list_, &QListView::activated, this, go);
}

void HistoryPanel::show_steps(const session::Steps& steps, int budget_MiB) {
    model_->show(steps);
    const QModelIndex present = model_->index(model_->present_row());
    list_->setCurrentIndex(present);
    list_->scrollTo(present);
    memory_->setText(tr("%1 of %2 MB")
                         .arg(std::lround(mebibytes(steps.past) + mebibytes(steps.future)))
                         .arg(budget_MiB));
}

}  // namespace pastoso::panels
