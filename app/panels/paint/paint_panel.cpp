#include "panels/paint/paint_panel.hpp"

#include "appearance/screen_colours.hpp"
#include "appearance/theme.hpp"
#include "panels/paint/drawdown_picture.hpp"
#include "panels/paint/paint_words.hpp"
#include "panels/paint/swatch_colours.hpp"
#include "panels/paint/tube_menu.hpp"
#include "panels/parts/choice_list.hpp"
#include "panels/parts/section.hpp"

#include <algorithm>

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

/// The paint, drawn out over white and black, and with white; beside them the mark of how well it hides.
constexpr QSize kIcon(46, 18);
constexpr double kPaint_px = 13.0, kDrawdown_px = 14.0, kSwatch_px = 35.0, kMark_px = 8.0;

/// Four of these stand beside one another in the narrowest of panels.
constexpr QSize kCell(50, 22);

/// One row of tubes on the lowest of screens; higher ones show more of them.
constexpr int kLeastGridHeight = 28;

/// Of an entry: its place among all paints.
constexpr int kPlace = Qt::UserRole + 1;

/// A tube is its swatch alone: its name stands above the grid and in the hint.
class TubeCell : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        const bool chosen = option.state.testFlag(QStyle::State_Selected);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        if (chosen || option.state.testFlag(QStyle::State_MouseOver)) {
            const appearance::ThemeColours& theme = appearance::colours();
            painter->setPen(Qt::NoPen);
            painter->setBrush(chosen ? theme.chosen : theme.hovered);
            painter->drawRoundedRect(option.rect, 3.0, 3.0);
        }
        index.data(Qt::DecorationRole)
            .value<QIcon>()
            .paint(painter, option.rect, Qt::AlignCenter, chosen ? QIcon::Selected : QIcon::Normal);
        painter->restore();
    }

    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return kCell; }
};

void draw_swatch(QPainter& painter, const QRectF& place, const QColor& paint, const QColor& tint,
                 const tools::Drawdown& drawdown) {
    QPainterPath outline;
    outline.addRoundedRect(place, 3.0, 3.0);
    painter.setClipPath(outline);
    painter.fillRect(place, paint);
    const QRectF drawn(kPaint_px, 0.0, kDrawdown_px, kIcon.height());
    draw_drawdown(painter, drawn, drawdown);
    painter.fillRect(QRectF(drawn.topRight(), place.bottomRight()), tint);
    painter.setClipping(false);
    painter.strokePath(outline, QPen(QColor(0, 0, 0, 120)));
}

}  // namespace

QIcon PaintPanel::icon_of(const Colours& colours, double pixel_ratio) {
    const auto picture = [&](const QColor& ink) {
        QPixmap pixmap(kIcon * pixel_ratio);
        pixmap.setDevicePixelRatio(pixel_ratio);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        painter.setRenderHint(QPainter::Antialiasing);
        draw_swatch(painter, {0.5, 0.5, kSwatch_px - 1.0, kIcon.height() - 1.0},
                    appearance::shown(qcolor(colours.paint)), appearance::shown(qcolor(colours.tint)),
                    colours.drawdown);
        const QPointF corner(kSwatch_px + 3.5, 0.5 * (kIcon.height() - kMark_px) + 0.5);
        draw_hiding_mark(painter, {corner, QSizeF(kMark_px, kMark_px)}, colours.drawdown.hiding, ink);
        return pixmap;
    };
    QIcon icon;
    // The same paint when selected: a highlight must not change what it looks like.
    icon.addPixmap(picture(colours.ink), QIcon::Normal);
    icon.addPixmap(picture(colours.chosen_ink), QIcon::Selected);
    return icon;
}

QString PaintPanel::words_of(const PaintEntry& paint, const Colours& colours, double film_mm) {
    if (paint.pigment.isEmpty()) return tr("The medium without pigment, for example thinner");
    return tr("%1 (%2), %3\nAs the tool in hand lays it (%4 mm), thinned over white and over black, and "
              "with white")
        .arg(paint.name, paint.pigment, hiding_words(colours.drawdown.hiding),
             QLocale().toString(film_mm, 'g', 2));
}

PaintPanel::PaintPanel(const std::vector<PaintEntry>& paints, QWidget* parent)
    : QWidget(parent),
      paints_(paints),
      list_(new ChoiceList),
      sets_(new TubeMenu),
      name_(new QLabel),
      shown_(paints.size()) {
    make_grid();
    QStringList tubes;
    for (const PaintEntry& paint : paints)
        tubes += paint.pigment;
    show_tubes(tubes);
    connect(list_, &ChoiceList::taken, this, [this](const QListWidgetItem* item) {
        Q_EMIT paint_chosen(item->data(Qt::UserRole).toString());
    });
    connect(list_, &ChoiceList::arranged, this, &PaintPanel::arranged);
    connect(list_, &QWidget::customContextMenuRequested, this, &PaintPanel::offer_sets);
    auto* column = new QVBoxLayout(this);
    column->setSpacing(4);
    column->addWidget(make_head());
    column->addWidget(list_, 1);
    connect(&appearance::screen_colours(), &appearance::ScreenColours::changed, this,
            &PaintPanel::draw_icons);
}

void PaintPanel::make_grid() {
    list_->setObjectName(QStringLiteral("paints"));
    list_->setAccessibleName(tr("Paint"));
    list_->setIconSize(kIcon);
    list_->setItemDelegate(new TubeCell(list_));
    list_->setFlow(QListView::LeftToRight);
    list_->setWrapping(true);
    list_->setMinimumHeight(kLeastGridHeight);
    list_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);  // all that is left, no more
    list_->let_arrange();
    keep_own_keys(list_, {Qt::Key_Left, Qt::Key_Right});
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
}

/// Two lines, for which there is room beside the button, of whatever fonts the names are written in.
void PaintPanel::give_name_room() {
    constexpr int kLines = 2;
    constexpr QRect kRoom(0, 0, 1000, 1000);
    int line = fontMetrics().lineSpacing();
    for (const PaintEntry& paint : paints_)
        line = std::max(line, fontMetrics().boundingRect(kRoom, 0, paint.name).height());
    name_->setFixedHeight(kLines * line);
}

QWidget* PaintPanel::make_head() {
    name_->setObjectName(QStringLiteral("tube_name"));
    name_->setWordWrap(true);
    name_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    give_name_room();
    auto* head = new QWidget;
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(name_, 1);
    row->addWidget(sets_);
    return head;
}

void PaintPanel::show_tubes(const QStringList& tubes) {
    if (tubes == this->tubes()) return;
    list_->clear();
    for (const QString& tube : tubes) {
        const auto found = std::find_if(paints_.begin(), paints_.end(),
                                        [&](const PaintEntry& paint) { return paint.pigment == tube; });
        if (found == paints_.end()) continue;
        auto* item = new QListWidgetItem(found->name, list_);
        item->setFlags(item->flags() & ~Qt::ItemIsDropEnabled);  // tubes are dropped between others
        item->setData(Qt::UserRole, tube);
        item->setData(kPlace, static_cast<int>(found - paints_.begin()));
        draw(*item);
    }
    show_paint(in_hand_);
}

QStringList PaintPanel::tubes() const {
    QStringList tubes;
    for (int row = 0; row < list_->count(); ++row)
        tubes += list_->item(row)->data(Qt::UserRole).toString();
    return tubes;
}

void PaintPanel::draw(QListWidgetItem& item) const {
    const auto place = static_cast<std::size_t>(item.data(kPlace).toInt());
    const Colours& shown = shown_[place];
    if (!shown.ink.isValid()) return;
    item.setIcon(icon_of(shown, devicePixelRatioF()));
    item.setToolTip(words_of(paints_[place], shown, view_.spot.film_mm));
}

void PaintPanel::draw_icons() {
    for (int row = 0; row < list_->count(); ++row)
        draw(*list_->item(row));
}

/// What may be done with the tube under the pointer.
void PaintPanel::offer_sets(const QPoint& place) {
    const QListWidgetItem* item = list_->itemAt(place);
    if (item == nullptr) return;
    const QString pigment = item->data(Qt::UserRole).toString();
    QMenu menu;
    QMenu* into = menu.addMenu(tr("Put into a set"));
    into->setEnabled(!sets_->names().isEmpty());
    for (const QString& name : sets_->names())
        into->addAction(QString(name).replace('&', QLatin1String("&&")), this,
                        [this, pigment, name] { Q_EMIT put_into_set(pigment, name); });
    menu.addAction(tr("Take out of this set"), this, [this, pigment] { Q_EMIT taken_out(pigment); })
        ->setEnabled(!sets_->chosen().isEmpty());
    menu.exec(list_->viewport()->mapToGlobal(place));
}

/// The marks take the ink of another theme.
void PaintPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) give_name_room();
    if (event->type() == QEvent::StyleChange && !shown_.empty() && shown_.front().ink.isValid())
        show_swatches(view_);
}

void PaintPanel::show_swatches(const tools::SwatchView& view) {
    view_ = view;
    for (std::size_t i = 0; i < paints_.size(); ++i) {
        const std::string tube = paints_[i].pigment.toStdString();
        shown_[i] = {appearance::colours().text, appearance::colours().chosen_text,
                     tools::swatch_colour(tools::tube_paint(tube), view),
                     tools::swatch_colour(tools::tube_tint(tube), view),
                     tools::drawdown(tools::tube_paint(tube), view)};
    }
    draw_icons();
}

void PaintPanel::show_paint(const QString& pigment) {
    in_hand_ = pigment;
    name_->clear();
    list_->setCurrentItem(nullptr);
    for (int row = 0; row < list_->count(); ++row) {
        if (list_->item(row)->data(Qt::UserRole).toString() != pigment) continue;
        list_->setCurrentRow(row);
        list_->scrollToItem(list_->item(row));
        name_->setText(list_->item(row)->text());
    }
}

}  // namespace pastoso::panels
