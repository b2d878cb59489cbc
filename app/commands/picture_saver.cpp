#include "commands/picture_saver.hpp"

#include "core/thread_pool.hpp"
#include "io/image.hpp"

#include <exception>
#include <utility>

namespace pastoso::commands {

void save_picture(const document::Snapshot& snapshot, const shade::Lighting& lighting,
                  const std::filesystem::path& path) {
    io::check_image_path(path);
    core::ThreadPool pool;
    shade::RenderSettings settings;
    settings.lighting = lighting;
    const shade::LinearImage linear =
        shade::render(snapshot.film, snapshot.ground, snapshot.film.shape.cells(), settings, pool);
    const double px_per_mm = 1.0 / snapshot.film.cell_mm;
    if (io::is_linear_format(path)) {
        io::write_image(path, linear, px_per_mm);
    } else {
        io::write_image(path, shade::encode_srgb8(linear), px_per_mm);
    }
}

PictureSaver::~PictureSaver() {
    if (thread_.joinable()) thread_.join();
}

void PictureSaver::save(std::shared_ptr<const document::Snapshot> snapshot,
                        const shade::Lighting& lighting, const QString& path) {
    if (thread_.joinable()) thread_.join();
    thread_ = std::thread([this, snapshot = std::move(snapshot), lighting, path] {
        QString error;
        try {
            save_picture(*snapshot, lighting, path.toStdString());
        } catch (const std::exception& failure) {
            error = QString::fromUtf8(failure.what());
        }
        Q_EMIT finished(path, error);
    });
}

}  // namespace pastoso::commands
