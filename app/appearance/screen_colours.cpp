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

QColor through(const ScreenCube& cube, const QColor& colour) {
    if (cube == nullptr || !colour.isValid()) return colour;
    return QColor::fromRgba(shown_pixel(*cube, colour.rgba()));
}

}  // namespace

void ScreenColours::use(ScreenCube cube, ScreenCube of_painting) {
    if (cube == cube_ && of_painting == of_painting_) return;
    cube_ = std::move(cube);
    of_painting_ = std::move(of_painting);
    tell();
}

void ScreenColours::squint(bool squints) {
    if (squints == squints_) return;
    squints_ = squints;
    tell();
}

void ScreenColours::tell() {
    Q_EMIT changed();
    for (QWidget* widget : QApplication::allWidgets())
        widget->update();
}

ScreenColours& screen_colours() {
    static ScreenColours colours;
    return colours;
}

QColor shown(const QColor& colour) {
    return through(screen_colours().cube(), colour);
}

QImage shown(const QImage& picture) {
    return shown_through(screen_colours().cube(), picture);
}

QPixmap shown(const QPixmap& picture) {
    if (screen_colours().cube() == nullptr || picture.isNull()) return picture;
    return QPixmap::fromImage(shown(picture.toImage()));
}

QImage shown_through(const ScreenCube& cube, const QImage& picture) {
    if (cube == nullptr || picture.isNull()) return picture;
    QImage seen = picture.convertToFormat(QImage::Format_ARGB32);
    for (int y = 0; y < seen.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(seen.scanLine(y));
        for (int x = 0; x < seen.width(); ++x)
            line[x] = shown_pixel(*cube, line[x]);
    }
    return seen;
}

QColor shown_in_painting(const QColor& colour) {
    return through(screen_colours().of_painting(), colour);
}

QImage shown_in_painting(const QImage& picture) {
    return shown_through(screen_colours().of_painting(), picture);
}

}  // namespace pastoso::appearance
