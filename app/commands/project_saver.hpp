// Writes a painting to its project file while the painter goes on painting.
#pragma once

#include "commands/file_stamp.hpp"
#include "core/output_file.hpp"
#include "core/worker.hpp"
#include "document/recorder.hpp"
#include "project/project.hpp"

#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include <QObject>
#include <QString>

namespace pastoso::commands {

/// What became of one saving.
struct SaveOutcome {
    std::uint64_t number = 0;  ///< that save() gave
    QString path;
    QString error;                   ///< one sentence; empty when the painting is in its file
    std::optional<FileStamp> stamp;  ///< of the file as it was written
};

class ProjectSaver : public QObject {
    Q_OBJECT
  public:
    explicit ProjectSaver(QObject* parent = nullptr);
    /// What is being written becomes whole; nobody is told any more.
    ~ProjectSaver() override;

    /// Returns at once; waits first, as wait() does, if the painting before is still being written. Each
    /// saving has a number of its own.
    std::uint64_t save(document::PaintingState painting, document::Recorder record, const QString& path,
                       core::Replaced = core::Replaced::Writable);

    /// Until nothing is being written any more and finished() was told of all. Returns what went wrong
    /// with the last of which it was told here, empty when nothing did.
    QString wait();

  Q_SIGNALS:
    /// On the object's thread, once for each saving.
    void finished(const pastoso::commands::SaveOutcome& outcome);

  private:
    struct Job {
        document::PaintingState painting;
        document::Recorder record;
        std::uint64_t number;
        QString path;
        core::Replaced replaced;
    };

    void end(SaveOutcome outcome);
    QString tell();

    std::uint64_t count_ = 0;
    std::mutex mutex_;
    std::vector<SaveOutcome> untold_;
    core::Worker<Job> worker_;
};

}  // namespace pastoso::commands
