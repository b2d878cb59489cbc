#include "commands/project_saver.hpp"

#include "core/thread_pool.hpp"

#include <utility>

namespace pastoso::commands {

ProjectSaver::ProjectSaver(QObject* parent)
    : QObject(parent),
      worker_(
          [this](Job& job) {
              core::ThreadPool pool;
              project::save_project(job.path.toStdString(),
                                    {std::move(job.painting), job.record.recording()}, pool);
              end(job.path, {});
          },
          [this](Job& job, const std::string& fault) { end(job.path, QString::fromStdString(fault)); }) {
}

ProjectSaver::~ProjectSaver() {
    wait();
}

QString ProjectSaver::wait() {
    worker_.wait();
    return error_;
}

void ProjectSaver::save(document::PaintingState painting, document::Recorder record,
                        const QString& path) {
    wait();
    worker_.add({std::move(painting), std::move(record), path});
}

void ProjectSaver::end(const QString& path, const QString& error) {
    error_ = error;
    Q_EMIT finished(path, error);
}

}  // namespace pastoso::commands
