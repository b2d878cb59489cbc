#include "appearance/icon.hpp"

#include "core/error.hpp"
#include "core/resources.hpp"

#include <QApplication>
#include <QFile>
#include <QHash>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
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

/// Draws at any size when it is asked to, in the colours of that moment.
class DrawnIcon : public QIconEngine {
  public:
    explicit DrawnIcon(QString name) : name_(std::move(name)) {}

    void paint(QPainter* painter, const QRect& place, QIcon::Mode mode, QIcon::State) override {
        const QPalette palette = QApplication::palette();
        const QColor colour = mode == QIcon::Disabled
                                  ? palette.color(QPalette::Disabled, QPalette::ButtonText)
                                  : palette.color(QPalette::ButtonText);
        QSvgRenderer(coloured(drawing(name_), colour)).render(painter, place);
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return pixmap;
    }

    QIconEngine* clone() const override { return new DrawnIcon(name_); }

  private:
    QString name_;
};

}  // namespace

QIcon icon(const QString& name) {
    return drawing(name).isEmpty() ? QIcon() : QIcon(new DrawnIcon(name));
}

void draw_icon(QPainter& painter, const QRectF& place, const QString& name, const QColor& colour) {
    QRectF box(0, 0, kIconSide, kIconSide);
    box.moveCenter(place.center());
    QSvgRenderer(coloured(drawing(name), colour)).render(&painter, box);
}

}  // namespace pastoso::appearance
