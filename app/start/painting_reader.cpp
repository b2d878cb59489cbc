#include "start/painting_reader.hpp"

#include "project/project.hpp"

#include <QCoreApplication>
#include <QFileInfo>

namespace pastoso::start {

PaintingFile read_painting_file(const std::filesystem::path& path) {
    PaintingFile file{path};
    const QFileInfo info(QString::fromStdString(path.string()));
    if (!info.isFile()) {
        file.fault = PaintingReader::tr("This file is not there any more.");
        return file;
    }
    file.saved = info.lastModified();
    try {
        file.picture = QImage::fromData(QByteArray::fromStdString(project::load_thumbnail(path)));
    } catch (const std::exception& failure) {
        file.fault = PaintingReader::tr("This file cannot be read.");
        file.reason = QString::fromUtf8(failure.what());
    }
    return file;
}

void PaintingReader::read(const std::filesystem::path& path) {
    thread_.add([this, path] {
        QMetaObject::invokeMethod(
            this, [this, file = read_painting_file(path)] { Q_EMIT finished(file); },
            Qt::QueuedConnection);
    });
}

}  // namespace pastoso::start
