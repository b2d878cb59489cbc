#include "start/painting_reader.hpp"

#include "appearance/shown_message.hpp"
#include "project/project.hpp"

#include <QCoreApplication>
#include <QFileInfo>

namespace pastoso::start {
namespace {

/// The window comes first.
constexpr int kNice = 6;

PaintingFile unreadable(PaintingFile file, const core::Message& fault) {
    file.fault = PaintingReader::tr("This file cannot be read.");
    file.reason = appearance::shown_message(fault);
    return file;
}

}  // namespace

PaintingFile read_painting_file(const std::filesystem::path& path) {
    PaintingFile file{path};
    const QFileInfo info(QString::fromStdString(path.string()));
    if (!info.isFile()) {
        file.fault = PaintingReader::tr("This file is not there any more.");
        return file;
    }
    file.saved = info.lastModified();
    const core::Message fault = core::fault_of([&] {
        file.picture = QImage::fromData(QByteArray::fromStdString(project::load_thumbnail(path)));
    });
    return fault.empty() ? file : unreadable(file, fault);
}

PaintingReader::PaintingReader(QObject* parent)
    : QObject(parent),
      worker_([this](std::filesystem::path& path) { tell(read_painting_file(path)); },
              [this](std::filesystem::path& path, const core::Message& fault) {
                  tell(unreadable({path}, fault));
              },
              kNice) {}

void PaintingReader::tell(const PaintingFile& file) {
    QMetaObject::invokeMethod(
        this, [this, file] { Q_EMIT finished(file); }, Qt::QueuedConnection);
}

}  // namespace pastoso::start
