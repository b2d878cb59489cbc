// Writes a painting to its project file while the painter goes on painting.
#pragma once

#include "project/project.hpp"

#include <thread>

#include <QObject>
#include <QString>

namespace pastoso::commands {

class ProjectSaver : public QObject {
    Q_OBJECT
  public:
    using QObject::QObject;
    ~ProjectSaver() override;

    /// Returns at once; waits first if the painting before is still being written.
    void save(project::Project project, const QString& path);

    /// Until nothing is being written any more. Returns what went wrong with the last painting, empty
    /// when it is in its file.
    QString wait();

  Q_SIGNALS:
    /// `error` is empty when the painting is in its file, else one sentence.
    void finished(const QString& path, const QString& error);

  private:
    std::thread thread_;
    QString error_;  ///< written by the thread, read after it was joined
};

}  // namespace pastoso::commands
