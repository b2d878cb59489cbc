#include "panels/paint/paint_panel.hpp"

#include "panels/parts/section.hpp"

#include <QIcon>
#include <QListWidget>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

constexpr QSize kSwatch(34, 18);

/// Two thirds paint from the tube, one third tint.
QIcon swatch_icon(const PaintEntry& paint, double pixel_ratio) {
    QPixmap pixmap(kSwatch * pixel_ratio);
    pixmap.setDevicePixelRatio(pixel_ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath outline;
    outline.addRoundedRect(QRectF(QPointF(0.5, 0.5), kSwatch - QSize(1, 1)), 3.0, 3.0);
    painter.setClipPath(outline);
    painter.fillRect(0, 0, 23, kSwatch.height(), paint.masstone);
    painter.fillRect(23, 0, kSwatch.width() - 23, kSwatch.height(), paint.tint);
    painter.setClipping(false);
    painter.strokePath(outline, QPen(QColor(0, 0, 0, 120)));
    QIcon icon;
    // The same picture when selected: a highlight must not change what the paint looks like.
    icon.addPixmap(pixmap, QIcon::Normal);
    icon.addPixmap(pixmap, QIcon::Selected);
    return icon;
}

}  // namespace

PaintPanel::PaintPanel(const std::vector<PaintEntry>& paints, QWidget* parent)
    : QWidget(parent), list_(new QListWidget) {
    list_->setObjectName(QStringLiteral("paints"));
    list_->setAccessibleName(tr("Paint"));
    list_->setIconSize(kSwatch);
    list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setTextElideMode(Qt::ElideRight);
    keep_keys_for_canvas(list_);
    for (const PaintEntry& paint : paints) {
        auto* item = new QListWidgetItem(swatch_icon(paint, devicePixelRatioF()), paint.name, list_);
        item->setData(Qt::UserRole, paint.pigment);
        item->setToolTip(
            paint.pigment.isEmpty()
                ? tr("The medium without pigment, for example thinner")
                : tr("%1 (%2): from the tube, and mixed with white").arg(paint.name, paint.pigment));
    }
    const auto choose = [this](QListWidgetItem* item) {
        Q_EMIT paint_chosen(item->data(Qt::UserRole).toString());
    };
    connect(list_, &QListWidget::itemClicked, this, choose);
    connect(list_, &QListWidget::itemActivated, this, choose);
    section(this, tr("Paint"))->addWidget(list_);
}

void PaintPanel::show_paint(const QString& pigment) {
    list_->setCurrentItem(nullptr);
    for (int row = 0; row < list_->count(); ++row) {
        if (list_->item(row)->data(Qt::UserRole).toString() != pigment) continue;
        list_->setCurrentRow(row);
        list_->scrollToItem(list_->item(row));
    }
}

}  // namespace pastoso::panels
