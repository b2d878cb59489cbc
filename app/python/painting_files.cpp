#include "python/painting_files.hpp"

#include "core/error.hpp"
#include "core/naming.hpp"
#include "document/history.hpp"
#include "document/player.hpp"
#include "project/project.hpp"
#include "project/repainting.hpp"
#include "python/arrays.hpp"
#include "recordings/canvas_support.hpp"
#include "recordings/picture_export.hpp"
#include "recordings/picture_style.hpp"
#include "recordings/recording_json.hpp"

#include <utility>

namespace pastoso::python {
namespace {

namespace py = pybind11;

void save_picture(const std::filesystem::path& path, PaintingWork& work) {
    const recordings::PictureStyle style = recordings::picture_style({});
    files::check_picture_path(path, style.encoding);
    const document::Snapshot snapshot = work.painting->snapshot();
    shade::RenderSettings settings;
    settings.viewing = style.viewing;
    recordings::export_picture(path, {snapshot.film, snapshot.ground, settings}, style.encoding,
                               *work.pool, [](double) { return true; });
}

}  // namespace

document::Recording recording_of(const std::optional<std::string>& text, const std::string& name,
                                 const std::filesystem::path& folder) {
    if (!text) return recordings::read_recording_json(name);
    document::Recording recording = recordings::recording_from_json(*text, name);
    std::string& image = recording.canvas.support_image;
    if (!image.empty()) image = (folder / image).string();
    return recording;
}

std::unique_ptr<PaintingWork> replayed(document::Recording recording, const std::string& name,
                                       std::shared_ptr<core::ThreadPool> pool,
                                       Interruption& interruption) {
    auto painting =
        core::naming(name, [&] { return recordings::make_painting(recording.canvas, *pool); });
    painting->keep_undo_steps(document::undo_depth(recording));
    document::Player player(*painting, recording, name);
    while (!player.finished() && !interruption.wanted())
        player.play_tick();
    painting->set_history_budget(document::History::kDefaultBudget_bytes);
    project::Project played = project::finished_project(*painting, std::move(recording));
    return std::make_unique<PaintingWork>(std::move(pool), std::move(painting),
                                          document::Recorder(played.strokes));
}

std::unique_ptr<PaintingWork> opened(const std::filesystem::path& path,
                                     std::shared_ptr<core::ThreadPool> pool) {
    const project::LoadedProject project = project::load_project(path, *pool);
    auto work = std::make_unique<PaintingWork>(
        pool, std::make_unique<document::Painting>(project.painting, *pool),
        document::Recorder(project.strokes));
    for (const core::Message& note : project.notes)
        work->notes.push_back(note.text());
    return work;
}

void save(const std::filesystem::path& path, PaintingWork& work) {
    if (project::is_project_path(path))
        project::save_project(path, {work.painting->state(), work.recorder.recording()}, *work.pool);
    else if (path.extension() == ".json")
        recordings::write_recording_json(path, work.recorder.recording());
    else
        save_picture(path, work);
}

document::SharedPicture picture_of(const py::array_t<std::uint8_t, py::array::c_style>& pixels) {
    const bool fits = pixels.ndim() == 3 && (pixels.shape(2) == 3 || pixels.shape(2) == 4);
    if (!fits)
        throw core::InputError(
            "the pixels are %1, but must be (height, width, 3) or (height, width, 4).",
            shape_text({pixels.shape(), pixels.shape() + pixels.ndim()}));
    if (pixels.shape(0) > pigment::kMostPictureSide_px || pixels.shape(1) > pigment::kMostPictureSide_px)
        throw core::InputError("a picture has at most %1 pixels a side.", pigment::kMostPictureSide_px);
    auto picture = std::make_shared<pigment::Picture>();
    picture->height = static_cast<int>(pixels.shape(0));
    picture->width = static_cast<int>(pixels.shape(1));
    const std::uint8_t* from = pixels.data();
    const auto channels = pixels.shape(2);
    const py::ssize_t count = pixels.shape(0) * pixels.shape(1);
    picture->rgba.reserve(static_cast<std::size_t>(4 * count));
    for (py::ssize_t i = 0; i < count; ++i, from += channels)
        picture->rgba.insert(picture->rgba.end(),
                             {from[0], from[1], from[2], channels == 4 ? from[3] : std::uint8_t{255}});
    return picture;
}

}  // namespace pastoso::python
