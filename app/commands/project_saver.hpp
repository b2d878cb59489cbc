// Writes a painting to its project file while the painter goes on painting.
#pragma once

#include "core/worker.hpp"
#include "document/recorder.hpp"
#include "project/project.hpp"

#include <QObject>
#include <QString>

namespace pastoso::commands {

class ProjectSaver : public QObject {
    Q_OBJECT
  public:
    explicit ProjectSaver(QObject* parent = nullptr);
    /// What is being written becomes whole.
    ~ProjectSaver() override;

    /// Returns at once; waits first if the painting before is still being written.
    void save(document::PaintingState painting, document::Recorder record, const QString& path);

    /// Until nothing is being written any more. Returns what went wrong with the last painting, empty
    /// when it is in its file.
    QString wait();

  Q_SIGNALS:
    /// `error` is empty when the painting is in its file, else one sentence.
    void finished(const QString& path, const QString& error);

  private:
    struct Job {
        document::PaintingState painting;
        document::Recorder record;
        QString path;
    };

    void end(const QString& path, const QString& error);

    QString error_;  ///< the worker's while it is busy
    core::Worker<Job> worker_;
};

}  // namespace pastoso::commands
