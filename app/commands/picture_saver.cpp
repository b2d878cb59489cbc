#include "commands/picture_saver.hpp"

#include "core/thread_pool.hpp"
#include "io/image.hpp"
#include "io/picture_file.hpp"

#include <exception>
#include <utility>

namespace pastoso::commands {

void save_picture(const document::Snapshot& snapshot, const shade::RenderSettings& settings,
                  const std::filesystem::path& path) {
    io::check_image_path(path);
    core::ThreadPool pool;
    const shade::LinearImage linear =
        shade::render(snapshot.film, snapshot.ground, snapshot.film.shape.cells(), settings, pool);
    io::write_picture(path, linear, {}, settings.scale / snapshot.film.cell_mm);
}

PictureSaver::~PictureSaver() {
    if (thread_.joinable()) thread_.join();
}

void PictureSaver::save(std::shared_ptr<const document::Snapshot> snapshot,
                        const shade::RenderSettings& settings, const QString& path) {
    if (thread_.joinable()) thread_.join();
    thread_ = std::thread([this, snapshot = std::move(snapshot), settings, path] {
        QString error;
        try {
            save_picture(*snapshot, settings, path.toStdString());
        } catch (const std::exception& failure) {
            error = QString::fromUtf8(failure.what());
        }
        Q_EMIT finished(path, error);
    });
}

}  // namespace pastoso::commands
