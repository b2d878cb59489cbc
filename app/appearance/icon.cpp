#include "appearance/icon.hpp"

#include "core/error.hpp"
#include "core/resources.hpp"

#include <QApplication>
#include <QFile>
#include <QHash>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSvgRenderer>

namespace pastoso::appearance {
namespace {

QByteArray read_drawing(const QString& name) {
    try {
        const auto path = core::resource_path("icons/" + name.toStdString() + ".svg");
        QFile file(QString::fromStdString(path.string()));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    } catch (const core::InputError&) {
        return {};
    }
}

/// As it lies in its file; empty where there is none.
const QByteArray& drawing(const QString& name) {
    static QHash<QString, QByteArray> drawings;
    const auto known = drawings.constFind(name);
    return known != drawings.cend() ? *known : *drawings.insert(name, read_drawing(name));
}

QByteArray coloured(const QByteArray& drawing, const QColor& colour) {
    QByteArray result = drawing;
    return result.replace("#000", colour.name().toLatin1());
}

void draw(QPainter& painter, const QRectF& place, const QString& name, const QColor& colour) {
    QSvgRenderer(coloured(drawing(name), colour)).render(&painter, place);
}

/// Drawn once for each size, scale and colour: to parse the drawing takes longer than all else of a
/// button. Qt keeps the latest, as much as fits into QPixmapCache::cacheLimit().
QPixmap drawn(const QString& name, const QSize& size, double scale, const QColor& colour) {
    const QString key = QStringLiteral("pastoso/icons/%1 %2x%3 %4 %5")
                            .arg(name)
                            .arg(size.width())
                            .arg(size.height())
                            .arg(scale)
                            .arg(colour.name());
    QPixmap pixmap;
    if (QPixmapCache::find(key, &pixmap)) return pixmap;
    pixmap = QPixmap(size * scale);
    pixmap.setDevicePixelRatio(scale);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    draw(painter, QRectF(QPointF(), QSizeF(size)), name, colour);
    painter.end();
    QPixmapCache::insert(key, pixmap);
    return pixmap;
}

/// As draw(), from what was drawn before unless the painter scales or turns: then it would be blurred.
void draw_again(QPainter& painter, const QRectF& place, const QString& name, const QColor& colour) {
    if (painter.transform().type() > QTransform::TxTranslate) return draw(painter, place, name, colour);
    const double scale = painter.device()->devicePixelRatioF();
    const QPointF corner = (place.topLeft() * scale).toPoint() / scale;  // sharp on the pixels
    painter.drawPixmap(corner, drawn(name, place.size().toSize(), scale, colour));
}

/// In the colours of the moment.
class DrawnIcon : public QIconEngine {
  public:
    explicit DrawnIcon(QString name) : name_(std::move(name)) {}

    void paint(QPainter* painter, const QRect& place, QIcon::Mode mode, QIcon::State) override {
        draw_again(*painter, place, name_, colour(mode));
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State) override {
        return drawn(name_, size, 1.0, colour(mode));
    }

    QIconEngine* clone() const override { return new DrawnIcon(name_); }

  private:
    static QColor colour(QIcon::Mode mode) {
        return QApplication::palette().color(
            mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active, QPalette::ButtonText);
    }

    QString name_;
};

}  // namespace

QIcon icon(const QString& name) {
    return drawing(name).isEmpty() ? QIcon() : QIcon(new DrawnIcon(name));
}

void draw_icon(QPainter& painter, const QRectF& place, const QString& name, const QColor& colour) {
    QRectF box(0, 0, kIconSide, kIconSide);
    box.moveCenter(place.center());
    draw_again(painter, box, name, colour);
}

}  // namespace pastoso::appearance
