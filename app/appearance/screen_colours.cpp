#include "appearance/screen_colours.hpp"

#include <cmath>
#include <utility>

#include <QApplication>
#include <QWidget>

namespace pastoso::appearance {
namespace {

constexpr float kMost = 255.0F;

int level(float value) {
    return static_cast<int>(std::lround(kMost * value));
}

QRgb shown_pixel(const pigment::ColourCube& cube, QRgb pixel) {
    const pigment::EncodedRgb seen = pigment::shown_by(
        cube, {static_cast<float>(qRed(pixel)) / kMost, static_cast<float>(qGreen(pixel)) / kMost,
               static_cast<float>(qBlue(pixel)) / kMost});
    return qRgba(level(seen[0]), level(seen[1]), level(seen[2]), qAlpha(pixel));
}

}  // namespace

void ScreenColours::use(ScreenCube cube) {
    if (cube == cube_) return;
    cube_ = std::move(cube);
    Q_EMIT changed();
    for (QWidget* widget : QApplication::allWidgets())
        widget->update();
}

ScreenColours& screen_colours() {
    static ScreenColours colours;
    return colours;
}

QColor shown(const QColor& colour) {
    const ScreenCube& cube = screen_colours().cube();
    if (cube == nullptr || !colour.isValid()) return colour;
    return QColor::fromRgba(shown_pixel(*cube, colour.rgba()));
}

QImage shown(const QImage& picture) {
    const ScreenCube& cube = screen_colours().cube();
    if (cube == nullptr || picture.isNull()) return picture;
    QImage seen = picture.convertToFormat(QImage::Format_ARGB32);
    for (int y = 0; y < seen.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(seen.scanLine(y));
        for (int x = 0; x < seen.width(); ++x)
            line[x] = shown_pixel(*cube, line[x]);
    }
    return seen;
}

QPixmap shown(const QPixmap& picture) {
    if (screen_colours().cube() == nullptr || picture.isNull()) return picture;
    return QPixmap::fromImage(shown(picture.toImage()));
}

}  // namespace pastoso::appearance
