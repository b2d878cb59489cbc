#include "commands/project_saver.hpp"

#include "appearance/shown_message.hpp"
#include "core/thread_pool.hpp"

#include <utility>

namespace pastoso::commands {

ProjectSaver::ProjectSaver(QObject* parent)
    : QObject(parent),
      worker_(
          [this](Job& job) {
              core::ThreadPool pool;
              const std::filesystem::path file = job.path.toStdString();
              project::save_project(file, {std::move(job.painting), job.record.recording()}, pool,
                                    job.replaced);
              end({job.number, job.path, {}, stamp_of(file)});
          },
          [this](Job& job, const core::Message& fault) {
              end({job.number, job.path, appearance::shown_message(fault), std::nullopt});
          }) {}

ProjectSaver::~ProjectSaver() {
    worker_.wait();
}

QString ProjectSaver::wait() {
    worker_.wait();
    return tell();
}

std::uint64_t ProjectSaver::save(document::PaintingState painting, document::Recorder record,
                                 const QString& path, core::Replaced replaced) {
    wait();
    worker_.add({std::move(painting), std::move(record), ++count_, path, replaced});
    return count_;
}

/// Told on the object's thread: by who waits there, or when its events have their turn.
void ProjectSaver::end(SaveOutcome outcome) {
    {
        const std::lock_guard lock(mutex_);
        untold_.push_back(std::move(outcome));
    }
    QMetaObject::invokeMethod(
        this, [this] { tell(); }, Qt::QueuedConnection);
}

QString ProjectSaver::tell() {
    std::vector<SaveOutcome> outcomes;
    {
        const std::lock_guard lock(mutex_);
        outcomes.swap(untold_);
    }
    QString error;
    for (const SaveOutcome& outcome : outcomes) {
        error = outcome.error;
        Q_EMIT finished(outcome);
    }
    return error;
}

}  // namespace pastoso::commands
