// Makes pictures, layers, maps, reliefs, time-lapses and copies of a painting while the painter goes on
// painting.
#pragma once

#include "core/worker.hpp"
#include "document/recorder.hpp"
#include "project/layered_copy.hpp"
#include "recordings/painting_export.hpp"
#include "recordings/timelapse.hpp"

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>

#include <QObject>
#include <QTimer>

namespace pastoso::commands {

struct ExportJob {
    document::PaintingState painting;
    std::optional<document::Recorder> record;  ///< of what a time-lapse shows; otherwise none
    std::variant<recordings::ExportChoice, recordings::TimelapseChoice, project::LayeredCopy> choice;
};

std::filesystem::path path_of(const ExportJob& job);

struct ExportOutcome {
    std::filesystem::path path;
    core::Message error{};  ///< one sentence; empty when the export was written or stopped
    std::variant<recordings::ExportReport, recordings::TimelapseReport, project::LayeredCopyReport>
        report{};  ///< without an error

    files::ExportStatus status() const;
};

/// One export at a time, on a thread that leaves the processors to the painting. All is to be called on
/// the thread of the object.
class Exporter : public QObject {
    Q_OBJECT
  public:
    explicit Exporter(QObject* parent = nullptr);
    /// Stops what is being written.
    ~Exporter() override { stop(); }

    /// Until finished() was told.
    bool busy() const { return busy_; }

    /// Where the export goes that is being written, or was the last.
    const std::filesystem::path& path() const { return path_; }

    /// Returns at once. Not while busy().
    void start(ExportJob job);

    /// As soon as can be; files are as they were before then, but for the frames of a sequence that are
    /// complete. What is all but written may become whole nevertheless.
    void stop() { stopped_ = true; }

  Q_SIGNALS:
    void progressed(double done);  ///< a few times a second, and at its end: 0 to 1
    void finished(const pastoso::commands::ExportOutcome& outcome);

  private:
    ExportOutcome written(ExportJob& job);
    void end(ExportOutcome outcome);

    std::filesystem::path path_;
    bool busy_ = false;
    std::atomic<bool> stopped_ = false;
    std::atomic<double> done_ = 0.0;
    QTimer progress_;
    core::Worker<ExportJob> worker_;
};

}  // namespace pastoso::commands
