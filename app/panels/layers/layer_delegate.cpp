#include "panels/layers/layer_delegate.hpp"

#include "appearance/icon.hpp"
#include "appearance/screen_colours.hpp"
#include "appearance/shown_names.hpp"
#include "appearance/theme.hpp"

#include <QAbstractItemView>
#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

namespace pastoso::panels {
namespace {

using Item = LayerModel::Item;

constexpr int kGap = 6;
constexpr int kGroupRow = 30;
constexpr int kClipMark = 16;

/// Clipped layers stand a little to the right of the one that they are clipped to, behind a mark.
int mark_of(const Item& item) {
    return item.look.clipped ? kClipMark : 0;
}

int indent_of(const Item& item) {
    return mark_of(item) + (item.is_group ? 16 : kLayerPicture.width()) + kGap;
}

QRect text_place(const QRect& row, const Item& item) {
    return row.adjusted(indent_of(item) + 2, 0, -2, 0);
}

/// Squares behind what no paint covers, as painting programs do.
void paint_bare(QPainter* painter, const QRect& place) {
    constexpr int kSquare = 6;
    painter->fillRect(place, appearance::colours().bare_dark);
    for (int y = place.top(); y <= place.bottom(); y += kSquare) {
        for (int x = place.left(); x <= place.right(); x += kSquare) {
            const bool light = ((x - place.left()) + (y - place.top())) / kSquare % 2 == 0;
            if (light)
                painter->fillRect(QRect(x, y, kSquare, kSquare) & place,
                                  appearance::colours().bare_light);
        }
    }
}

void paint_picture(QPainter* painter, const QRect& box, const QImage& picture) {
    if (picture.isNull()) return;
    QRect place(QPoint(), picture.deviceIndependentSize().toSize());
    place.moveCenter(box.center());
    paint_bare(painter, place);
    painter->drawImage(place, appearance::shown(picture));
}

/// What the second line of a row says; often nothing.
QString remarks(const Item& item) {
    QStringList remarks;
    if (item.look.opacity < 1.0) remarks += QObject::tr("%1 %").arg(qRound(100.0 * item.look.opacity));
    if (item.inactive_wet) remarks += QObject::tr("wet, inactive");
    return remarks.join(QStringLiteral(" \u00b7 "));
}

QString paint_hint(const Item& item) {
    if (item.active) return QObject::tr("You paint on this layer; its wet paint flows and dries");
    if (item.inactive_wet)
        return QObject::tr(
            "Its wet paint keeps still: it neither flows nor dries, and stays as wet as it is until you "
            "choose this layer");
    return QObject::tr("Click to paint on this layer; a double click names it, dragging moves it");
}

QString name_hint(const Item& item) {
    if (item.is_group)
        return QObject::tr("A group: its eye, its lock and its opacity hold for all of its layers");
    QStringList hints{paint_hint(item)};
    if (item.has_base)
        hints += QObject::tr(
            "Clipped to the layer below: of its paint, only what lies over paint of that layer shows. "
            "The rest is hidden, and kept");
    return hints.join(QLatin1Char('\n'));
}

QString hint(const Item& item, int column) {
    switch (column) {
        case LayerModel::kEye:
            return item.look.visible ? QObject::tr("Seen; click to hide it. Its relief goes with it")
                                     : QObject::tr("Hidden, and not painted on; click to show it");
        case LayerModel::kBare:
            return item.look.bare_locked
                       ? QObject::tr(
                             "What is bare is locked: tools change only what has paint. Click to "
                             "unlock")
                       : QObject::tr("Click to lock what is bare: tools change only what has paint");
        case LayerModel::kLock:
            return item.look.locked
                       ? QObject::tr(
                             "Locked: nothing is painted on it, cleared or merged. Click to unlock")
                       : QObject::tr("Click to lock it against painting, clearing and merging");
        default:
            return name_hint(item);
    }
}

}  // namespace

LayerDelegate::LayerDelegate(const LayerModel* model, QObject* parent)
    : QStyledItemDelegate(parent), model_(model) {}

void LayerDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
    const Item item = model_->item(index);
    painter->save();
    if (option.state & QStyle::State_Selected)
        painter->fillRect(option.rect, appearance::colours().chosen);
    if (index.column() == LayerModel::kEye) paint_eye(painter, option.rect, item);
    if (index.column() == LayerModel::kName) paint_name(painter, option, index, item);
    if (index.column() == LayerModel::kBare)
        paint_lock(painter, option,
                   {"lock_bare", "open_bare", item.look.bare_locked, item.group_bare_locked});
    if (index.column() == LayerModel::kLock)
        paint_lock(painter, option, {"lock_layer", "open_lock", item.look.locked, item.group_locked});
    painter->restore();
}

/// The layer that is painted on has a bright edge, whatever row is chosen.
void LayerDelegate::paint_eye(QPainter* painter, const QRect& place, const Item& item) const {
    constexpr int kEdge = 3;
    if (item.active)
        painter->fillRect(QRect(place.topLeft(), QSize(kEdge, place.height())),
                          appearance::colours().accent);
    appearance::draw_icon(
        *painter, place.adjusted(kEdge, 0, 0, 0),
        item.look.visible ? QStringLiteral("show_layer") : QStringLiteral("closed_eye"),
        item.seen ? appearance::colours().text : appearance::colours().faint_text);
}

void LayerDelegate::paint_lock(QPainter* painter, const QStyleOptionViewItem& option,
                               const Lock& lock) const {
    const bool locked = lock.own || lock.of_group;
    const bool chosen = option.state & QStyle::State_Selected;
    appearance::draw_icon(*painter, option.rect, QLatin1String(locked ? lock.closed : lock.open),
                          lock.own           ? appearance::colours().text
                          : locked || chosen ? appearance::colours().faint_text
                                             : appearance::colours().very_faint);
}

void LayerDelegate::paint_name(QPainter* painter, const QStyleOptionViewItem& option,
                               const QModelIndex& index, const Item& item) const {
    painter->setOpacity(item.seen ? 1.0 : 0.6);
    QRect box = option.rect;
    box.setWidth(indent_of(item) - kGap);
    if (item.look.clipped)
        appearance::draw_icon(*painter, QRect(box.topLeft(), QSize(kClipMark, box.height())),
                              QStringLiteral("clip_layer"), appearance::colours().text);
    box.setLeft(box.left() + mark_of(item));
    if (item.is_group)
        appearance::draw_icon(*painter, box, QStringLiteral("group_layers"), appearance::colours().text);
    else
        paint_picture(painter, box, model_->picture(index));
    QRect text = text_place(option.rect, item);
    QFont font = option.font;
    font.setBold(item.active);
    painter->setFont(font);
    painter->setPen(appearance::colours().text);
    const QString second = remarks(item);
    const QString name = QFontMetrics(font).elidedText(appearance::shown_name(item.look.name),
                                                       Qt::ElideRight, text.width());
    if (second.isEmpty()) {
        painter->drawText(text, Qt::AlignVCenter | Qt::AlignLeft, name);
        return;
    }
    const int middle = text.center().y();
    const bool low = text.height() < kLayerRow;
    if (low) {
        painter->drawText(text, Qt::AlignVCenter | Qt::AlignLeft, name);
        painter->setPen(appearance::colours().faint_text);
        painter->drawText(text, Qt::AlignVCenter | Qt::AlignRight, second);
        return;
    }
    painter->drawText(QRect(text.left(), text.top(), text.width(), middle - text.top() + 1),
                      Qt::AlignBottom | Qt::AlignLeft, name);
    font.setBold(false);
    font.setPointSizeF(0.88 * font.pointSizeF());
    painter->setFont(font);
    painter->setPen(option.state & QStyle::State_Selected ? appearance::colours().text
                                                          : appearance::colours().faint_text);
    painter->drawText(QRect(text.left(), middle + 1, text.width(), text.bottom() - middle),
                      Qt::AlignTop | Qt::AlignLeft, second);
}

QSize LayerDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex& index) const {
    const bool group = model_->row_at(index).group != 0;
    return {kLayerIconColumn, group ? kGroupRow : kLayerRow};
}

void LayerDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
    constexpr const char* kFilled = "filled";
    if (editor->property(kFilled).toBool()) return;
    QStyledItemDelegate::setEditorData(editor, index);
    editor->setProperty(kFilled, true);
}

void LayerDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                         const QModelIndex& index) const {
    QRect place = text_place(option.rect, model_->item(index));
    place.setHeight(editor->sizeHint().height());
    place.moveCenter({place.center().x(), option.rect.center().y()});
    editor->setGeometry(place.adjusted(-4, 0, 2, 0));
}

bool LayerDelegate::helpEvent(QHelpEvent* event, QAbstractItemView* view,
                              const QStyleOptionViewItem& option, const QModelIndex& index) {
    if (event->type() != QEvent::ToolTip || !index.isValid())
        return QStyledItemDelegate::helpEvent(event, view, option, index);
    QToolTip::showText(event->globalPos(), hint(model_->item(index), index.column()), view->viewport(),
                       option.rect);
    return true;
}

}  // namespace pastoso::panels
