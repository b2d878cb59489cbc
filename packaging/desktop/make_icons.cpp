// Draws an icon in the sizes that desktops ask for: make_icons DRAWING.svg FOLDER SIZE... writes
// FOLDER/SIZE.png.
#include <cstdio>

#include <QDir>
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>

namespace {

bool draw(QSvgRenderer& drawing, const QString& file, int side_px) {
    QImage image(side_px, side_px, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    drawing.render(&painter);
    painter.end();
    return image.save(file);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) return 2;
    QSvgRenderer drawing(QString::fromLocal8Bit(argv[1]));
    const QString folder = QString::fromLocal8Bit(argv[2]);
    if (!drawing.isValid() || !QDir().mkpath(folder)) return 1;
    for (int i = 3; i < argc; ++i) {
        const QString size = QString::fromLatin1(argv[i]);
        const QString file = QStringLiteral("%1/%2.png").arg(folder, size);
        if (size.toInt() < 1 || !draw(drawing, file, size.toInt())) {
            std::fprintf(stderr, "%s: cannot be drawn\n", qPrintable(file));
            return 1;
        }
    }
    return 0;
}
