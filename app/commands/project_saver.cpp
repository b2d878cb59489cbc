#include "commands/project_saver.hpp"

#include "core/thread_pool.hpp"

#include <exception>
#include <utility>

namespace pastoso::commands {

ProjectSaver::~ProjectSaver() {
    wait();
}

QString ProjectSaver::wait() {
    if (thread_.joinable()) thread_.join();
    return error_;
}

void ProjectSaver::save(project::Project project, const QString& path) {
    wait();
    thread_ = std::thread([this, project = std::move(project), path] {
        error_.clear();
        try {
            core::ThreadPool pool;
            project::save_project(path.toStdString(), project, pool);
        } catch (const std::exception& failure) {
            error_ = QString::fromUtf8(failure.what());
        }
        Q_EMIT finished(path, error_);
    });
}

}  // namespace pastoso::commands
