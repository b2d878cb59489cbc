#include "panels/parts/gallery_delegate.hpp"

#include "appearance/screen_colours.hpp"

#include <QFontMetrics>
#include <QGuiApplication>
#include <QPainter>

namespace pastoso::panels {
namespace {

constexpr int kMargin = 6, kWordsGap = 5, kCross = 18;
constexpr qreal kRadius = 6.0;

QFont small(const QFont& font) {
    QFont smaller = font;
    if (font.pointSizeF() > 0.0)
        smaller.setPointSizeF(0.88 * font.pointSizeF());
    else
        smaller.setPixelSize(font.pixelSize() * 7 / 8);
    return smaller;
}

/// The window's: a list without a background of its own knows no colour of what is behind it.
QPalette theme() {
    return QGuiApplication::palette();
}

/// Between the colours of words and of what is behind them, under any theme.
QColor mixed(const QColor& words, const QColor& behind, double share) {
    const auto between = [share](int a, int b) { return static_cast<int>(a + share * (b - a)); };
    return {between(words.red(), behind.red()), between(words.green(), behind.green()),
            between(words.blue(), behind.blue())};
}

/// A line for each paragraph, cut where it is too long; a single paragraph goes on in the next line.
void draw_detail(QPainter& painter, QRect place, const QString& text, int most_lines) {
    const int line = painter.fontMetrics().lineSpacing();
    const QStringList paragraphs = text.split(QLatin1Char('\n'));
    if (paragraphs.size() == 1 && most_lines > 1) {
        place.setHeight(most_lines * line);
        painter.drawText(place, Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, text);
        return;
    }
    place.setHeight(line);
    for (const QString& paragraph : paragraphs) {
        painter.drawText(place, Qt::AlignCenter,
                         painter.fontMetrics().elidedText(paragraph, Qt::ElideMiddle, place.width()));
        place.translate(0, line);
    }
}

void draw_cross(QPainter& painter, const QRect& place) {
    const QPalette palette = theme();
    painter.setPen(Qt::NoPen);
    QColor behind = palette.color(QPalette::Window);
    behind.setAlpha(220);
    painter.setBrush(behind);
    painter.drawEllipse(place);
    painter.setPen(QPen(palette.color(QPalette::WindowText), 1.6, Qt::SolidLine, Qt::RoundCap));
    const QRectF arms = QRectF(place).adjusted(5.5, 5.5, -5.5, -5.5);
    painter.drawLine(arms.topLeft(), arms.bottomRight());
    painter.drawLine(arms.topRight(), arms.bottomLeft());
}

}  // namespace

GalleryDelegate::GalleryDelegate(const QSize& picture, int detail_lines, QObject* parent)
    : QStyledItemDelegate(parent), picture_(picture), detail_lines_(detail_lines) {}

QRect GalleryDelegate::cross(const QRect& tile) {
    return {tile.right() - kCross - 3, tile.top() + 4, kCross, kCross};
}

void GalleryDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const bool hovered = option.state.testFlag(QStyle::State_MouseOver);
    const bool current = option.state.testFlag(QStyle::State_HasFocus);
    const QRectF tile = QRectF(option.rect).adjusted(1.5, 1.5, -1.5, -1.5);
    if (hovered || current) {
        QColor glow = theme().color(QPalette::Highlight);
        painter->setPen(current ? QPen(glow, 2.0) : QPen(Qt::NoPen));
        glow.setAlpha(hovered ? 70 : 40);
        painter->setBrush(glow);
        painter->drawRoundedRect(tile, kRadius, kRadius);
    }
    paint_picture(*painter, option, index);
    paint_words(*painter, option, index);
    const bool offers_removal = hovered || current || index.data(kFaint).toBool();
    if (offers_removal && index.data(kRemovable).toBool()) draw_cross(*painter, cross(option.rect));
    painter->restore();
}

/// In the middle of its room; an outline where there is none.
void GalleryDelegate::paint_picture(QPainter& painter, const QStyleOptionViewItem& option,
                                    const QModelIndex& index) const {
    const QRectF room(option.rect.left() + 0.5 * (option.rect.width() - picture_.width()),
                      option.rect.top() + kMargin, picture_.width(), picture_.height());
    const QPixmap picture = index.data(Qt::DecorationRole).value<QPixmap>();
    if (picture.isNull()) {
        painter.setPen(
            QPen(mixed(theme().color(QPalette::WindowText), theme().color(QPalette::Window), 0.65), 1.0,
                 Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(room.adjusted(0.5, 0.5, -0.5, -0.5), 3.0, 3.0);
        return;
    }
    const QSizeF size = picture.deviceIndependentSize();
    if (index.data(kFaint).toBool()) painter.setOpacity(0.4);
    const QPointF corner = room.center() - QPointF(0.5 * size.width(), 0.5 * size.height());
    painter.drawPixmap(corner.toPoint(), appearance::shown(picture));
    painter.setOpacity(1.0);
}

void GalleryDelegate::paint_words(QPainter& painter, const QStyleOptionViewItem& option,
                                  const QModelIndex& index) const {
    const QColor behind = theme().color(QPalette::Window);
    const QColor words = theme().color(QPalette::WindowText);
    QRect place = option.rect.adjusted(kMargin, kMargin + picture_.height() + kWordsGap, -kMargin, 0);
    painter.setFont(option.font);
    painter.setPen(index.data(kFaint).toBool() ? mixed(words, behind, 0.35) : words);
    const QFontMetrics metrics = painter.fontMetrics();
    painter.drawText(
        place, Qt::AlignHCenter | Qt::AlignTop,
        metrics.elidedText(index.data(Qt::DisplayRole).toString(), Qt::ElideMiddle, place.width()));
    place.setTop(place.top() + metrics.lineSpacing() + 1);
    painter.setFont(small(option.font));
    painter.setPen(mixed(words, behind, 0.3));
    draw_detail(painter, place, index.data(kDetail).toString(), detail_lines_);
}

QSize GalleryDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
    const int words = QFontMetrics(option.font).lineSpacing() + 1 +
                      detail_lines_ * QFontMetrics(small(option.font)).lineSpacing();
    return {picture_.width() + 2 * kMargin + 4, picture_.height() + 2 * kMargin + kWordsGap + words};
}

}  // namespace pastoso::panels
