#include "panels/paint/paint_panel.hpp"

#include "panels/paint/swatch_colours.hpp"
#include "panels/parts/section.hpp"

#include <QListWidget>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

constexpr QSize kSwatch(34, 18);

}  // namespace

/// Two thirds paint from the tube, one third tint.
QIcon PaintPanel::icon_of(const Colours& colours, double pixel_ratio) {
    QPixmap pixmap(kSwatch * pixel_ratio);
    pixmap.setDevicePixelRatio(pixel_ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath outline;
    outline.addRoundedRect(QRectF(QPointF(0.5, 0.5), kSwatch - QSize(1, 1)), 3.0, 3.0);
    painter.setClipPath(outline);
    painter.fillRect(0, 0, 23, kSwatch.height(), qcolor(colours.paint));
    painter.fillRect(23, 0, kSwatch.width() - 23, kSwatch.height(), qcolor(colours.tint));
    painter.setClipping(false);
    painter.strokePath(outline, QPen(QColor(0, 0, 0, 120)));
    QIcon icon;
    // The same picture when selected: a highlight must not change what the paint looks like.
    icon.addPixmap(pixmap, QIcon::Normal);
    icon.addPixmap(pixmap, QIcon::Selected);
    return icon;
}

PaintPanel::PaintPanel(const std::vector<PaintEntry>& paints, QWidget* parent)
    : QWidget(parent), list_(new QListWidget), shown_(paints.size()) {
    list_->setObjectName(QStringLiteral("paints"));
    list_->setAccessibleName(tr("Paint"));
    list_->setIconSize(kSwatch);
    list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setTextElideMode(Qt::ElideRight);
    keep_keys_for_canvas(list_);
    for (const PaintEntry& paint : paints) {
        auto* item = new QListWidgetItem(paint.name, list_);
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

void PaintPanel::show_swatches(const tools::SwatchView& view) {
    for (int row = 0; row < list_->count(); ++row) {
        QListWidgetItem* item = list_->item(row);
        const std::string tube = item->data(Qt::UserRole).toString().toStdString();
        const Colours colours{tools::swatch_colour(tools::tube_paint(tube), view),
                              tools::swatch_colour(tools::tube_tint(tube), view)};
        Colours& shown = shown_[static_cast<std::size_t>(row)];
        if (colours == shown && !item->icon().isNull()) continue;
        shown = colours;
        item->setIcon(icon_of(colours, devicePixelRatioF()));
    }
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
