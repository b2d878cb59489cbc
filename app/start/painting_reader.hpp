// Reads the pictures of painting files without holding up the window.
#pragma once

#include "core/worker.hpp"

#include <filesystem>

#include <QDateTime>
#include <QImage>
#include <QObject>

namespace pastoso::start {

/// What can be said of a painting's file at a glance.
struct PaintingFile {
    std::filesystem::path path;
    QImage picture{};
    QDateTime saved{};
    QString fault{};   ///< a sentence, why it cannot be opened
    QString reason{};  ///< more of it, where there is more to say
};

/// On any thread.
PaintingFile read_painting_file(const std::filesystem::path& path);

class PaintingReader : public QObject {
    Q_OBJECT
  public:
    explicit PaintingReader(QObject* parent = nullptr);

    /// One after the other; finished() tells of each.
    void read(const std::filesystem::path& path) { worker_.add(path); }

  Q_SIGNALS:
    void finished(const pastoso::start::PaintingFile& file);

  private:
    void tell(const PaintingFile& file);

    core::Worker<std::filesystem::path> worker_;
};

}  // namespace pastoso::start
