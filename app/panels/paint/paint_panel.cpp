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
#include <QMenu>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <QVBoxLayout>

namespace pastoso::panels {
namespace {

/// The paint, drawn out over white and black, and with white; beside them the mark of how well it hides.
constexpr QSize kIcon(56, 18);
constexpr double kPaint_px = 15.0, kDrawdown_px = 18.0, kSwatch_px = 43.0, kMark_px = 8.0;

/// Three paints on the lowest of screens; higher ones show more of them.
constexpr int kListHeight = 86;

/// Of an entry: its place among all paints.
constexpr int kPlace = Qt::UserRole + 1;

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
             QString::number(film_mm, 'g', 2));
}

PaintPanel::PaintPanel(const std::vector<PaintEntry>& paints, QWidget* parent)
    : QWidget(parent),
      paints_(paints),
      list_(new ChoiceList),
      sets_(new TubeMenu),
      shown_(paints.size()) {
    list_->setObjectName(QStringLiteral("paints"));
    list_->setAccessibleName(tr("Paint"));
    list_->setIconSize(kIcon);
    list_->setMinimumHeight(kListHeight);
    list_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);  // all that is left, no more
    list_->let_arrange();
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
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
    column->addWidget(sets_, 0, Qt::AlignRight);
    column->addWidget(list_, 1);
    connect(&appearance::screen_colours(), &appearance::ScreenColours::changed, this,
            &PaintPanel::draw_icons);
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
    list_->setCurrentItem(nullptr);
    for (int row = 0; row < list_->count(); ++row) {
        if (list_->item(row)->data(Qt::UserRole).toString() != pigment) continue;
        list_->setCurrentRow(row);
        list_->scrollToItem(list_->item(row));
    }
}

}  // namespace pastoso::panels
