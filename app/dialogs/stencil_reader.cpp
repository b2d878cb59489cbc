#include "dialogs/stencil_reader.hpp"

#include "files/image.hpp"

#include <utility>

#include <QImage>

namespace pastoso::dialogs {
namespace {

pigment::Picture fitted(pigment::Picture picture, const QSize& most_px) {
    if (picture.width <= most_px.width() && picture.height <= most_px.height()) return picture;
    const QImage whole(picture.rgba.data(), picture.width, picture.height, 4 * picture.width,
                       QImage::Format_RGBA8888);
    const QImage small = whole.scaled(most_px, Qt::KeepAspectRatio, Qt::SmoothTransformation)
                             .convertToFormat(QImage::Format_RGBA8888);
    pigment::Picture scaled{small.width(), small.height(), {}};
    for (int y = 0; y < small.height(); ++y) {
        const uchar* row = small.constScanLine(y);
        scaled.rgba.insert(scaled.rgba.end(), row, row + 4 * small.width());
    }
    return scaled;
}

}  // namespace

StencilReader::StencilReader(const QSize& most_px)
    : most_px_(most_px),
      worker_(
          [this](const std::string& path) {
              tell(path, std::make_shared<const pigment::Picture>(
                             fitted(files::read_picture(path).picture, most_px_)));
          },
          [this](const std::string& path, const core::Message&) { tell(path, nullptr); }) {}

void StencilReader::want(const std::string& path) {
    wanted_ = path;
    worker_.replace(path);
}

/// On the worker's thread.
void StencilReader::tell(const std::string& path, Picture picture) {
    QMetaObject::invokeMethod(
        this,
        [this, path, picture = std::move(picture)] {
            if (path == wanted_) Q_EMIT was_read(picture);
        },
        Qt::QueuedConnection);
}

}  // namespace pastoso::dialogs
