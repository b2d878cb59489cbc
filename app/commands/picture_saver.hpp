// Writes the picture of a painting to a file while the painter goes on painting.
#pragma once

#include "document/painting.hpp"
#include "shade/render.hpp"

#include <filesystem>
#include <memory>
#include <thread>

#include <QObject>
#include <QString>

namespace pastoso::commands {

/// Renders `snapshot` and writes it aside, then renames it. The format follows
/// the name's ending. Throws core::InputError when the file cannot be written.
void save_picture(const document::Snapshot& snapshot, const shade::RenderSettings& settings,
                  const std::filesystem::path& path);

/// save_picture() on a thread of its own, one picture at a time.
class PictureSaver : public QObject {
    Q_OBJECT
  public:
    using QObject::QObject;
    ~PictureSaver() override;

    /// Returns at once; waits first if the picture before is still being written.
    void save(std::shared_ptr<const document::Snapshot> snapshot, const shade::RenderSettings& settings,
              const QString& path);

  Q_SIGNALS:
    /// `error` is empty when the picture is in its file, else one sentence.
    void finished(const QString& path, const QString& error);

  private:
    std::thread thread_;
};

}  // namespace pastoso::commands
